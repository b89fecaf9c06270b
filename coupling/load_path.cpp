#include "coupling/load_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "coupling/film_then_position.hpp"

namespace shellback::coupling {
namespace {

// Positions from which a path may begin.
constexpr std::array kEccentricities{0.01, 0.1, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.996};
constexpr std::array kAttitudes{0.1, 0.5, 0.9, 1.3, -0.4};  ///< against the load [rad]
constexpr std::size_t kMostStarts = 3;
constexpr double kRoughFilm = 1e-4;  ///< residual that tells a force well enough [-]
constexpr double kLooseLoad = 1e-3;  ///< load residual on the way [-]
constexpr double kPerOctave = 32.0;  ///< loads on the way are whole powers of 2^(1/32) N
constexpr int kLongestStep = 51;     ///< in such powers: three times the load
constexpr double kWellBelow = 0.6;   ///< of a coarser grid's end: there a cold film is found [-]
constexpr int kToNear = 21;          ///< powers from there to 0.95 of that end
constexpr int kNearStep = 2;         ///< 4 %: by about so much grids differ in what they carry
constexpr int kMostSteps = 120;
constexpr int kMostFilms = 60;       ///< film iterations of film and position one after the other
constexpr int kMostIterations = 25;  ///< of one step
constexpr std::array kCloser{0.003, 0.01, 0.03};  ///< of the gap: a little closer [-]

Verdict stopped() { return {Status::interrupted, "stopped by the user", "", ""}; }

LoadTarget scaled(LoadTarget target, double part) {
  for (double& f : target.force) f *= part;
  return target;
}

double level_of(double load) { return kPerOctave * std::log2(load); }
double load_at(double level) { return std::exp2(level / kPerOctave); }

/// The state without what follows from it.
struct Place {
  fluid::FilmState film;
  fluid::JournalPosition position;
};

struct Start {
  Place place;
  double part = 0.0;  ///< of the load that it carries, in whichever direction
  double off = 0.0;   ///< |ln(load/force)| as complex numbers
};

class LoadPath {
 public:
  LoadPath(const BearingModel& model, const LoadTarget& target, const Field& growth,
           const EquilibriumOptions& options, FilmEquilibrium& s, EquilibriumCost& cost,
           const std::atomic<bool>* stop)
      : model_(model),
        target_(target),
        growth_(growth),
        options_(options),
        s_(s),
        cost_(cost),
        stop_(stop) {}

  Verdict run(double carried);

 private:
  /// Equilibrium with `part` of the load, near the present state.
  [[nodiscard]] Verdict solve(double part, const EquilibriumOptions& options);
  /// Films of positions all over the loaded half, the nearest to the load first.
  [[nodiscard]] std::vector<Start> starts();
  /// From the present state and its part of the load to the whole, the first step so many powers.
  /// The steps after the first two loads begin with `then` powers.
  [[nodiscard]] Verdict follow(int step, int then);
  [[nodiscard]] Verdict from_cold();
  /// True if a little closer, in the load's direction, there is no film; then `failure_` says why.
  [[nodiscard]] bool nothing_closer();
  [[nodiscard]] Verdict end_of_path();
  [[nodiscard]] Verdict not_begun() const;
  void keep() { kept_ = {s_.film, s_.position}; }
  void restore() {
    s_.film = kept_.film;
    s_.position = kept_.position;
  }

  const BearingModel& model_;
  const LoadTarget& target_;
  const Field& growth_;
  const EquilibriumOptions& options_;
  FilmEquilibrium& s_;
  EquilibriumCost& cost_;
  const std::atomic<bool>* stop_;
  Place kept_;
  double part_ = 0.0;
  Verdict failure_;
};

Verdict LoadPath::solve(double part, const EquilibriumOptions& options) {
  const LoadTarget now = scaled(target_, part);
  const Place before{s_.film, s_.position};
  EquilibriumOptions few = options;  // a step that needs more is too long
  few.max_iterations = kMostIterations;
  const Verdict v = newton_equilibrium(model_, now, growth_, few, s_, cost_, stop_);
  if (v.good() || v.status == Status::interrupted) return v;
  s_.film = before.film;
  s_.position = before.position;
  const double most_work = cost_.most_work;
  cost_.most_work = std::min(most_work, cost_.work + kMostFilms * model_.scene.grid.cells());
  const Verdict slow = film_then_position(model_, now, growth_, few, s_, cost_, stop_);
  cost_.most_work = most_work;
  if (!slow.good()) return slow;
  const Place found{s_.film, s_.position};  // a last joint step balances the oil to the end
  const Verdict end = newton_equilibrium(model_, now, growth_, options, s_, cost_, stop_);
  if (end.good() || end.status == Status::interrupted) return end;
  s_.film = found.film;
  s_.position = found.position;
  return evaluate(model_, growth_, options.viscosity_tolerance, s_) ? slow : end;
}

std::vector<Start> LoadPath::starts() {
  EquilibriumOptions rough = options_;
  rough.film_tolerance = std::max(rough.film_tolerance, kRoughFilm);
  rough.viscosity_tolerance = std::max(rough.viscosity_tolerance, kRoughFilm);
  LoadTarget held = target_;
  held.unknowns = 0;
  const std::complex<double> load(-target_.force[0], -target_.force[1]);
  const double turn = model_.input.operation.omega >= 0.0 ? 1.0 : -1.0;
  std::vector<Start> found;
  for (const double attitude : kAttitudes) {
    s_.film = fluid::cold_film(model_.scene);
    for (const double ratio : kEccentricities) {
      const auto e = std::polar(ratio * model_.clearance, std::arg(load) + turn * attitude);
      s_.position = first_position(model_.input, model_.clearance);
      s_.position.q[0] = e.real();
      s_.position.q[1] = e.imag();
      const Verdict v = film_then_position(model_, held, growth_, rough, s_, cost_, stop_);
      if (v.status == Status::interrupted) return {};
      if (!v.good()) {
        failure_ = v;
        break;  // closer there is none either
      }
      const std::complex<double> force(s_.force[0], s_.force[1]);
      if (!(std::abs(force) > 0.0)) continue;
      const double off = std::abs(std::log(-load / force));
      found.push_back({{s_.film, s_.position}, std::abs(force) / target_.scale(), off});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Start& a, const Start& b) { return a.off < b.off; });
  return found;
}

bool LoadPath::nothing_closer() {
  const Place here{s_.film, s_.position};
  LoadTarget held = target_;
  held.unknowns = 0;
  const double gap = std::max(s_.least.h, 0.0) + 3.0 * model_.scene.rough.sigma;
  bool none = false;
  for (const double part : kCloser) {
    for (int k = 0; k < 2; ++k) {
      s_.position.q[k] = here.position.q[k] - part * gap * target_.force[k] / target_.scale();
    }
    s_.film = here.film;
    const Verdict v = film_then_position(model_, held, growth_, options_, s_, cost_, stop_);
    none = v.status == Status::no_steady_state;
    if (none) {
      failure_ = v;
      break;
    }
  }
  s_.film = here.film;
  s_.position = here.position;
  return none;
}

Verdict LoadPath::end_of_path() {
  const std::string words = fmt::format(
      "followed from smaller loads on, the film carries {:.4g} N at a smallest gap of "
      "{:.3g} um, and not {:.2g} % more",
      part_ * target_.scale(), s_.least.h * 1e6, 100.0 * (load_at(1.0) - 1.0));
  if (part_ < 1.0 && thinner_than_a_molecule(model_, s_)) {
    return {Status::no_steady_state,
            fmt::format("no film carries {:.4g} N: {}, less than a molecule of oil",
                        target_.scale(), words),
            "",
            "give roughness and contact data, switch on elastic deformation, or lower the load"};
  }
  if (part_ < 1.0 && nothing_closer()) {
    return {Status::no_steady_state,
            fmt::format("the film cannot carry {:.4g} N: {}, and closer there is none: {}",
                        target_.scale(), words, failure_.reason),
            failure_.place, failure_.cure};
  }
  return {Status::iteration_limit,
          fmt::format("no position was found for {:.4g} N: {}, then the path is lost ({})",
                      target_.scale(), words, failure_.reason),
          failure_.place, "lower the load or the tilt, or give roughness and contact data"};
}

Verdict LoadPath::not_begun() const {
  return {
      Status::iteration_limit,
      fmt::format("no position was found for {:.4g} N: no smaller load to begin with either ({})",
                  target_.scale(), failure_.reason),
      failure_.place, "lower the load or the tilt, or give roughness and contact data"};
}

Verdict LoadPath::follow(int step, int then) {
  EquilibriumOptions loose = options_;
  loose.load_tolerance = std::max(loose.load_tolerance, kLooseLoad);
  const double goal = level_of(target_.scale());
  double at = std::floor(level_of(part_ * target_.scale()));  // the start's own force, turned
  double failed_at = INFINITY;                                // nearest level that was not reached
  bool begun = false;
  for (int k = 0; k < kMostSteps; ++k) {
    const double next = begun ? at + (at < goal ? step : -step) : at;
    const bool whole = begun && (at < goal ? next >= goal : next <= goal);
    const double part = whole ? 1.0 : load_at(next) / target_.scale();
    const Verdict v = solve(part, whole ? options_ : loose);
    if (v.status == Status::interrupted || (v.good() && whole)) return v;
    if (v.good()) {
      at = next;
      part_ = part;
      if (begun) step = std::min(std::exchange(then, 2 * then), kLongestStep);
      begun = true;
      keep();
      if (thinner_than_a_molecule(model_, s_)) break;
    } else {
      failure_ = v;
      if (!begun) return not_begun();
      restore();
      failed_at = whole ? goal : next;
      if (step == 1) break;
    }
    if (std::abs(failed_at - at) <= step) {  // half of what is left
      step = std::max(1, static_cast<int>(0.5 * std::abs(failed_at - at)));
      if (std::abs(failed_at - at) <= 1.0) break;
    }
  }
  if (!evaluate(model_, growth_, options_.viscosity_tolerance, s_)) return failure_;
  return end_of_path();
}

Verdict LoadPath::from_cold() {
  const std::vector<Start> list = starts();
  if (list.empty()) {
    if (stop_ && stop_->load()) return stopped();
    return failure_.status == Status::no_steady_state ? failure_ : not_begun();
  }
  Verdict verdict;
  for (std::size_t k = 0; k < std::min(list.size(), kMostStarts); ++k) {
    s_.film = list[k].place.film;
    s_.position = list[k].place.position;
    part_ = list[k].part;
    keep();
    const Verdict v = follow(kLongestStep, kLongestStep);
    if (v.good() || v.status == Status::interrupted) return v;
    if (k == 0 || v.status == Status::no_steady_state) verdict = v;
    if (v.status == Status::no_steady_state) break;
  }
  return verdict;
}

Verdict LoadPath::run(double carried) {
  if (carried > 0.0) {
    part_ = std::min(1.0, kWellBelow * carried / target_.scale());
    keep();
    const Verdict v = follow(kToNear, kNearStep);
    if (v.status != Status::iteration_limit) return v;
  }
  return from_cold();
}

}  // namespace

Verdict follow_load(const BearingModel& model, const LoadTarget& target, const Field& growth,
                    const EquilibriumOptions& options, FilmEquilibrium& state,
                    EquilibriumCost& cost, const std::atomic<bool>* stop, double carried) {
  return LoadPath(model, target, growth, options, state, cost, stop).run(carried);
}

}  // namespace shellback::coupling
