#include "fidelity/grid_error.hpp"

#include <algorithm>
#include <cmath>

#include "fidelity/coarse_solution.hpp"

namespace shellback::fidelity {
namespace {

/// (h3^p - h2^p)/(h2^p - h1^p), h3 > h2 > h1: rises with p.
double change_ratio(double h1, double h2, double h3, double p) {
  const double a = std::pow(h1, p);
  const double b = std::pow(h2, p);
  return (std::pow(h3, p) - b) / (b - a);
}

constexpr double kSafety = 1.5;        ///< of (4) [-]
constexpr double kFineCell = 0.01414;  ///< of 200 x 25 cells [-]
double safety(double h) { return kSafety * std::sqrt(std::max(1.0, h / kFineCell)); }

}  // namespace

double observed_order(const std::vector<GridValue>& v) {
  if (v.size() < 3) return NAN;
  const auto& f3 = v[v.size() - 3];
  const auto& f2 = v[v.size() - 2];
  const auto& f1 = v[v.size() - 1];
  const double before = f3.value - f2.value;
  const double last = f2.value - f1.value;
  if (before == 0.0 && last == 0.0) return kMostOrder;
  const double ratio = last == 0.0 ? INFINITY : before / last;
  if (!(ratio >= change_ratio(f1.h, f2.h, f3.h, 0.5))) return NAN;
  double low = kLeastOrder;
  double high = kMostOrder;
  if (ratio <= change_ratio(f1.h, f2.h, f3.h, low)) return low;
  if (ratio >= change_ratio(f1.h, f2.h, f3.h, high)) return high;
  for (int k = 0; k < 40; ++k) {
    const double p = 0.5 * (low + high);
    (change_ratio(f1.h, f2.h, f3.h, p) < ratio ? low : high) = p;
  }
  return 0.5 * (low + high);
}

GridBar grid_bar(const std::vector<GridValue>& v) {
  if (v.size() < 2) return {NAN, NAN};
  const auto& f1 = v[v.size() - 1];
  const auto& f2 = v[v.size() - 2];
  double change = std::abs(f2.value - f1.value);
  if (v.size() > 2) {
    const auto& f3 = v[v.size() - 3];
    const double before = std::abs(f3.value - f2.value);
    change = std::max(change, before / change_ratio(f1.h, f2.h, f3.h, kMostOrder));
  }
  const double p = observed_order(v);
  const double order = std::isfinite(p) ? p : kLeastOrder;
  return {safety(f1.h) * change / (std::pow(f2.h / f1.h, order) - 1.0) + f1.noise, p};
}

GridBar grid_bar_below(const GridValue& own, const GridValue& finer) {
  const double left = 1.0 - std::pow(finer.h / own.h, kLeastOrder);
  return {safety(own.h) * std::abs(own.value - finer.value) / left + own.noise, NAN};
}

bool given_by_case(const coupling::Case& c, coupling::Tier tier, const std::string& name) {
  const bool position = std::holds_alternative<coupling::EccentricityGiven>(c.operation.position);
  if (name == "eccentricity_ratio") return position;
  if (name == "load_x" || name == "load_y") return !position;
  if (name == "tilt_x" || name == "tilt_y") {
    return std::holds_alternative<coupling::TiltGiven>(c.operation.alignment);
  }
  const bool temperature = name == "T_equivalent" || name == "T_film_mean";
  return temperature && tier == coupling::Tier::isothermal;
}

double natural_size(const coupling::Quantity& q, double T_supply,
                    const std::vector<coupling::Quantity>& all) {
  constexpr double kLeastRise = 1.0;   // [K]
  constexpr double kLeastAngle = 5.0;  // [deg]
  const auto length = [&](const char* a, const char* b) {
    return std::hypot(value_in(all, a), value_in(all, b));
  };
  if (q.unit == "K") return std::max(std::abs(q.value - T_supply), kLeastRise);
  if (q.unit == "deg") return std::max(std::abs(q.value), kLeastAngle);
  if (q.name == "load_x" || q.name == "load_y") return length("load_x", "load_y");
  if (q.name == "tilt_x" || q.name == "tilt_y") return length("tilt_x", "tilt_y");
  if (q.name.rfind("heat_", 0) == 0) return std::abs(value_in(all, "power_loss"));
  return std::abs(q.value);
}

}  // namespace shellback::fidelity
