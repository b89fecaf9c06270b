#include "bearing/told_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/heat_endings.hpp"
#include "bearing/told_temperature.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Cells whose gap is smaller than the first of a measured table of flow factors.
void add_factor_warning(const Solution& s, std::vector<std::string>& warnings) {
  const auto& measured = s.model.scene.rough.measured;
  if (!measured) return;
  const double first = measured->H_low * measured->sigma;
  const auto& h = s.film.gap.cell;
  const long cells = std::count_if(h.begin(), h.end(), [first](double x) { return x < first; });
  if (cells == 0) return;
  warnings.push_back(fmt::format(
      "in {} cells of the solved part the gap is below {:.3g} um, the smallest of the measured "
      "flow factors (h/sigma = {:.3g}): they are continued there",
      cells, 1e6 * first, measured->H_low));
}

void add_range_warnings(const Solution& s, std::vector<std::string>& warnings) {
  const auto& range = s.model.oil.range;
  const auto [low, high] = std::minmax_element(s.film.columns.T.begin(), s.film.columns.T.end());
  if (*low < range.T_min || *high > range.T_max) {
    warnings.push_back("film temperatures of " + told_temperature(*low) + " to " +
                       told_temperature(*high) + " leave the oil's range of " +
                       told_temperature(range.T_min) + " to " + told_temperature(range.T_max) +
                       ": its viscosity is extrapolated");
  }
  constexpr double kUndershoot = 2.0;  // worth telling [K]
  if (s.model.physics.film_energy && *low < coldest_around(s.model) - kUndershoot) {
    warnings.push_back("the film temperature falls to " + told_temperature(*low) +
                       " at one place, below everything around it: model.film_nodes does not "
                       "resolve it there");
  }
  if (s.model.scene.rough.beyond_table) {
    warnings.push_back(
        "a roughness orientation lies outside the range 1/9 to 9 of the tabulated "
        "flow factors: the end of the table is used");
  }
  add_factor_warning(s, warnings);
  if (largest(s.film.film.p) > range.p_max) {
    warnings.push_back("film pressures leave the range in which the oil's pressure law is known");
  }
}

/// Cells in which the contact law is asked for more than it was made for.
long cells_beyond_contact_law(const Solution& s) {
  if (!s.model.contact) return 0;
  const auto& h = s.film.gap.cell;
  return std::count_if(h.begin(), h.end(),
                       [least = s.model.contact->least_gap()](double x) { return x < least; });
}

void add_contact_warning(const Solution& s, std::vector<std::string>& warnings) {
  const long cells = cells_beyond_contact_law(s);
  if (cells == 0) return;
  warnings.push_back(fmt::format(
      "the surfaces interpenetrate by up to {:.3g} um (at {}), {:.0f} times their summit "
      "roughness, in "
      "{} cells of the solved part: beyond {:.3g} um the whole surface would be in contact, and "
      "the "
      "contact law no longer describes it: contact pressure, friction and film are no prediction "
      "there",
      -s.film.least.h * 1e6, fluid::place_of(s.film.least),
      -s.film.least.h / s.model.contact->sigma(), cells, -s.model.contact->least_gap() * 1e6));
}

/// Where the contact pressure is held at the hardness: how much, and how deep summits have flowed.
void add_flow_warning(const Solution& s, std::vector<std::string>& warnings) {
  const Field flow = summit_flow(s);
  const long cells = std::count_if(flow.begin(), flow.end(), [](double x) { return x > 0.0; });
  if (cells == 0) return;
  const auto deepest = std::max_element(flow.begin(), flow.end());
  warnings.push_back(fmt::format(
      "the contact pressure is held at the hardness of {:.4g} MPa in {} cells of the solved part: "
      "summits flow there by up to {:.3g} um (at {})",
      s.model.contact->hardness() * 1e-6, cells, *deepest * 1e6,
      fluid::place_of(s.model.scene.grid, static_cast<int>(deepest - flow.begin()))));
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

Field summit_flow(const Solution& s) {
  if (!s.model.contact || !std::isfinite(s.model.contact->flow_gap())) return {};
  Field flow = s.film.gap.cell;
  for (std::size_t k = 0; k < flow.size(); ++k) {
    const bool supplied = s.model.scene.supply.cell[k] >= 0;
    flow[k] = supplied ? 0.0 : std::max(0.0, s.model.contact->flow_gap() - flow[k]);
  }
  return flow;
}

std::vector<std::string> warnings_of(const Solution& s) {
  std::vector<std::string> warnings;
  if (s.coefficients) add_coefficient_warnings(*s.coefficients, warnings);
  add_range_warnings(s, warnings);
  add_contact_warning(s, warnings);
  add_flow_warning(s, warnings);
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
  const Field flow = summit_flow(s);
  add("cells whose contact pressure is held at the hardness",
      std::count_if(flow.begin(), flow.end(), [](double x) { return x > 0.0; }));
  add("cells pressed beyond the range of the contact law", cells_beyond_contact_law(s));
  return out;
}

}  // namespace shellback::bearing
