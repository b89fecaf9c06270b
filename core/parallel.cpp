#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace shellback {

int hardware_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(int count, int threads, const std::function<void(int)>& task) {
  std::atomic<int> next{0};
  std::exception_ptr first;
  std::mutex guard;
  const auto work = [&] {
    for (int k = next++; k < count; k = next++) {
      try {
        task(k);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!first) first = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> crew;
  try {
    for (int t = 1; t < std::min(threads, count); ++t) crew.emplace_back(work);
  } catch (const std::system_error&) {  // no more to be had: those that are there do the work
  }
  work();
  for (std::thread& member : crew) member.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace shellback
