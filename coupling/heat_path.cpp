#include "coupling/heat_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::coupling {
namespace {

constexpr std::array kLight{0.3, 0.1, 0.02};   ///< parts of load or speed to begin with [-]
constexpr std::array kSlow{2e-3, 2e-4, 2e-5};  ///< the same of the speed of given positions [-]
constexpr double kFirstRatio = 1.5;            ///< of load or speed from step to step [-]
constexpr double kLargestRatio = 2.0;
constexpr double kSmallestRatio = 1.01;  ///< a smaller step shows that the path ends [-]
constexpr double kBack = 0.9;  ///< of a coarser grid's path, where that of a finer one begins [-]
constexpr double kLooseHeat = 3e-3;  ///< change per turn that will do on the way [-]
constexpr int kMostTurns = 25;       ///< of one step
constexpr double kFurther = 1.1;     ///< of the path's end: past the slow place behind it [-]
constexpr int kMostNewton = 1500;    ///< of a slow step where the path seems to end
constexpr double kSteep = 3.0;  ///< d ln(friction)/d ln(load) near a turning point, or by speed [-]
constexpr double kSteeper = 3.0;  ///< the same over that of the whole path [-]
constexpr int kMostFilm = 40;     ///< film iterations of a turn of one step
constexpr int kMostInAll = 4000;  ///< film iterations from which a path is given up
constexpr int kMostRests = 40;    ///< such steps after which it may go on

/// What a state is, without what follows from it.
struct Reached {
  FilmEquilibrium film;
  HeatState heat;
  double part = 0.0;
};

/// d ln(friction) and d ln(flow) over d ln(part) between two points of the path.
struct Steepness {
  double torque = 0.0;
  double flow = 0.0;
};

Steepness steepness(const Waymark& a, const Waymark& b) {
  const double way = std::log(b.part / a.part);
  return {std::log(b.torque / a.torque) / way, std::log(b.flow / a.flow) / way};
}

class HeatPath {
 public:
  HeatPath(Solution& s, Raised raised, const ThermalOptions& options, const SolveControl& control)
      : s_(s),
        raised_(raised),
        options_(options),
        control_(control),
        goal_(s.target),
        newton_before_(s.cost.newton_iterations),
        speed_(s.model.scene.speed),
        omega_(s.model.input.operation.omega) {}
  ~HeatPath() { take(1.0); }
  HeatPath(const HeatPath&) = delete;
  HeatPath& operator=(const HeatPath&) = delete;

  /// A light load, or a low speed, from cold; false if none settles.
  [[nodiscard]] bool begin(const ColdStart& cold);
  /// A little before the end of the path of a coarser grid; false if that does not settle here.
  [[nodiscard]] bool begin(const NearPath& near);
  [[nodiscard]] Verdict follow();

 private:
  /// Gives the scene its part of what is raised.
  void take(double part);
  [[nodiscard]] Verdict settle(const ThermalOptions& options) {
    return solve_thermal(s_.model, s_.target, options, control_, s_.film, s_.heat, s_.cost,
                         s_.history);
  }
  /// From the state reached to `part`; where that fails, back to the state.
  [[nodiscard]] Verdict settle_at(double part, const ThermalOptions& options);
  [[nodiscard]] ThermalOptions on_the_way() const;
  /// Raises by steps, the first by `ratio`, until all is reached or they become small.
  [[nodiscard]] Verdict raise(double ratio);
  void keep(double part);
  [[nodiscard]] bool spent() const {
    return s_.cost.newton_iterations - newton_before_ > kMostInAll;
  }
  /// True if friction or flow change towards the end as they do towards a turning point.
  [[nodiscard]] bool turns() const;
  /// At the end of the path, over a step that is not too short; 0 if it has none.
  [[nodiscard]] Steepness last_steepness() const;
  [[nodiscard]] std::string followed() const;
  [[nodiscard]] Verdict turning_point() const;
  [[nodiscard]] Verdict end_of_path(Verdict last) const;

  Solution& s_;
  Raised raised_;
  const ThermalOptions& options_;
  const SolveControl& control_;
  LoadTarget goal_;
  int newton_before_;  ///< iterations spent before this path
  double speed_;       ///< wanted, of the journal's surface [m/s]
  double omega_;       ///< the same [rad/s]
  Reached reached_;
  std::vector<Waymark> way_;
  Verdict failure_;
};

void HeatPath::take(double part) {
  if (raised_ == Raised::load) {
    s_.target = goal_;
    for (double& f : s_.target.force) f *= part;
  } else {
    s_.model.scene.speed = part * speed_;
    s_.model.input.operation.omega = part * omega_;
  }
}

ThermalOptions HeatPath::on_the_way() const {
  ThermalOptions o = options_;
  o.tolerance = std::max(o.tolerance, kLooseHeat);
  o.max_turns = std::min(o.max_turns, kMostTurns);
  o.close = false;
  o.patient = false;
  o.film.max_iterations = std::min(o.film.max_iterations, kMostFilm);
  o.film.follow_load = false;
  return o;
}

void HeatPath::keep(double part) {
  reached_ = {s_.film, s_.heat, part};
  const Friction f = friction_of(s_.model, s_.film);
  const double flow = fluid::oil_flows(s_.model.scene, s_.film.flow).side;
  way_.push_back({part, std::abs(f.viscous + f.asperity), std::abs(flow)});
  s_.followed = {raised_, part, way_.front(), false};
}

bool HeatPath::turns() const {
  if (!(viscosity_change(s_.model, reached_.film) > kHeatMatters)) return false;
  const Steepness last = last_steepness();
  const Steepness all = steepness(way_.front(), way_.back());
  const auto steep = [](double here, double mean) {
    return here > std::max(kSteep, kSteeper * std::abs(mean));
  };
  return steep(last.torque, all.torque) || steep(-last.flow, all.flow);
}

Steepness HeatPath::last_steepness() const {
  const auto far = std::find_if(way_.rbegin(), way_.rend(), [&](const Waymark& w) {
    return w.part * kSmallestRatio <= reached_.part;
  });
  return far == way_.rend() ? Steepness{} : steepness(*far, way_.back());
}

Verdict HeatPath::settle_at(double part, const ThermalOptions& options) {
  take(part);
  const Verdict v = settle(options);
  if (v.good()) {
    keep(part);
  } else if (v.status != Status::interrupted) {
    s_.film = reached_.film;
    s_.heat = reached_.heat;
  }
  return v;
}

bool HeatPath::begin(const ColdStart& cold) {
  std::vector<double> parts(kLight.begin(), kLight.end());
  if (goal_.unknowns == 0) parts.insert(parts.end(), kSlow.begin(), kSlow.end());
  for (const double part : parts) {
    take(part);
    Verdict v = cold(s_);
    if (v.good()) v = settle(on_the_way());
    if (v.status == Status::interrupted) return false;
    if (!v.good()) continue;
    keep(part);
    return true;
  }
  return false;
}

bool HeatPath::begin(const NearPath& near) {
  way_.assign(1, near.end.first);
  take(kBack * near.end.part);
  s_.film = near.film;
  s_.heat = near.heat;
  if (settle(on_the_way()).good()) {
    keep(kBack * near.end.part);
    return true;
  }
  way_.clear();
  return false;
}

Verdict HeatPath::raise(double ratio) {
  while (ratio > kSmallestRatio && !spent()) {
    const double next = std::min(1.0, reached_.part * ratio);
    ThermalOptions options = on_the_way();
    if (next == 1.0) {
      options = options_;
      options.patient = false;
      options.film.follow_load = false;
    }
    const Verdict v = settle_at(next, options);
    if (v.status == Status::interrupted || reached_.part == 1.0) return v;
    ratio = v.good() ? std::min(kLargestRatio, ratio * std::sqrt(ratio))
                     : std::sqrt(next / reached_.part);
    if (!v.good()) failure_ = v;
  }
  return failure_;
}

Verdict HeatPath::follow() {
  for (int rest = 0; rest < kMostRests && !spent(); ++rest) {
    Verdict v = raise(rest == 0 ? kFirstRatio : kFurther);
    if (v.status == Status::interrupted || reached_.part == 1.0) return v;
    const bool defect = failure_.status == Status::invalid_number;  // which proves nothing
    if (turns() && !defect) return turning_point();
    ThermalOptions slow = options_;
    slow.close = reached_.part * kFurther >= 1.0 && options_.close;
    slow.most_newton = kMostNewton;
    v = settle_at(std::min(1.0, reached_.part * kFurther), slow);
    if (v.status == Status::interrupted || reached_.part == 1.0) return v;
    if (!v.good()) return end_of_path(v);
  }
  Verdict open = failure_;  // of accelerated steps: no proof of anything
  if (open.status != Status::invalid_number) open.status = Status::iteration_limit;
  return end_of_path(open);
}

std::string HeatPath::followed() const {
  if (raised_ == Raised::load) {
    return fmt::format(
        "followed from light loads on, film and heat come to rest up to {:.4g} N of {:.4g} N",
        reached_.part * goal_.scale(), goal_.scale());
  }
  const double rpm = std::abs(omega_) * 30.0 / kPi;
  return fmt::format(
      "followed from low speeds on, film and heat come to rest up to {:.4g} rpm of {:.4g} rpm",
      reached_.part * rpm, rpm);
}

Verdict HeatPath::turning_point() const {
  const char* what = raised_ == Raised::load ? "load" : "speed";
  const Steepness last = last_steepness();
  return {Status::no_steady_state,
          fmt::format("thermal runaway: {}; there friction changes as the {} to the power {:.1f}, "
                      "flow as to the power {:.1f}, and with {:.0f} % more they find no rest",
                      followed(), what, last.torque, last.flow, 100.0 * (kSmallestRatio - 1.0)),
          failure_.place,
          "lower speed or load, feed more or cooler oil, or improve the cooling of the shell"};
}

Verdict HeatPath::end_of_path(Verdict v) const {
  if (thinner_than_a_molecule(s_.model, reached_.film)) {  // of a state that did come to rest
    return {Status::no_steady_state,
            fmt::format("no film carries more: {}, at a smallest gap of {:.3g} um, less than a "
                        "molecule of oil",
                        followed(), reached_.film.least.h * 1e6),
            fluid::place_of(reached_.film.least),
            "give roughness and contact data, or lower the load"};
  }
  v.reason = fmt::format("{}; then: {}", followed(), v.reason);
  return v;
}

}  // namespace

std::optional<Verdict> follow_heat(Solution& s, const NearPath* near, const ColdStart& cold,
                                   const ThermalOptions& options, const SolveControl& control) {
  s.followed = {};
  for (const Raised raised : {Raised::load, Raised::speed}) {
    if (raised == Raised::load && s.target.unknowns == 0) continue;  // a given position has none
    HeatPath path(s, raised, options, control);
    if (near && near->end.raised == raised && path.begin(*near)) return path.follow();
    if (path.begin(cold)) return path.follow();
    if (control.stop && control.stop->load()) break;
  }
  return std::nullopt;
}

}  // namespace shellback::coupling
