#include "bearing/steady/lumped.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/newton.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/heat/heat_scan.hpp"
#include "bearing/steady/first_film.hpp"
#include "core/bracketed_root.hpp"
#include "rheology/heat.hpp"

namespace shellback::bearing {
namespace {

/// A film that was solved: what it says of heat, and where it is, to start others from.
struct Tried {
  HeatRoot heat;          ///< slope not yet known
  double residual = 0.0;  ///< r [K]
  double surplus = 0.0;   ///< heat made over heat carried off [W]
  fluid::FilmState film;
  fluid::JournalPosition position;
  Field elastic;
};

class LumpedBalance {
 public:
  LumpedBalance(Solution& s, bool warm, const SolveControl& control)
      : s_(s),
        control_(control),
        warm_(warm),
        T_least_(supply_temperatures(s.model.input).first),
        T_most_(supply_temperatures(s.model.input).second + kHottestRise) {}

  Verdict run();

 private:
  /// r(T) of the film at T; none, with the failure kept, if there is no film.
  [[nodiscard]] std::optional<double> residual(double T);
  /// The film at T from the nearest that was solved.
  [[nodiscard]] Verdict film_at(double T);
  [[nodiscard]] const Tried& nearest(double T) const;
  /// From the root of a near grid; false if there is none near by.
  [[nodiscard]] bool follow(const HeatRoot& near);
  [[nodiscard]] Verdict search();
  /// The root between two points of different sign; false if it did not settle. `slope`: of the
  /// residual there, where the tries are too near to it to tell.
  bool settle(const KnownPoint& a, const KnownPoint& b, double slope);
  /// Leaves the solution at the lowest stable root.
  [[nodiscard]] Verdict take_lowest_stable();
  [[nodiscard]] Verdict no_root(const std::vector<HeatSample>& samples) const;
  [[nodiscard]] bool interrupted() const { return failure_.status == Status::interrupted; }

  Solution& s_;
  const SolveControl& control_;
  bool warm_;
  double T_least_;
  double T_most_;
  std::vector<Tried> tried_;
  Verdict failure_;  ///< of the coolest film that was not found
  double T_failed_ = INFINITY;
};

const Tried& LumpedBalance::nearest(double T) const {
  return *std::min_element(tried_.begin(), tried_.end(), [T](const Tried& a, const Tried& b) {
    return std::abs(a.heat.T - T) < std::abs(b.heat.T - T);
  });
}

Verdict LumpedBalance::film_at(double T) {
  std::fill(s_.film.columns.T.begin(), s_.film.columns.T.end(), T);
  s_.T_film = T;
  if (tried_.empty() && (!warm_ || !failure_.good())) return first_film(s_, T, control_);
  if (!tried_.empty()) {
    const Tried& start = nearest(T);
    s_.film.film = start.film;
    s_.film.position = start.position;
    s_.film.elastic = start.elastic;
  }
  return solve_equilibrium({s_.model, s_.point, {}, {}, control_.stop}, s_.film, s_.cost);
}

std::optional<double> LumpedBalance::residual(double T) {
  // A load that is not carried by the oil of one temperature is not by hotter oil.
  const bool ended = s_.point.load.unknowns > 0 && T >= T_failed_;
  if (interrupted() || ended) return std::nullopt;
  Verdict v = film_at(T);
  const fluid::OilFlows flows =
      v.good() ? fluid::oil_flows(s_.point.scene, s_.film.flow) : fluid::OilFlows{};
  const OilFed fed =
      v.good() ? oil_fed(s_.model.input, s_.point.scene.supply.touching, flows.patch) : OilFed{};
  if (v.good() && !(flows.side > 0.0 && fed.mass > 0.0)) {
    v = {Status::iteration_limit, ending::Plain::no_oil_leaves};
  }
  if (!v.good()) {
    if (T < T_failed_ || v.status == Status::interrupted) failure_ = v;
    T_failed_ = std::min(T, T_failed_);
    return std::nullopt;
  }
  const Friction f = friction_of(s_.model, s_.point, s_.film);
  const double torque = f.torque();
  const double power =
      std::abs(torque * s_.point.omega()) + pump_power(s_.model, s_.point, s_.film);
  const double rate = fed.mass * rheology::heat_capacity(s_.model.oil, 0.5 * (T + fed.T)).cp;
  const double r = fed.T + power / rate - T;
  s_.history.push_back({"lumped", std::abs(r), torque, s_.film.least.h});
  tried_.push_back({{T, 0.0, torque, s_.film.least.h},
                    r,
                    r * rate,
                    s_.film.film,
                    s_.film.position,
                    s_.film.elastic});
  if (control_.progress) {
    control_.progress(
        {"lumped", static_cast<int>(tried_.size()) - 1, std::abs(r), torque, s_.film.least.h});
  }
  return r;
}

bool LumpedBalance::settle(const KnownPoint& a, const KnownPoint& b, double slope) {
  constexpr double kApart = 1e-3;  // far enough for a slope: r is known to 1e-7 K [K]
  const auto r = [this](double T) { return residual(T).value_or(NAN); };
  const BracketedRoot root = bracketed_root(r, a, b, {kKnownTemperature, kKnownTemperature});
  HeatRoot found = nearest(root.at.x).heat;
  found.slope = slope;
  double distance = INFINITY;
  for (const Tried& t : tried_) {
    const double apart = std::abs(t.heat.T - found.T);
    if (apart < kApart || apart >= distance) continue;
    distance = apart;
    found.slope = (t.residual - nearest(found.T).residual) / (t.heat.T - found.T);
  }
  s_.heat_roots.push_back(found);
  return root.found;
}

bool LumpedBalance::follow(const HeatRoot& near) {
  constexpr double kBeyond = 1.5;  // of the way to where the root should be [-]
  constexpr int kMostSteps = 6;
  std::optional<double> r = residual(near.T);
  if (!r) return false;
  KnownPoint here{near.T, *r};
  double step = -kBeyond * here.f / near.slope;
  for (int k = 0; k < kMostSteps && std::abs(here.f) > kKnownTemperature; ++k) {
    const double T = std::clamp(here.x + step, T_least_, T_most_);
    r = residual(T);
    if (!r || T == here.x) return false;
    if ((*r < 0.0) != (here.f < 0.0)) return settle(here, {T, *r}, near.slope);
    here = {T, *r};
    step *= 2.0;
  }
  if (std::abs(here.f) > kKnownTemperature) return false;
  s_.heat_roots.push_back(tried_.back().heat);
  s_.heat_roots.back().slope = near.slope;
  return true;
}

Verdict LumpedBalance::take_lowest_stable() {
  const auto stable = std::find_if(s_.heat_roots.begin(), s_.heat_roots.end(),
                                   [](const HeatRoot& root) { return root.stable(); });
  if (stable == s_.heat_roots.end()) {
    return {Status::no_steady_state,
            ending::AtTemperature{ending::Thermal::unstable_root, s_.heat_roots.front().T}};
  }
  if (s_.T_film == stable->T || residual(stable->T)) return {};
  return failure_;
}

Verdict LumpedBalance::search() {
  // The scan goes on to films of hot oil, of which each may cost as much as all before.
  const double whole = s_.cost.most_work;
  s_.cost.most_work = s_.cost.work + kForStarts * (whole - s_.cost.work);
  const std::vector<HeatSample> samples = scan_heat_balance(
      [this](double T) { return residual(T); }, scan_temperatures(s_.model.oil, T_least_, T_most_));
  s_.cost.most_work = whole;
  const bool none = tried_.empty();
  if (interrupted() || none) return failure_;
  const std::vector<std::size_t> changes = sign_changes(samples);
  if (changes.empty()) return no_root(samples);
  bool settled = true;
  for (auto k = changes.rbegin(); k != changes.rend(); ++k) {  // the lowest last: its film stays
    const HeatSample& a = samples[*k];
    const HeatSample& b = samples[*k + 1];
    const double slope = (*b.residual - *a.residual) / (b.T - a.T);
    settled = settle({a.T, *a.residual}, {b.T, *b.residual}, slope) && settled;
    if (interrupted()) return failure_;
  }
  std::reverse(s_.heat_roots.begin(), s_.heat_roots.end());
  if (settled) return take_lowest_stable();
  Verdict v{Status::iteration_limit,
            ending::AtTemperature{ending::Thermal::unsettled_root, s_.heat_roots.front().T}};
  if (!failure_.good()) v.cause = {failure_};
  return v;
}

Verdict LumpedBalance::no_root(const std::vector<HeatSample>& samples) const {
  const auto good = [](const HeatSample& s) { return s.residual.has_value(); };
  const HeatSample& low = *std::find_if(samples.begin(), samples.end(), good);
  const HeatSample& high = *std::find_if(samples.rbegin(), samples.rend(), good);
  const ending::NoHeatBalance none{low.T, high.T, nearest(low.T).surplus, nearest(high.T).surplus,
                                   T_failed_};
  // Heat that is less than what leaves from the coldest on has its balance below that: pumps that
  // are driven by oil sucked through the bearing, which this balance does not know.
  const bool runaway = failure_.good() && none.surplus_low > 0.0;
  if (failure_.good()) {
    return {runaway ? Status::no_steady_state : Status::iteration_limit, none};
  }
  return {failure_.status, none, failure_.place, {failure_}};
}

Verdict LumpedBalance::run() {
  std::vector<HeatRoot> near;
  near.swap(s_.heat_roots);
  if (warm_ && near.size() == 1) {
    if (follow(near.front())) return take_lowest_stable();
    if (interrupted()) return failure_;
    s_.heat_roots.clear();
    failure_ = {};
    T_failed_ = INFINITY;
  }
  return search();
}

}  // namespace

Verdict solve_lumped(Solution& s, bool warm, const SolveControl& control) {
  return LumpedBalance(s, warm, control).run();
}

}  // namespace shellback::bearing
