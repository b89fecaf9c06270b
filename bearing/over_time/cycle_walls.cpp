#include "bearing/over_time/cycle_walls.hpp"

#include <cmath>

#include "bearing/heat_state.hpp"
#include "bearing/over_time/film_answer.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/fixed_point.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

void CycleHeat::begin(const FilmInTime& now) {
  last_ = now.heat.skin;
  skin_.assign(last_.size(), 0.0);
}

void CycleHeat::add(const FilmStep& step, double dt) {
  flows_.add(1.0, step.heat);
  const std::vector<double>& now = step.after.heat.skin;
  for (std::size_t k = 0; k < now.size(); ++k) skin_[k] += 0.5 * dt * (last_[k] + now[k]);
  last_ = now;
  time_ += dt;
}

void CycleHeat::look_at(const BearingModel& model, const OperatingPoint& point,
                        const FilmEquilibrium& s) {
  const thermal::FilmEnergy film(lasting_film(model, point, s));
  const thermal::WallResponse r = film.wall_response(kSweepsOfResponse);
  response_.shell += r.shell;
  response_.shaft += r.shaft;
  response_.across += r.across;
  response_.back += r.back;
  response_.shell_local += r.shell_local;
  response_.shell_ring += r.shell_ring;
  response_.shaft_ring += r.shaft_ring;
  ++looks_;
}

void CycleHeat::hold(const BearingModel& model, const OperatingPoint& point,
                     const FilmEquilibrium& s) {
  held_.push_back(held_film(model, point, s));
}

void CycleHeat::put_on(const BearingModel& model) {
  for (thermal::FilmEnergyProblem& p : held_) {
    p.grid = &model.domain.grid;
    p.gl = &model.gl;
  }
}

thermal::WallResponse CycleHeat::response() const {
  const double part = 1.0 / looks_;
  const thermal::WallResponse& r = response_;
  return {part * r.shell,       part * r.shaft,      part * r.across,    part * r.back,
          part * r.shell_local, part * r.shell_ring, part * r.shaft_ring};
}

std::vector<double> CycleHeat::mean_skin() const {
  std::vector<double> mean = skin_;
  for (double& x : mean) x /= time_;
  return mean;
}

void CycleHeat::members(Tape& tape) {
  auto& [flows, skin, last, time, response, looks, held] = *this;
  tape(flows, skin, last, time, response, looks, held);
}

std::vector<double> packed(const WallMeans& walls, double clearance) {
  std::vector<double> x;
  x.reserve(walls.shell.size() + walls.shaft.size() + walls.thermal_deformation.size());
  for (const double T : walls.shell) x.push_back(T / kHeatUnit);
  for (const double T : walls.shaft) x.push_back(T / kHeatUnit);
  for (const double d : walls.thermal_deformation) x.push_back(d / clearance);
  return x;
}

void unpack(const std::vector<double>& x, double clearance, WallMeans& walls) {
  auto at = x.begin();
  for (double& T : walls.shell) T = kHeatUnit * *at++;
  for (double& T : walls.shaft) T = kHeatUnit * *at++;
  for (double& d : walls.thermal_deformation) d = clearance * *at++;
}

double mean_difference(const FilmGrid& g, const WallMeans& a, const WallMeans& b) {
  const auto apart = [](std::vector<double> x, const std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = std::abs(x[k] - y[k]);
    return x;
  };
  return larger(area_mean(g, apart(a.shell, b.shell)), axial_mean(g, apart(a.shaft, b.shaft)));
}

namespace {

/// What the walls of a cycle have seen.
struct SeenByWalls {
  WallFlux q;  ///< the mean heat
  Field met;   ///< the bore's mean temperature, with its skin [K]
};

SeenByWalls seen_by(const BearingModel& model, const WallMeans& walls, const CycleHeat& heat,
                    const thermal::WallResponse& response, int skin_nodes, const HeatTaken& more) {
  const FilmGrid& g = model.domain.grid;
  const std::vector<double> skin = heat.mean_skin();
  SeenByWalls out{{Field(g.cells(), 0.0), std::vector<double>(g.nz, 0.0), response}, walls.shell};
  const double area = 2.0 * kPi * g.radius * g.width;
  std::fill(out.q.shaft.begin(), out.q.shaft.end(), more.shaft / area);
  double met_by_oil = 0.0;  // of the shell [m2]; where a supply keeps its heat nothing enters
  for (int c = 0; c < g.cells(); ++c) {
    if (meets_walls(model, c)) met_by_oil += g.multiplicity() * g.area(c);
  }
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int c = g.index(i, j);
      out.q.shell[c] = heat.flows().to_shell[c] / heat.time();
      if (meets_walls(model, c)) out.q.shell[c] += more.shell / met_by_oil;
      out.q.shaft[j] += heat.flows().to_shaft[c] / heat.time() * g.dphi[i] / (2.0 * kPi);
      out.met[c] += skin[static_cast<std::size_t>(c) * skin_nodes];
    }
  }
  return out;
}

}  // namespace

BodiesAnswer answer_of_bodies(const BearingModel& model, const WallMeans& walls,
                              const CycleHeat& heat, const thermal::WallResponse& response,
                              int skin_nodes, const SolidStep* step, const HeatTaken& more,
                              OilAnswers oil) {
  constexpr int kDepth = 12;         // as of steady heat (heat/wall_balance.cpp)
  constexpr double kSettled = 1e-3;  // a fiftieth of what counts as still [K]
  EXPECTS(!heat.held().empty());
  const SeenByWalls seen = seen_by(model, walls, heat, response, skin_nodes, more);
  FilmAnswer film(model, heat.held(), oil == OilAnswers::by_thinning);
  BodiesAnswer out;
  WallFlux q;
  Field shell;
  std::vector<double> shaft;
  const auto answer = [&](Solids::Wanted wanted) {
    return model.solids->answer(q, shell, shaft, wanted, step);
  };
  const auto joined = [](Field a, const std::vector<double>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const auto map = [&](const std::vector<double>& x, std::vector<double>& to) {
    const auto middle = x.begin() + static_cast<std::ptrdiff_t>(seen.met.size());
    shell.assign(x.begin(), middle);
    shaft.assign(middle, x.end());
    Field warmer = shell;
    std::vector<double> warmer_shaft = shaft;
    for (std::size_t c = 0; c < warmer.size(); ++c) warmer[c] -= seen.met[c];
    for (std::size_t j = 0; j < shaft.size(); ++j) warmer_shaft[j] -= walls.shaft[j];
    q = seen.q;
    film.add_to(q, warmer, warmer_shaft);
    const SolidTemperature then = answer({false, false});
    to = joined(then.shell.surface, then.shaft.temperature);
    out.left = largest_difference(to, x);
    return true;
  };
  std::vector<double> x = joined(seen.met, walls.shaft);
  // Where it does not settle, walls are as its last round has them: `left` says how far off.
  static_cast<void>(fixed_point(map, {kDepth, 1, kMostIterations, kSettled}, x));
  out.solids = answer({model.physics.thermal_deformation, true});
  out.walls = {out.solids.shell.surface, out.solids.shaft.temperature, q.shell,
               out.solids.thermal_deformation};
  return out;
}

}  // namespace shellback::bearing
