#include "bearing/over_time/film_answer.hpp"

#include <algorithm>
#include <utility>

#include "bearing/heat/film_heat.hpp"
#include "bearing/heat_state.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// The heat that film and supplies make, but for what its oil makes less as it warms.
void leave_what_thins(const BearingModel& model, const FilmEquilibrium& s,
                      thermal::FilmEnergyProblem& p) {
  const int n = model.gl.n;
  p.thinning.resize(p.heat.size());
  for (std::size_t k = 0; k < p.heat.size(); ++k) {
    p.thinning[k] = std::max(p.heat[k], 0.0) * thinning(model, s.columns.T[k], s.film.p[k / n]);
  }
  std::fill(p.heat.begin(), p.heat.end(), 0.0);
  for (thermal::SupplyVessel& v : p.vessels) {
    v.heat = 0.0;
    v.T_sheared = p.T_reference;
  }
  for (int c = 0; c < model.domain.grid.cells(); ++c) {
    if (p.patch[c] < 0) continue;
    const double T = s.columns.T[static_cast<std::size_t>(c) * n + n / 2];
    p.vessels[p.patch[c]].thinning = thinning(model, T, s.film.p[c]);
  }
}

}  // namespace

thermal::FilmEnergyProblem held_film(const BearingModel& model, const OperatingPoint& point,
                                     const FilmEquilibrium& s) {
  thermal::FilmEnergyProblem p = lasting_film(model, point, s);
  leave_what_thins(model, s, p);
  p.throttled = 0.0;
  p.T_edge = p.T_reference;
  for (thermal::SupplyVessel& v : p.vessels) v.T_supply = p.T_reference;
  return p;
}

FilmAnswer::FilmAnswer(const BearingModel& model, std::vector<thermal::FilmEnergyProblem> instants,
                       bool thins)
    : model_(model) {
  for (thermal::FilmEnergyProblem& p : instants) {
    if (!thins) {
      p.thinning.clear();
      for (thermal::SupplyVessel& v : p.vessels) v.thinning = 0.0;
    }
    const double cold = p.T_reference;
    const std::size_t nodes = p.heat.size();
    instants_.push_back(
        {thermal::FilmEnergy(std::move(p)), cold, std::vector<double>(nodes, cold)});
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
