#pragma once
/// How a film in time moves, for the first guess of its next state.
#include "bearing/state.hpp"

namespace shellback::bearing {

/// How unknowns move, per second: from one stage to the next, for the first guess of a stage.
struct FilmTrend {
  Field p;                    ///< [Pa/s]; empty: not known; 0 where a cell fills or empties
  Field theta;                ///< [1/s], the same
  Field elastic;              ///< [m/s]
  std::array<double, 4> q{};  ///< of the position [m/s], [rad/s]
  /// From the difference of two states over dt [s].
  FilmTrend() = default;
  FilmTrend(const State& from, const State& to, double dt);
};

}  // namespace shellback::bearing
