#include "bearing/steady/tiers.hpp"

#include <algorithm>

#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/steady/first_film.hpp"
#include "bearing/steady/heat_search.hpp"
#include "bearing/steady/lumped.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

bool stands(const Verdict& v) { return v.good() || v.status == Status::interrupted; }

/// The film at one temperature. From cold: Newton, through time, along the load (first_film.hpp).
Verdict steady_film(Solution& s, Level level, const SolveControl& control) {
  std::fill(s.film.columns.T.begin(), s.film.columns.T.end(), s.T_film);
  if (!level.warm) return first_film(s, s.T_film, control);
  return solve_equilibrium_near({s.model, s.point, {}, film_options(level), control.stop}, s.film,
                                s.cost);
}

/// Film, heat, walls and their deformation.
Verdict steady_heat(Solution& s, Level level, const SolveControl& control) {
  HeatSearch search(s, level, control);
  if (level.warm) return search.iterate();
  auto limits = s.limits;
  const Verdict film = search.cold_film();
  if (!film.good()) {
    // Where a film ends in oil of the supply's temperature says nothing of one that is heated, or
    // cooled by its walls, unless its gap is closed as it is given.
    if (s.point.load.unknowns == 0 && is_closed(s.model, s.film)) return film;
    if (search.over(film) && film.status == Status::no_steady_state) {
      return {Status::iteration_limit, ending::Plain::given_up, film.place, {film}};
    }
    if (search.over(film) || !search.may_follow()) return film;
    s.limits = std::move(limits);
    Verdict along = search.along_branch();
    if (search.over(along) || search.branch_begun()) return along;
    const bool of_a_branch = film.as<ending::BranchEnded>() != nullptr;
    if (film.status != Status::no_steady_state && !of_a_branch) return film;
    along.cause = {film};
    return along;
  }
  const Verdict direct = search.iterate();
  if (search.over(direct)) return direct;
  const Verdict along = search.may_follow() ? search.along_branch() : direct;
  if (search.over(along) || level.coarse) return along;
  const Reached end = search.here();
  const Verdict in_time = search.through_time();
  // Where no branch begins, what the warming bearing comes to in time stands for itself.
  const bool ran_away = in_time.status == Status::no_steady_state && !search.branch_begun();
  if (stands(in_time) || ran_away || !search.may_follow()) return in_time;
  search.back_to(end);
  return along;
}

}  // namespace

void solve_on_grid(Solution& s, Tier tier, Level level, const SolveControl& control) {
  EXPECTS(tier != Tier::estimate && tier != Tier::automatic);  // fidelity/ has turned them into one
  if (!level.warm) {
    s.film = cold_start(s.model, s.point, s.T_film);
    s.heat = {};
    s.heat_roots.clear();
  }
  s.verdict = tier == Tier::isothermal ? steady_film(s, level, control)
              : tier == Tier::lumped   ? solve_lumped(s, level.warm, control)
                                       : steady_heat(s, level, control);
}

}  // namespace shellback::bearing
