#include "fidelity/quantities.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

std::vector<Quantity> change(const std::vector<Quantity>& from, const std::vector<Quantity>& to) {
  std::vector<Quantity> list;
  for (const Quantity& q : from) {
    list.push_back({q.name, value_in(to, q.name) - q.value, q.unit, NAN, NAN});
  }
  return list;
}

bool given_by_case(const bearing::Case& c, bearing::Tier tier, const std::string& name) {
  const bool position = std::holds_alternative<bearing::EccentricityGiven>(c.operation.position);
  if (name == "eccentricity_ratio") return position;
  if (name == "load_x" || name == "load_y") return !position;
  if (name == "tilt_x" || name == "tilt_y") {
    return std::holds_alternative<bearing::TiltGiven>(c.operation.alignment);
  }
  if (name == "moment_x" || name == "moment_y") {
    return std::holds_alternative<bearing::MomentGiven>(c.operation.alignment);
  }
  const bool temperature = name == "T_equivalent" || name == "T_film_mean" || name == "T_film_max";
  return temperature && tier == bearing::Tier::isothermal;
}

bool is_of_heat(const std::string& name) {
  return name.starts_with("T_") || name.starts_with("heat");
}

bool is_part_of_friction(const std::string& name) {
  return name.starts_with("friction_torque_") && name != "friction_torque_shell";
}

bool one_sign(const Quantity& q) {
  const auto units = {"N m", "m", "Pa", "1", "m3/s"};
  return q.name != "thermal_opening_mean" &&
         std::any_of(units.begin(), units.end(), [&](const char* u) { return q.unit == u; });
}

bool is_coefficient(const Quantity& q) {
  return q.name.size() == 4 && (q.name.starts_with("K_") || q.name.starts_with("C_"));
}

bool is_of_motion(const Quantity& q) { return is_coefficient(q) || q.name.starts_with("whirl_"); }

double natural_size(const Quantity& q, double T_supply, const std::vector<Quantity>& all) {
  const auto length = [&](const std::string& vector) {
    return std::hypot(value_in(all, vector + "_x"), value_in(all, vector + "_y"));
  };
  if (q.unit == "K") return std::max(std::abs(q.value - T_supply), 1.0);
  if (q.unit == "deg") return std::max(std::abs(q.value), 5.0);
  if (q.name == "load_x" || q.name == "load_y") return length("load");
  if (q.name == "tilt_x" || q.name == "tilt_y") return length("tilt");
  if (q.name == "moment_x" || q.name == "moment_y") return length("moment");
  if (q.name.starts_with("heat_")) return std::abs(value_in(all, "power_loss"));
  if (is_coefficient(q)) {
    // What an entry is worth beside the others: those of its row and its column, and its mirror.
    const std::string matrix = q.name.substr(0, 2);
    const auto entry = [&](char i, char j) {
      return std::abs(value_in(all, matrix + std::string{i, j}));
    };
    const char i = q.name[2], j = q.name[3], other = i == 'x' ? 'y' : 'x';
    const double mirror = i == j ? entry(i, other) * entry(other, i) : entry(i, j) * entry(j, i);
    return std::sqrt(entry(i, i) * entry(j, j) + mirror);
  }
  return q.size();
}

bool is_round_off(const bearing::Case& c, const Quantity& q, const std::vector<Quantity>& all) {
  // From a shaft that ends at the bearing's edges no heat leaves but to the film.
  if (q.name == "heat_to_shaft" && c.shaft && c.shaft->overhang == 0.0) return true;
  const bearing::Bearing& b = c.bearing;
  const double shear =
      std::abs(value_in(all, "friction_torque")) / (2.0 * kPi * b.radius * b.radius * b.width);
  const double pressure = shear * b.radius / b.radial_clearance;
  const double force = 2.0 * b.radius * b.width * pressure;
  const double load = std::hypot(value_in(all, "load_x"), value_in(all, "load_y"));
  const bool of_load = q.unit == "N" || q.name == "attitude_angle";
  const bool of_moment = q.name == "moment_x" || q.name == "moment_y";
  if (of_load) return load < kRoundOff * force;
  const double size = std::abs(q.value);
  if (of_moment) return size < kRoundOff * force * b.width;
  if (q.unit == "Pa") return size < kRoundOff * pressure;
  const double flow = std::abs(c.operation.omega) * b.radius * b.width * b.radial_clearance;
  if (q.unit == "m3/s") return size < kRoundOff * flow;
  return q.name == "pump_power" && size < kRoundOff * std::abs(value_in(all, "power_loss"));
}

Range bounds_of(const bearing::Case& c, const std::string& name) {
  if (name == "asperity_load_share") return {0.0, 1.0};
  if (name == "p_asperity_max" && c.surfaces.contact && hardness_of_contact(c) > 0.0)
    return {0.0, hardness_of_contact(c)};
  if (c.surfaces.contact && c.surfaces.contact->friction_law) {
    const solid::GenericFriction& law = *c.surfaces.contact->friction_law;
    if (name == "mu_abrasive") return {0.0, law.abrasive};
    if (name == "mu_adhesive") return {0.0, law.adhesive};
  }
  return kAnyValue;
}

namespace {

void bound_parts(const std::string& whole, const std::vector<std::string>& parts,
                 const std::vector<Quantity*>& list) {
  const auto all =
      std::find_if(list.begin(), list.end(), [&](const Quantity* q) { return q->name == whole; });
  if (all == list.end()) return;
  for (Quantity* q : list) {
    if (std::find(parts.begin(), parts.end(), q->name) == parts.end()) continue;
    const double size = q->size();
    for (double Quantity::*bar :
         {&Quantity::error_grid, &Quantity::error_time, &Quantity::error_model}) {
      const double most = std::max((*all)->size() + (*all)->*bar - size, size);
      if (q->*bar > most) q->*bar = most;
    }
  }
}

}  // namespace

void bound_parts_of_friction(const std::vector<Quantity*>& list) {
  bound_parts("friction_torque", {"friction_torque_asperity"}, list);
  bound_parts("friction_torque_asperity",
              {"friction_torque_abrasive", "friction_torque_adhesive",
               "friction_torque_micro_hydrodynamic"},
              list);
}

double furthest(const bearing::Case& c, const Quantity& q) {
  const Range bounds = bounds_of(c, q.name);
  return std::max({q.value - bounds.low, bounds.high - q.value, 0.0});
}

}  // namespace shellback::fidelity
