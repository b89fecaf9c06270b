#include "bearing/told_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/told_temperature.hpp"

namespace shellback::bearing {
namespace {

/// Cells in which the contact law is asked for more than it was made for.
long cells_beyond_law(const BearingModel& m, const Field& h) {
  if (!m.contact) return 0;
  return std::count_if(h.begin(), h.end(),
                       [least = m.contact->least_gap()](double x) { return x < least; });
}

long cells_that_flow(const Field& flow) {
  return std::count_if(flow.begin(), flow.end(), [](double x) { return x > 0.0; });
}

}  // namespace

Field summit_flow(const BearingModel& m, const Field& h) {
  if (!m.contact || !std::isfinite(m.contact->flow_gap())) return {};
  Field flow = h;
  for (std::size_t k = 0; k < flow.size(); ++k) {
    const bool supplied = m.scene.supply.cell[k] >= 0;
    flow[k] = supplied ? 0.0 : std::max(0.0, m.contact->flow_gap() - h[k]);
  }
  return flow;
}

namespace {

/// Cells whose gap is smaller than the first of a measured table of flow factors.
void add_factors(const BearingModel& m, const Field& h, std::vector<std::string>& out) {
  if (m.scene.rough.beyond_table) {
    out.emplace_back(
        "a roughness orientation lies outside the range 1/9 to 9 of the tabulated "
        "flow factors: the end of the table is used");
  }
  const auto& measured = m.scene.rough.measured;
  if (!measured) return;
  const double first = measured->H_low * measured->sigma;
  const long cells = std::count_if(h.begin(), h.end(), [first](double x) { return x < first; });
  if (cells == 0) return;
  out.push_back(fmt::format(
      "in {} cells of the solved part the gap is below {:.3g} um, the smallest of the measured "
      "flow factors (h/sigma = {:.3g}): they are continued there",
      cells, 1e6 * first, measured->H_low));
}

void add_temperatures(const BearingModel& m, const FilmReach& reach,
                      std::vector<std::string>& out) {
  const auto& range = m.oil.range;
  if (!(reach.T_low < range.T_min) && !(reach.T_high > range.T_max)) return;
  const std::string from =
      std::isnan(reach.T_low) ? "up" : told_temperature(reach.T_low);  // to the highest
  out.push_back("film temperatures of " + from + " to " + told_temperature(reach.T_high) +
                " leave the oil's range of " + told_temperature(range.T_min) + " to " +
                told_temperature(range.T_max) + ": its viscosity is extrapolated");
}

void add_contact(const BearingModel& m, const FilmReach& reach, std::vector<std::string>& out) {
  const Field& h = reach.h;
  const fluid::SmallestGap& least = reach.least;
  if (const long cells = cells_beyond_law(m, h); cells > 0) {
    out.push_back(fmt::format(
        "the surfaces interpenetrate by up to {:.3g} um (at {}), {:.0f} times their summit "
        "roughness, in {} cells of the solved part: beyond {:.3g} um the whole surface would be in "
        "contact, and the contact law no longer describes it: contact pressure, friction and film "
        "are no prediction there",
        -least.h * 1e6, fluid::place_of(least), -least.h / m.contact->sigma(), cells,
        -m.contact->least_gap() * 1e6));
  }
  const Field flow = summit_flow(m, h);
  if (const long cells = cells_that_flow(flow); cells > 0) {
    const auto deepest = std::max_element(flow.begin(), flow.end());
    out.push_back(fmt::format(
        "the contact pressure is held at the hardness of {:.4g} MPa in {} cells of the solved "
        "part: summits flow there by up to {:.3g} um (at {})",
        m.contact->hardness() * 1e-6, cells, *deepest * 1e6,
        fluid::place_of(m.scene.grid, static_cast<int>(deepest - flow.begin()))));
  }
}

}  // namespace

std::vector<std::string> range_warnings(const BearingModel& m, const FilmReach& reach) {
  std::vector<std::string> out;
  add_temperatures(m, reach, out);
  add_factors(m, reach.h, out);
  if (reach.p_max > m.oil.range.p_max) {
    out.emplace_back("film pressures leave the range in which the oil's pressure law is known");
  }
  add_contact(m, reach, out);
  return out;
}

std::vector<LimiterCount> contact_limiters(const BearingModel& m, const Field& h) {
  std::vector<LimiterCount> out;
  const auto add = [&](const char* what, long count) {
    if (count > 0) out.push_back({what, count});
  };
  add("cells whose contact pressure is held at the hardness", cells_that_flow(summit_flow(m, h)));
  add("cells pressed beyond the range of the contact law", cells_beyond_law(m, h));
  return out;
}

}  // namespace shellback::bearing
