#pragma once
/// What a stage of a step in time finds (film_step.hpp).
#include <array>

#include "bearing/film/equilibrium.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "core/tableau.hpp"

namespace shellback::bearing {

/// to + f k
inline void add(double f, const Field& k, Field& to) {
  for (std::size_t c = 0; c < to.size(); ++c) to[c] += f * k[c];
}

/// Slopes of one stage.
struct FilmStage {
  Field oil;                             ///< [kg/(m2 s)]
  std::array<double, 2> velocity{};      ///< [m/s]
  std::array<double, 2> acceleration{};  ///< [m/s2]
  fluid::OilFlows flows;                 ///< [kg/s]
  std::array<double, 2> force{};         ///< of the film [N]
  double off_balance = 0.0;              ///< [N]
  HeatStage heat;
  LayerInTime layer;
};

}  // namespace shellback::bearing
