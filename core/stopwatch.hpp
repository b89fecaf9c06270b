#pragma once
/// How long something took.
#include <chrono>

namespace shellback {

class Stopwatch {
 public:
  /// Since it was made [s].
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace shellback
