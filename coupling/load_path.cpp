#include "coupling/load_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/film_then_position.hpp"

namespace shellback::coupling {
namespace {

constexpr double kFirstEccentricity = 0.5;  ///< of the guess that serves most bearings [-]
constexpr double kCloser = 0.4;             ///< of the eccentricity before: towards the centre
constexpr int kMostStarts = 6;
constexpr double kFirstRatio = 3.0;       ///< of the load from step to step [-]
constexpr double kSmallestRatio = 1.002;  ///< a smaller step shows that the path ends [-]
constexpr int kMostSteps = 120;

LoadTarget scaled(LoadTarget target, double part) {
  for (double& f : target.force) f *= part;
  return target;
}

/// The state without what follows from it.
struct Place {
  fluid::FilmState film;
  fluid::JournalPosition position;
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

  Verdict run();

 private:
  /// Equilibrium with `part` of the load, near the present state.
  [[nodiscard]] Verdict solve(double part, const EquilibriumOptions& options);
  /// An equilibrium to begin with; its part of the load in `part_`.
  [[nodiscard]] Verdict begin();
  [[nodiscard]] Verdict end_of_path() const;
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
  const Verdict v = newton_equilibrium(model_, now, growth_, options, s_, cost_, stop_);
  if (v.good() || v.status == Status::interrupted) return v;
  s_.film = before.film;
  s_.position = before.position;
  return film_then_position(model_, now, growth_, options, s_, cost_, stop_);
}

Verdict LoadPath::begin() {
  EquilibriumOptions loose = options_;
  loose.load_tolerance = std::max(loose.load_tolerance, 1e-3);
  LoadTarget held = target_;
  held.unknowns = 0;
  fluid::JournalPosition first = first_position(model_.input, model_.clearance);
  Verdict v;
  for (int start = 0; start < kMostStarts; ++start) {
    for (int k = 0; k < 2; ++k) first.q[k] *= start == 0 ? kFirstEccentricity : kCloser;
    s_.position = first;
    s_.film = fluid::cold_film(model_.scene);
    v = film_then_position(model_, held, growth_, loose, s_, cost_, stop_);
    if (v.status == Status::interrupted) return v;
    if (!v.good()) continue;
    part_ = std::hypot(s_.force[0], s_.force[1]) / target_.scale();
    v = solve(part_, loose);
    if (v.good() || v.status == Status::interrupted) return v;
  }
  return v;
}

Verdict LoadPath::end_of_path() const {
  const std::string words = fmt::format(
      "followed from small loads on, the film carries {:.4g} N at a smallest gap of "
      "{:.3g} um",
      part_ * target_.scale(), s_.least.h * 1e6);
  if (failure_.status == Status::no_steady_state && part_ < 1.0) {
    return {Status::no_steady_state,
            fmt::format("the film cannot carry {:.4g} N: {}, and no more: {}", target_.scale(),
                        words, failure_.reason),
            failure_.place, failure_.cure};
  }
  return {Status::iteration_limit,
          fmt::format("no position was found for {:.4g} N: {}, then the path is lost ({})",
                      target_.scale(), words, failure_.reason),
          failure_.place, "lower the load or the tilt, or give roughness and contact data"};
}

Verdict LoadPath::run() {
  Verdict v = begin();
  if (!v.good()) return v;
  keep();
  EquilibriumOptions loose = options_;
  loose.load_tolerance = std::max(loose.load_tolerance, 1e-3);
  double ratio = kFirstRatio;
  for (int step = 0; step < kMostSteps; ++step) {
    const double next = part_ < 1.0 ? std::min(1.0, part_ * ratio) : std::max(1.0, part_ / ratio);
    v = solve(next, next == 1.0 ? options_ : loose);
    if (v.status == Status::interrupted) return v;
    if (v.good()) {
      if (next == 1.0) return v;
      part_ = next;
      keep();
      ratio = std::min(kFirstRatio, ratio * std::sqrt(ratio));
      continue;
    }
    failure_ = v;
    restore();
    ratio = std::sqrt(ratio);
    if (ratio < kSmallestRatio) break;
  }
  if (!evaluate(model_, growth_, options_.viscosity_tolerance, s_)) return failure_;
  return end_of_path();
}

}  // namespace

Verdict follow_load(const BearingModel& model, const LoadTarget& target, const Field& growth,
                    const EquilibriumOptions& options, FilmEquilibrium& state,
                    EquilibriumCost& cost, const std::atomic<bool>* stop) {
  return LoadPath(model, target, growth, options, state, cost, stop).run();
}

}  // namespace shellback::coupling
