#include "bearing/steady/first_film.hpp"

#include "bearing/film/follow.hpp"
#include "bearing/film/newton.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/possible_methods.hpp"
#include "bearing/steady/branch_endings.hpp"
#include "bearing/steady/level.hpp"

namespace shellback::bearing {
namespace {

Verdict correct_film(Solution& s, Accuracy accuracy, const SolveControl& control) {
  EquilibriumOptions o;
  if (accuracy == Accuracy::way_point) {
    o.film_tolerance = o.load_tolerance = o.elastic_tolerance = o.viscosity_tolerance = kWayPoint;
  }
  return newton({s.model, s.point, s.heat.thermal_deformation, o, control.stop}, s.film, s.cost);
}

/// A rigid film of constant viscosity is found from any guess: the first guess for oil that
/// thickens under pressure. Where it is not found the guess stays that of cold_start.
void guess_isoviscous(Solution& s, const SolveControl& control) {
  if (s.model.physics.elastic || !usual_methods(s.model.input)) return;
  if (std::holds_alternative<rheology::NoPressureEffect>(s.model.oil.pressure)) return;
  BearingModel isoviscous = s.model;
  isoviscous.oil.pressure = rheology::NoPressureEffect{};
  EquilibriumOptions loose;
  loose.film_tolerance = loose.load_tolerance = loose.viscosity_tolerance = kWayPoint;
  FilmEquilibrium guess = s.film;
  const Verdict v =
      newton({isoviscous, s.point, s.heat.thermal_deformation, loose, control.stop}, guess, s.cost);
  if (v.good()) s.film = std::move(guess);
}

}  // namespace

Verdict first_film(Solution& s, double T, const SolveControl& control) {
  const Field thermal_deformation = s.heat.thermal_deformation;
  const auto start = [&] {
    return solve_equilibrium({s.model, s.point, thermal_deformation, {}, control.stop}, s.film,
                             s.cost);
  };
  s.film = cold_start(s.model, s.point, T);
  guess_isoviscous(s, control);
  const double whole = s.cost.most_work;
  s.cost.most_work = s.cost.work + kForStarts * (whole - s.cost.work);
  const Verdict v = start();
  s.cost.most_work = whole;
  const bool ended = v.good() || v.status == Status::interrupted || s.cost.spent() ||
                     !usual_methods(s.model.input);
  if (ended) return v;
  const Corrector correct = [&](Solution& at, Accuracy accuracy) {
    return correct_film(at, accuracy, control);
  };
  if (s.point.load.unknowns == 0) {
    if (!s.model.physics.elastic) return v;
    // Surfaces that give way are met before they have: from a place nearer to the middle.
    const auto begin = [&] {
      const fluid::JournalPosition place = s.film.position;
      s.film = cold_start(s.model, s.point, T);
      s.film.position = place;
      return start();
    };
    s.film = cold_start(s.model, s.point, T);
    const auto b = follow_from(s, Raised::place, kLight, begin, correct, control);
    if (!b) return v;
    if (b->end == BranchEnd::lost) return branch_ended(s, *b);
    return b->end == BranchEnd::reached ? Verdict{} : b->last;
  }
  const std::optional<Branch> branch = follow_loads(
      s,
      [&] {
        s.film = cold_start(s.model, s.point, T);
        return start();
      },
      correct, control);
  if (!branch) return v;
  if (branch->end == BranchEnd::reached) return {};
  if (branch->end == BranchEnd::interrupted) return branch->last;
  note_limit(s, *branch, shows_none_beyond(s, *branch));
  return branch_ended(s, *branch);
}

}  // namespace shellback::bearing
