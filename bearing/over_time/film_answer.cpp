#include "bearing/over_time/film_answer.hpp"

#include <algorithm>

#include "bearing/heat/film_heat.hpp"
#include "bearing/heat_state.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {

thermal::FilmEnergyProblem held_film(const BearingModel& model, const OperatingPoint& point,
                                     const FilmEquilibrium& s) {
  thermal::FilmEnergyProblem p = lasting_film(model, point, s);
  std::fill(p.heat.begin(), p.heat.end(), 0.0);
  p.throttled = 0.0;
  p.T_edge = p.T_reference;
  for (thermal::SupplyVessel& v : p.vessels) {
    v.T_supply = p.T_reference;
    v.heat = 0.0;
  }
  return p;
}

FilmAnswer::FilmAnswer(const BearingModel& model,
                       const std::vector<thermal::FilmEnergyProblem>& instants)
    : model_(model) {
  for (const thermal::FilmEnergyProblem& p : instants) {
    instants_.push_back(
        {thermal::FilmEnergy(p), p.T_reference, std::vector<double>(p.heat.size(), p.T_reference)});
  }
}

void FilmAnswer::add_to(WallFlux& q, const Field& shell, const std::vector<double>& shaft) {
  const FilmGrid& g = model_.domain.grid;
  const int n = model_.gl.n;
  const double part = 1.0 / static_cast<double>(instants_.size());
  for (Instant& now : instants_) {
    for (int c = 0; c < g.cells(); ++c) {
      if (!meets_walls(model_, c)) continue;
      double* T = &now.T[static_cast<std::size_t>(c) * n];
      T[0] = now.cold + shell[c];
      T[n - 1] = now.cold + shaft[c % g.nz];
    }
    for (int k = 0; k < kSweepsOfResponse; ++k) now.film.sweep(now.T);
    const thermal::WallHeat into = now.film.wall_heat(now.T);
    for (int c = 0; c < g.cells(); ++c) {
      if (!meets_walls(model_, c)) continue;
      q.shell[c] += part * into.shell[c] / g.area(c);
      q.shaft[c % g.nz] += part * into.shaft[c] / g.area(c) * g.dphi[c / g.nz] / (2.0 * kPi);
    }
  }
}

}  // namespace shellback::bearing
