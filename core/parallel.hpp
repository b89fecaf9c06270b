#pragma once
/// Independent tasks on several threads.
#include <functional>

namespace shellback {

/// Calls task(0) ... task(count - 1), each once, in this order of starting, on at most `threads`
/// threads (1: on the caller's). Returns when all are done. A task that throws lets the others that
/// have begun finish; then the first exception is thrown on. Tasks must not share what they change.
void parallel_for(int count, int threads, const std::function<void(int)>& task);

/// Threads that this machine runs at once, at least 1.
[[nodiscard]] int hardware_threads();

}  // namespace shellback
