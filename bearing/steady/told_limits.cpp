#include "bearing/steady/told_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bearing/film/fed_flow.hpp"
#include "bearing/film/friction.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/told_ranges.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

void add_range_warnings(const Solution& s, std::vector<Note>& warnings) {
  const auto [low, high] = std::minmax_element(s.film.columns.T.begin(), s.film.columns.T.end());
  if (s.model.physics.film_energy &&
      *low < coldest_around(s.model.input, *s.model.solids) - kUndershoot) {
    warnings.push_back(note::ColdSpot{*low});
  }
  const Field depth = fluid::nominal_depth(s.film.gap, s.model.supply);
  FilmReach reach{*low, *high, largest(s.film.film.p), depth, s.film.least};
  reach.shear_rate = largest_shear_rate(s.film.film, s.film.shear_gap, s.point.scene.speed);
  reach.p_slope = largest_slope(s.model.domain.grid, s.film.film.p);
  if (s.model.physics.film_energy) reach.T_shell = largest(s.heat.T_shell);
  if (!s.film.layer.empty()) reach.layer_depth = largest(lasting_depth(s.film.layer));
  for (Note& w : range_warnings(s.model, reach)) warnings.push_back(std::move(w));
  const Field& T = s.film.columns.T_mean;
  const double mean = std::accumulate(T.begin(), T.end(), 0.0) / static_cast<double>(T.size());
  add_turbulence(s.model.input, s.point.scene.speed, mean, warnings);
  add_fed_flow(fed_flow(s.point.scene, s.film), warnings);
  const Field stress = friction_of(s.model, s.point, s.film).stress.journal;
  add_sheared_oil(sheared_oil(s.model.domain.grid, s.film.film.p, stress), warnings);
}

/// Share of the damping from the cavitated film from which on K and C are told to be of slow
/// motions alone: they are wrong by several times it at the frequency of a whirl (decision 013)
/// [-].
constexpr double kSlowMotionsAlone = 0.01;

void add_coefficient_warnings(const Coefficients& k, std::vector<Note>& warnings) {
  if (!k.verdict.good()) {
    warnings.push_back(note::NoCoefficients{k.verdict});
  } else if (k.cavitated_share > kSlowMotionsAlone) {
    warnings.push_back(note::CavitatedDamping{k.cavitated_share});
  }
}

/// Where the heat balance is met elsewhere too, the user must know which root this is.
void add_other_roots(const Solution& s, std::vector<Note>& warnings) {
  if (s.heat_roots.size() < 2) return;
  note::OtherRoots all;
  for (const HeatRoot& root : s.heat_roots) {
    all.roots.push_back({root.T, root.stable(), root.T == s.T_film});
  }
  warnings.push_back(std::move(all));
}

void add_slow_sliding(const Solution& s, std::vector<Note>& out) {
  const double speed = std::abs(s.point.scene.speed);
  if (!s.model.contact || speed >= solid::BoundaryFriction::kSliding) return;
  if (!(largest(s.film.p_contact) > 0.0)) return;
  out.push_back(note::HardlySliding{speed, std::tanh(speed / solid::BoundaryFriction::kMicroSlip)});
}

}  // namespace

std::vector<Note> warnings_of(const Solution& s) {
  std::vector<Note> warnings;
  if (s.coefficients) add_coefficient_warnings(*s.coefficients, warnings);
  add_range_warnings(s, warnings);
  add_other_roots(s, warnings);
  add_slow_sliding(s, warnings);
  return warnings;
}

std::vector<LimiterCount> limiters_of(const Solution& s) {
  std::vector<LimiterCount> out;
  const auto add = [&](Limiter what, long count) {
    if (count > 0) out.push_back({what, count});
  };
  add(Limiter::rejected_steps, s.cost.rejected_steps);
  add(Limiter::backflow_nodes, s.heat.backflow_nodes);
  add(Limiter::upwind_columns, s.heat.blended_columns);
  const Field h = fluid::nominal_depth(s.film.gap, s.model.supply);
  for (const LimiterCount& l : contact_limiters(s.model, h)) out.push_back(l);
  const int sides = s.model.domain.grid.half ? 2 : 1;
  add(Limiter::bent_edges, sides * fluid::bent_edges(s.film.gap));
  return out;
}

}  // namespace shellback::bearing
