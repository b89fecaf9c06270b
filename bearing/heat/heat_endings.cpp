#include "bearing/heat/heat_endings.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "fluid/film_numbers.hpp"
#include "rheology/laws_hold.hpp"

namespace shellback::bearing {

Verdict fields_finite(const Solution& s) {
  for (const auto& found :
       {find_not_a_number(FieldName::film_temperature, s.film.columns.T, s.model.gl.n),
        find_not_a_number(FieldName::thermal_deformation, s.heat.thermal_deformation)}) {
    if (found) return fluid::ended_by(s.model.domain.grid, *found);
  }
  return {};
}

Verdict temperatures_possible(const Solution& s) {
  if (Verdict v = fields_finite(s); !v.good()) return v;
  const auto& T = s.film.columns.T;
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const double T_supply = mean_supply_temperature(s.model.input);
  const auto place = [&](auto node) {
    return fluid::place_of(s.model.domain.grid, static_cast<int>(node - T.begin()) / s.model.gl.n);
  };
  if (!rheology::laws_hold(s.model.oil, *low)) {
    return {Status::iteration_limit, ending::AtTemperature{ending::Thermal::oil_laws, *low},
            place(low)};
  }
  if (*high - T_supply > kHottestRise) {
    return {Status::iteration_limit, ending::FilmTooHot{*high, T_supply}, place(high)};
  }
  return {};
}

namespace {

/// Coldest and warmest temperature given [K].
std::pair<double, double> temperatures_around(const Case& c, const Solids& solids) {
  std::vector<double> all{solids.surroundings()};
  for (const Supply& supply : c.supplies) all.push_back(supply.temperature);
  if (c.shaft && c.shaft->overhang > 0.0) all.push_back(c.shaft->ambient);
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  return {*low, *high};
}

/// Mean thermal widening of the gap with everything at one temperature [m].
double widening_at(double T, const Solids& solids, const FilmGrid& grid) {
  return area_mean(grid, solids.at(solids.uniform_state(T)).thermal_deformation);
}

bool closes(const Case& c, double widening) { return widening <= -c.bearing.radial_clearance; }

}  // namespace

double coldest_around(const Case& c, const Solids& solids) {
  return temperatures_around(c, solids).first;
}

std::optional<ending::NoClearance> closed_at_rest(const Case& c, const Solids& solids,
                                                  const FilmGrid& grid) {
  using At = ending::NoClearance::At;
  const auto [low, high] = temperatures_around(c, solids);
  for (const auto& [at, T] : {std::pair{At::coldest, low}, std::pair{At::warmest, high}}) {
    const double widening = widening_at(T, solids, grid);
    if (closes(c, widening)) {
      return ending::NoClearance{widening, c.bearing.radial_clearance, at, T};
    }
  }
  return std::nullopt;
}

bool closed_at_any_rest(const Case& c, const Solids& solids, const FilmGrid& grid) {
  const auto [low, high] = temperatures_around(c, solids);
  return closes(c, widening_at(low, solids, grid)) && closes(c, widening_at(high, solids, grid));
}

Verdict colder_than_all_around(const Solution& s) {
  constexpr double kRipple = 0.5;  // of the rise: beyond it is no ripple of the polynomials [-]
  const auto& T = s.film.columns.T;
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const double coldest = coldest_around(s.model.input, *s.model.solids);
  if (*low >= coldest - kUndershoot - kRipple * (*high - coldest)) return {};
  return {Status::iteration_limit, ending::AtTemperature{ending::Thermal::too_cold, *low},
          fluid::place_of(s.model.domain.grid, static_cast<int>(low - T.begin()) / s.model.gl.n)};
}

Verdict walls_unbalanced(double change) {
  if (change < kWallsOff) return {};
  return {Status::iteration_limit, ending::Unsettled{ending::Iteration::walls, 0, change}};
}

}  // namespace shellback::bearing
