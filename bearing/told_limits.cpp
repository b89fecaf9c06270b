#include "bearing/told_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/heat_endings.hpp"
#include "bearing/told_ranges.hpp"
#include "bearing/told_temperature.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

void add_range_warnings(const Solution& s, std::vector<std::string>& warnings) {
  const auto [low, high] = std::minmax_element(s.film.columns.T.begin(), s.film.columns.T.end());
  constexpr double kUndershoot = 2.0;  // worth telling [K]
  if (s.model.physics.film_energy && *low < coldest_around(s.model) - kUndershoot) {
    warnings.push_back("the film temperature falls to " + told_temperature(*low) +
                       " at one place, below everything around it: model.film_nodes does not "
                       "resolve it there");
  }
  const FilmReach reach{*low, *high, largest(s.film.film.p), s.film.gap.cell, s.film.least};
  for (std::string& w : range_warnings(s.model, reach)) warnings.push_back(std::move(w));
}

void add_coefficient_warnings(const Coefficients& k, std::vector<std::string>& warnings) {
  constexpr double kTelling = 0.05;  // from here on the share is above the accuracy aimed at [-]
  if (!k.verdict.good()) {
    warnings.push_back("stiffness and damping are not given: " + k.verdict.reason);
  } else if (k.cavitated_share > kTelling) {
    warnings.push_back(fmt::format(
        "{:.0f} % of the damping comes from oil that comes and goes in the cavitated film: K and C "
        "hold for motions much slower than the rotation, and are a rough guide at half its speed",
        100.0 * k.cavitated_share));
  }
}

/// Where the heat balance is met elsewhere too, the user must know which root this is.
void add_other_roots(const Solution& s, std::vector<std::string>& warnings) {
  if (s.heat_roots.size() < 2) return;
  std::string all;
  for (const HeatRoot& root : s.heat_roots) {
    all += fmt::format("{}{:.1f} degC ({}{})", all.empty() ? "" : ", ", root.T - kZeroCelsius,
                       root.stable() ? "stable" : "unstable",
                       root.T == s.T_film ? ", this solution" : "");
  }
  warnings.push_back(fmt::format(
      "the heat balance is met at {} temperatures: {}; given is the lowest stable one, to which "
      "the "
      "bearing comes from cold; once warmer than an unstable one it goes on to the next",
      s.heat_roots.size(), all));
}

}  // namespace

std::vector<std::string> warnings_of(const Solution& s) {
  std::vector<std::string> warnings;
  if (s.coefficients) add_coefficient_warnings(*s.coefficients, warnings);
  add_range_warnings(s, warnings);
  add_other_roots(s, warnings);
  return warnings;
}

std::vector<LimiterCount> limiters_of(const Solution& s) {
  std::vector<LimiterCount> out;
  const auto add = [&](const std::string& what, long count) {
    if (count > 0) out.push_back({what, count});
  };
  add("Newton steps taken back", s.cost.rejected_steps);
  add("film nodes with flow against the rotation", s.heat.backflow_nodes);
  add("film columns with upwind fluxes across the film", s.heat.blended_columns);
  for (LimiterCount& l : contact_limiters(s.model, s.film.gap.cell)) out.push_back(std::move(l));
  return out;
}

}  // namespace shellback::bearing
