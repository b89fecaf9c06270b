/// A plane Couette film that heats itself, by the film energy equation of thermal/.
///
/// A ring of cells with walls of given temperature (or one insulated), carried round slowly; the
/// temperature enters viscosity, eta = eta0 exp(-beta (T - T0)), and viscosity heat, by repeated
/// substitution with half steps until nothing changes.
#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "core/make_grid.hpp"
#include "thermal/film_energy.hpp"
#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {
namespace {

using namespace thermal;

constexpr double kT0 = 300.0;             // [K]; the result does not depend on these
constexpr double kEta0 = 0.02;            // [Pa s]
constexpr double kBeta = 0.04;            // [1/K]
constexpr double kGap = 20e-6;            // [m]
constexpr double kConductivity = 0.13;    // [W/(m K)]
constexpr double kHeatCapacity = 2000.0;  // [J/(kg K)]
constexpr double kFlow = 3e-5;            // so weak that some sweeps forget the start [kg/s]
constexpr double kSettled = 1e-11;        // change of a sweep [K]
constexpr int kMostSweeps = 5000;
constexpr int kSubstitutions = 200;
constexpr int kCells = 6;

class HeatedFilm {
 public:
  HeatedFilm(double nahme, int nodes)
      : grid_(make_grid(0.01, 0.01, kCells, 1, false)),
        gl_(gauss_lobatto(nodes)),
        speed_(std::sqrt(nahme * kConductivity / (kBeta * kEta0))),
        T_(static_cast<std::size_t>(kCells) * nodes, kT0) {
    const auto nodes_all = T_.size();
    problem_.grid = &grid_;
    problem_.gl = &gl_;
    problem_.phi_flow.assign(nodes_all, 0.0);
    problem_.z_flow.assign(2 * nodes_all, 0.0);
    problem_.patch.assign(kCells, -1);
    problem_.line.assign(kCells, -1);
    problem_.conductance.assign(kCells, kConductivity * area() / kGap);
    problem_.heat.assign(nodes_all, 0.0);
    problem_.cp.assign(nodes_all, kHeatCapacity);
    problem_.cp_edge = kHeatCapacity;
    problem_.T_reference = problem_.T_edge = kT0;
    for (std::size_t k = 0; k < nodes_all; ++k) {
      problem_.phi_flow[k] = kFlow * gl_.s[k % static_cast<std::size_t>(nodes)];
    }
  }

  void settle(bool insulated) {
    for (int turn = 0; turn < kSubstitutions; ++turn) {
      dissipate();
      FilmEnergy film(problem_);
      sweep(film);
      if (!insulated) continue;
      const double flux = film.wall_heat(T_).shaft[0] / area();
      const double rise = flux / film.wall_response(kSubstitutions).shaft;
      for (int c = 0; c < kCells; ++c) T_[at(c, gl_.n - 1)] += rise;
      sweep(film);
    }
  }

  [[nodiscard]] double rise() const { return kBeta * (largest(T_) - kT0); }
  [[nodiscard]] double stress_ratio() const { return stress_ * kGap / (kEta0 * speed_); }

 private:
  [[nodiscard]] double area() const { return grid_.area(0, 0); }
  [[nodiscard]] std::size_t at(int cell, int k) const {
    return static_cast<std::size_t>(cell) * gl_.n + k;
  }
  [[nodiscard]] double fluidity(std::size_t node) const {
    return std::exp(kBeta * (T_[node] - kT0)) / kEta0;
  }
  void dissipate() {
    for (int c = 0; c < kCells; ++c) {
      double mean = 0.0;
      for (int k = 0; k < gl_.n; ++k) mean += gl_.w[k] * fluidity(at(c, k));
      stress_ = speed_ / (kGap * mean);
      for (int k = 0; k < gl_.n; ++k) {
        double& heat = problem_.heat[at(c, k)];
        const double now = gl_.w[k] * area() * kGap * stress_ * stress_ * fluidity(at(c, k));
        heat += 0.5 * (now - heat);  // at large Nahme numbers a whole step overshoots
      }
    }
  }
  void sweep(FilmEnergy& film) {
    for (int k = 0; k < kMostSweeps; ++k) {
      if (film.sweep(T_) < kSettled) return;
    }
  }

  FilmGrid grid_;
  CrossFilmNodes gl_;
  FilmEnergyProblem problem_;
  double speed_;
  double stress_ = 0.0;
  std::vector<double> T_;
};

}  // namespace

Values couette_film_values(const Question& q) {
  const int nodes = static_cast<int>(number_setting(q.entry, "nodes"));
  if (nodes < 3 || nodes > 15) {
    throw InputError(q.entry.folder + "/entry.toml", "settings.nodes must lie between 3 and 15");
  }
  Values values;
  for (const bool insulated : {false, true}) {
    HeatedFilm film(q.number("Na"), nodes);
    film.settle(insulated);
    const std::string which = insulated ? "_one_insulated" : "_two_cold_walls";
    values.value["rise" + which] = film.rise();
    values.value["stress_ratio" + which] = film.stress_ratio();
  }
  return values;
}

}  // namespace shellback::validation
