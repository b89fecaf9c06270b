#pragma once
/// Random numbers of our own mapping: the same on every platform.
#include <cstdint>
#include <random>

namespace shellback::validation {

/// Numbers from a seed.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1), 53 bits.
  [[nodiscard]] double unit();
  [[nodiscard]] double between(double low, double high);
  /// Even in the logarithm; both positive.
  [[nodiscard]] double log_between(double low, double high);
  [[nodiscard]] bool chance(double probability);
  /// 0 .. count - 1.
  [[nodiscard]] int index(int count);

 private:
  std::mt19937_64 engine_;
};

}  // namespace shellback::validation
