#include "coupling/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::coupling {

double coldest_given(const Case& c) {
  double T = INFINITY;
  for (const Supply& s : c.supplies) T = std::min(T, s.temperature);
  if (c.oil_temperature) T = std::min(T, *c.oil_temperature);
  if (c.measured.shell_back_temperature) T = std::min(T, *c.measured.shell_back_temperature);
  if (c.shell) {
    const auto* back = std::get_if<ConvectiveBack>(&c.shell->back);
    T = std::min(
        T, back != nullptr ? back->ambient : std::get<PrescribedBack>(c.shell->back).temperature);
  }
  if (c.shaft && c.shaft->overhang > 0.0) T = std::min(T, c.shaft->ambient);
  return T;
}

double temperature_ripple(double span) {
  constexpr double kLeast = 5.0;  // next to grooves, where oil of two temperatures meets [K]
  constexpr double kShare = 0.1;  // of the span [-]
  return std::max(kLeast, kShare * span);
}

Verdict plausible(const Solution& s) {
  if (!s.model.physics.film_energy || s.film.columns.T.empty()) return {};
  const double coldest = coldest_given(s.model.input);
  const auto& T = s.film.columns.T;
  const auto [least, most] = std::minmax_element(T.begin(), T.end());
  if (*least >= coldest - temperature_ripple(*most - coldest)) return {};
  const auto cell = static_cast<int>((least - T.begin()) / s.model.gl.n);
  return {
      Status::iteration_limit,
      fmt::format("the film temperature falls to {:.0f} degC, below all temperatures given "
                  "({:.0f} degC): the grid does not resolve the heat that the oil carries there",
                  *least - kZeroCelsius, coldest - kZeroCelsius),
      fluid::place_of(s.model.scene.grid, cell),
      "take a finer grid, a shallower profile, or tier isothermal or lumped"};
}

}  // namespace shellback::coupling
