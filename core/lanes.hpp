#pragma once
/// Doubles by the register: what is written in lanes stays in registers.
///
/// Loops over single doubles the compiler (GCC 12) often leaves scalar, or turns into code that
/// takes up to twenty times as long. A lane is a vector of GCC and Clang: +, -, *, / and
/// comparisons act on each of its numbers, `mask ? a : b` chooses for each. It is as wide as the
/// registers that are compiled for: wider ones GCC takes apart at ten times the cost. Lanes go by
/// reference: how they are passed otherwise depends on the machine.
#include <cmath>

namespace shellback {

inline constexpr int kRegister = 8;  ///< doubles in a 512-bit register: lines are padded to it
#if defined(__AVX512F__)
inline constexpr int kLane = 8;  ///< doubles in a lane
#elif defined(__AVX__)
inline constexpr int kLane = 4;
#else
inline constexpr int kLane = 2;
#endif

using Lane
    [[gnu::vector_size(kLane * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
        double;

[[nodiscard]] inline Lane* lanes(double* x) { return reinterpret_cast<Lane*>(x); }
[[nodiscard]] inline const Lane* lanes(const double* x) { return reinterpret_cast<const Lane*>(x); }

/// |x|.
inline void take_magnitude(Lane& x) { x = x < 0.0 ? -x : x; }

inline void take_root(Lane& x) {
  for (int i = 0; i < kLane; ++i) x[i] = std::sqrt(x[i]);
}

/// The larger of both; what is no number wins (core/largest.hpp).
inline void take_larger(Lane& x, const Lane& other) {
  x = ((other > x) | (other != other)) ? other : x;
}

}  // namespace shellback
