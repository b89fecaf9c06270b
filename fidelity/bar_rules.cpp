#include "fidelity/bar_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "fidelity/light_contact.hpp"

namespace shellback::fidelity {

using namespace bearing;

void share_bars_of_coefficients(const Judged& judged) {
  double longest = 0.0;
  for (const auto& [q, size] : judged) {
    const double bar = q->error_grid / size;
    if (is_coefficient(*q) && std::isfinite(bar)) longest = std::max(longest, bar);
  }
  for (const auto& [q, size] : judged) {
    if (!is_of_motion(*q)) continue;
    if (std::isfinite(q->error_grid)) q->error_grid = std::max(q->error_grid, longest * size);
  }
}

void share_bars_of_place_and_flow(const Case& c, Result& result) {
  constexpr double kOfFlow = 0.5;
  const auto known = [&](const char* name) { return quantity_in(result.quantities, name); };
  const auto bar = [&](const char* name) {
    const Quantity* q = known(name);
    return q != nullptr && std::isfinite(q->error_grid) ? q->error_grid : 0.0;
  };
  const auto relative = [&](const char* name) {
    const Quantity* q = known(name);
    return q != nullptr && q->value != 0.0 ? std::min(bar(name) / std::abs(q->value), 1.0) : 0.0;
  };
  const double place = relative("eccentricity_ratio") * 180.0 / kPi;  // [deg]
  const Quantity* film = known("T_film_mean");
  const double rise = film ? std::abs(film->value - mean_supply_temperature(c)) : 0.0;
  const double mixed = kOfFlow * relative("side_flow") * rise;
  const double opening = c.shaft ? c.shaft->material.expansion * c.bearing.radius *
                                       std::max(bar("T_shaft"), bar("T_shell_back"))
                                 : 0.0;
  for (Quantity& q : result.quantities) {
    const double least = q.name == "attitude_angle"         ? place
                         : q.name == "T_supply_mixed"       ? mixed
                         : q.name == "thermal_opening_mean" ? opening
                                                            : 0.0;
    if (q.error_grid > 0.0 && q.error_grid < least) q.error_grid = least;
  }
}

void widen_bars_of_light_contact(const BearingModel& m, Result& result) {
  const Quantity* h = quantity_in(result.quantities, "h_min");
  const double share = result.value("asperity_load_share");
  if (!m.contact || !(share < kLight) || !std::isfinite(h->error_grid)) return;
  const double now = m.contact->at(h->value).p;
  const double open = now + left_open_by_film(*m.contact, h->value, h->error_grid);
  // Shares of the load: as much more as the pressure; where that is nothing, at most all over.
  const Bearing& b = m.input.bearing;
  const double load = std::hypot(result.value("load_x"), result.value("load_y"));
  const double more = now > 0.0 && share > 0.0 ? share * (open / now - 1.0)
                                               : 2.0 * b.radius * b.width * open / load;
  const double shares = std::min(more, 1.0);
  const Quantity* torque = quantity_in(result.quantities, "friction_torque");
  const double whole = std::abs(torque->value) + torque->error_grid;
  for (Quantity& q : result.quantities) {
    double bar = 0.0;
    if (q.name == "p_asperity_max") bar = open - now;
    if (q.name == "asperity_load_share") bar = shares;
    if (q.name == "friction_torque_asperity")
      bar = std::min(m.contact->friction().at_rest() * shares * load * b.radius, whole);
    if (bar > q.error_grid) q.error_grid = bar;
  }
}

bool layer_may_have_flowed(const Case& c, const Quantity& depth, const Quantity& p_max) {
  if (!c.shell || c.shell->layers.empty() || !c.shell->layers.front().elasto_plastic) return false;
  const double hardness = c.shell->layers.front().material.hardness;
  return depth.value == 0.0 && p_max.value + p_max.error_grid > hardness;
}

void open_bar_of_layer(const Case& c, Result& result) {
  const auto depth = std::find_if(result.quantities.begin(), result.quantities.end(),
                                  [](const Quantity& q) { return q.name == "layer_depth"; });
  if (depth == result.quantities.end()) return;
  if (layer_may_have_flowed(c, *depth, *quantity_in(result.quantities, "p_max"))) {
    depth->error_grid = std::numeric_limits<double>::quiet_NaN();
  }
}

void bound_bars(const Case& c, Result& result) {
  std::vector<Quantity*> list;
  for (Quantity& q : result.quantities) {
    const double most = furthest(c, q);
    if (q.error_grid > most) q.error_grid = most;
    if (q.error_model > most) q.error_model = most;
    list.push_back(&q);
  }
  bound_parts_of_friction(list);
}

}  // namespace shellback::fidelity
