#include "bearing/steady/branch_endings.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/temperature_limits.hpp"
#include "core/largest.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

ending::Carried carried(const Solution& s, Raised raised, double part) {
  double whole = raised == Raised::speed ? std::abs(s.point.omega()) : s.point.load.scale();
  if (raised == Raised::supply) {
    whole = 0.0;
    for (const auto& patch : s.point.scene.supply.patches) whole = larger(whole, patch.pressure);
  }
  return {raised, part, whole};
}

bool ended_by_cells(const Solution& s, const Branch& b) {
  return b.end == BranchEnd::molecule && !closing_is_resolved(s.model, s.film);
}

}  // namespace

bool shows_none_beyond(const Solution& s, const Branch& b) {
  return b.end != BranchEnd::lost && !ended_by_cells(s, b);
}

Verdict branch_ended(const Solution& s, const Branch& b) {
  const bool lost = b.end == BranchEnd::lost;
  const bool heat = s.model.physics.film_energy;
  const double T_high = heat ? largest(s.film.columns.T) : NAN;
  Verdict v{lost ? Status::iteration_limit : Status::no_steady_state,
            ending::BranchEnded{b.end, carried(s, b.raised, b.carried), b.h_min, heat, T_high,
                                ended_by_cells(s, b)},
            lost ? b.last.place : s.film.least.place()};
  if (lost) v.cause = {b.last};
  return v;
}

Verdict ran_away_from(const Solution& s, const Branch& b, const MarchEnd& end) {
  const bool thins = rheology::viscosity(s.model.oil, kHottestOil, 0.0) <
                     rheology::viscosity(s.model.oil, kZeroCelsius, 0.0);
  return {Status::no_steady_state,
          ending::RanAway{carried(s, b.raised, b.carried), b.h_min, end.t, thins},
          end.verdict.place,
          {end.verdict}};
}

Verdict limit_not_resolved(const Solution& s) {
  ending::LimitMoves moves;
  for (auto l = s.limits.begin(); l != s.limits.end(); ++l) {
    const bool again = std::any_of(l + 1, s.limits.end(), [&](const Limit& later) {
      return later.grid == l->grid && later.raised == l->raised;  // film, then film and heat
    });
    if (!again) moves.limits.push_back({l->grid, carried(s, l->raised, l->part)});
  }
  return {Status::iteration_limit, std::move(moves), s.verdict.place, {s.verdict}};
}

}  // namespace shellback::bearing
