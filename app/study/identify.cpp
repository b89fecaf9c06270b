#include "app/study/identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/study/predictor.hpp"
#include "bearing/bearing.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"

namespace shellback::study {

using bearing::Case;
using bearing::Solution;
using bearing::Tier;

namespace {

using Known = std::shared_ptr<const Solution>;
using Values = std::vector<double>;

struct Stretch {
  int low = 0;
  int high = 0;
};

/// All used points at one set of keys.
struct Computed {
  std::vector<Values> values;  ///< of every point, in the order of its measured ones
  std::vector<Known> films;
};

/// The measured points as a function of the keys.
class MeasuredBearing {
 public:
  MeasuredBearing(const std::vector<MeasuredPoint>& points, const MeasuredCase& case_at,
                  const IdentifyOptions& options)
      : points_(points), case_at_(case_at), options_(options), kept_(points.size()) {}

  /// Values of every point, in the order of its measured ones; empty: not found. Along the curves.
  std::vector<Values> first(const Values& x, std::vector<FittedPoint>& out);
  /// The same near the films kept; `used` says which are asked for. Nothing if one is not found.
  [[nodiscard]] std::optional<Computed> near(const Values& x, const std::vector<char>& used) const;
  /// What points start from: the films of a step that was accepted.
  void keep(std::vector<Known> films) { kept_ = std::move(films); }

 private:
  [[nodiscard]] std::vector<Stretch> curves() const;
  void walk(const Stretch& curve, const Values& x, std::vector<FittedPoint>& out);
  [[nodiscard]] Known found_near(int i, const Values& x) const;
  [[nodiscard]] Values values_of(int i, const Solution& s) const;
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  [[nodiscard]] bearing::SolveControl control() const { return {{}, options_.stop}; }

  const std::vector<MeasuredPoint>& points_;
  const MeasuredCase& case_at_;
  const IdentifyOptions& options_;
  std::vector<Known> kept_;
};

std::vector<Stretch> MeasuredBearing::curves() const {
  std::vector<Stretch> all;
  const int n = static_cast<int>(points_.size());
  for (int i = 0; i < n; ++i) {
    if (i == 0 || points_[i].curve != points_[i - 1].curve) all.push_back({i, i});
    all.back().high = i + 1;
  }
  return all;
}

Values MeasuredBearing::values_of(int i, const Solution& s) const {
  const Tier tier = s.model.input.model.tier;
  const auto all = bearing::quantities_of(s, tier);
  Values out;
  for (const MeasuredValue& m : points_[i].values) {
    const auto q =
        std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == m.quantity; });
    if (q == all.end()) {
      throw InputError(points_[i].name,
                       fmt::format("tier {} does not compute {}; leave the column out or take "
                                   "another tier",
                                   to_string(tier), m.quantity));
    }
    out.push_back(q->value);
  }
  return out;
}

void MeasuredBearing::walk(const Stretch& curve, const Values& x, std::vector<FittedPoint>& out) {
  const int n = curve.high - curve.low;
  Values index(n);
  std::iota(index.begin(), index.end(), 0.0);
  const Axis axis = listed_axis("point", index, "");
  std::vector<SweepPoint> points(n);
  std::vector<SweepPoint*> places;
  for (SweepPoint& p : points) places.push_back(&p);
  SweepOptions sweep;
  sweep.stop = options_.stop;
  sweep.sum_up = [](const Solution&, Tier, const bearing::SolveControl&) {
    return bearing::Result{};  // the solution itself is kept
  };
  Curve walked(
      axis, [&](double at) { return case_at_(curve.low + at, x); }, places, sweep,
      [&](int k, const Known& solution) { kept_[curve.low + k] = solution; });
  walked.solve_piece(0, n);
  walked.mend();
  for (int k = 0; k < n; ++k) out[curve.low + k].verdict = points[k].result.verdict;
}

std::vector<Values> MeasuredBearing::first(const Values& x, std::vector<FittedPoint>& out) {
  const std::vector<Stretch> all = curves();
  parallel_for(static_cast<int>(all.size()), options_.threads,
               [&](int c) { walk(all[c], x, out); });
  std::vector<Values> values(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (kept_[i]) values[i] = values_of(static_cast<int>(i), *kept_[i]);
  }
  return values;
}

/// From its own film, from that of a neighbour, then from cold.
Known MeasuredBearing::found_near(int i, const Values& x) const {
  const Case subject = case_at_(i, x);
  const Tier tier = subject.model.tier;
  const auto good = [](Solution&& s) {
    return s.verdict.good() ? std::make_shared<const Solution>(std::move(s)) : nullptr;
  };
  for (const int from : {i, i - 1, i + 1}) {
    if (from < 0 || from >= static_cast<int>(kept_.size()) || !kept_[from] || stopped()) continue;
    if (points_[from].curve != points_[i].curve) continue;
    if (!can_follow(subject, kept_[from]->model.input)) continue;  // a key moves the grid
    if (Known s = good(
            solve_tier_from(subject, tier, *kept_[from], control(), bearing::Otherwise::failure))) {
      return s;
    }
  }
  if (stopped()) return nullptr;
  return good(solve_tier(subject, tier, control()));
}

std::optional<Computed> MeasuredBearing::near(const Values& x,
                                              const std::vector<char>& used) const {
  const int n = static_cast<int>(points_.size());
  Computed out{std::vector<Values>(n), std::vector<Known>(n)};
  parallel_for(n, options_.threads, [&](int i) {
    if (used[i] != 0) out.films[i] = found_near(i, x);
  });
  for (int i = 0; i < n; ++i) {
    if (used[i] == 0) continue;
    if (!out.films[i]) return std::nullopt;
    out.values[i] = values_of(i, *out.films[i]);
  }
  return out;
}

/// Every case that the search begins or can end with, read before any work.
void read_all(const std::vector<MeasuredPoint>& measured, const std::vector<FitParameter>& keys,
              const MeasuredCase& case_at) {
  std::size_t known = 0;
  for (const MeasuredPoint& m : measured) known += m.values.size();
  if (known < keys.size()) {
    throw InputError("--fit", fmt::format("{} measured value{} cannot determine {} keys; give more "
                                          "points, or fit fewer keys",
                                          known, known == 1 ? "" : "s", keys.size()));
  }
  Values start;
  for (const FitParameter& k : keys) start.push_back(k.start);
  for (std::size_t j = 0; j < keys.size(); ++j) {
    for (const double bound : {keys[j].low, keys[j].high}) {
      Values x = start;
      x[j] = bound;
      static_cast<void>(case_at(0.0, x));
    }
  }
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const Case c = case_at(static_cast<double>(i), start);
    const Tier tier = c.model.tier;
    if (tier == Tier::estimate || tier == Tier::automatic) {
      throw InputError("model.tier", fmt::format("keys cannot be identified in tier {}; name one "
                                                 "of isothermal, lumped, thd, tehd",
                                                 to_string(tier)));
    }
    if (c.cycle) {
      throw InputError("load_cycle",
                       "keys are identified on steady points, not over load cycles; take a case "
                       "with operation.load");
    }
    static_cast<void>(make_bearing(c, {}, c.model.grid));  // what the grid cannot carry
  }
}

/// The step with the least chi2, which is the last that was accepted: no step goes up.
struct Best {
  double chi2 = INFINITY;
  std::vector<Values> values;
};

/// r as a function of the keys; `best` and the films that points start from follow the steps that
/// are accepted.
std::function<std::optional<Values>(const Values&, Purpose)> residual_function(
    const std::vector<MeasuredPoint>& measured, const std::vector<Values>& deviations,
    const std::vector<char>& used, MeasuredBearing& bearing, Best& best,
    const IdentifyOptions& options) {
  auto now = std::make_shared<IdentifyProgress>();
  return [&, now](const Values& x, Purpose purpose) -> std::optional<Values> {
    std::optional<Computed> computed = bearing.near(x, used);
    if (!computed) return std::nullopt;
    Values r = residuals_of(measured, deviations, computed->values);
    ++now->evaluation;
    if (purpose == Purpose::step) {
      now->chi2 = 0.0;
      for (const double v : r) now->chi2 += v * v;
      if (now->chi2 < best.chi2) {
        best = {now->chi2, std::move(computed->values)};
        bearing.keep(std::move(computed->films));
      }
    }
    if (options.progress) options.progress(*now);
    return r;
  };
}

}  // namespace

int Identification::lost() const {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [](const auto& p) { return !p.used(); }));
}

int Identification::values_used(const std::vector<MeasuredPoint>& measured) const {
  std::size_t n = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (points[i].used()) n += measured[i].values.size();
  }
  return static_cast<int>(n);
}

double accuracy_of(Tier tier) {
  constexpr double kFilm = 1e-8;  // EquilibriumOptions: elastic, the coarsest that torque feels [-]
  constexpr double kHeat = 3e-4 * 10.0;  // ThermalOptions::tolerance, in units of 10 K [K]
  constexpr double kSlope = 0.035;       // of ln viscosity at working temperatures [1/K], textbook
  return tier == Tier::isothermal ? kFilm : kHeat * kSlope;
}

Identification identify(const std::vector<MeasuredPoint>& measured,
                        const std::vector<FitParameter>& keys, const MeasuredCase& case_at,
                        const IdentifyOptions& options) {
  EXPECTS(!measured.empty() && !keys.empty() && options.threads >= 1);
  const Stopwatch watch;
  read_all(measured, keys, case_at);
  Identification out;
  out.points.resize(measured.size());
  Values start;
  for (const FitParameter& k : keys) start.push_back(k.start);
  out.accuracy = accuracy_of(case_at(0.0, start).model.tier);
  MeasuredBearing bearing(measured, case_at, options);
  const std::vector<Values> computed = bearing.first(start, out.points);
  std::vector<char> used;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    out.points[i].start = computed[i];
    used.push_back(out.points[i].used() ? 1 : 0);
  }
  const std::vector<Values> deviations = deviations_of(measured);
  Best best;
  FitProblem p;
  p.parameters = keys;
  p.accuracy = out.accuracy;
  p.noise = noise_of(deviations, computed, out.accuracy);
  p.deviations_known = deviations_known(measured);
  p.stopped = [&options] { return options.stop != nullptr && options.stop->load(); };
  p.residuals = residual_function(measured, deviations, used, bearing, best, options);
  out.fit = fit_bounded(p);
  for (std::size_t i = 0; i < best.values.size(); ++i) {
    out.points[i].fitted = std::move(best.values[i]);
  }
  out.wall_s = watch.seconds();
  return out;
}

}  // namespace shellback::study
