#include "proof/honesty.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "coupling/judge_case.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/solve.hpp"

namespace shellback::proof {

using namespace coupling;
using fidelity::value_in;

namespace {

/// Everything of one case, filled by one task.
struct Subject {
  bool finished = false;
  std::vector<BarSample> samples;
  std::vector<HonestyRefusal> refusals;
  std::vector<BarCost> costs;
};

/// Quantities on the fine grid, and at the limit of fine grids; empty: no result.
struct Truth {
  std::vector<Quantity> values;
  std::vector<Quantity> limit;
};

class Trial {
 public:
  Trial(const Case& c, int index, const HonestyOptions& options)
      : case_(c), index_(index), options_(options), control_{{}, options.stop} {}

  /// The working grids first: where they give no result, there is no bar whose truth is wanted.
  Subject run() {
    const auto possible = coupling::possible_tiers(case_);
    fullest_ = possible.empty() ? Tier::tehd : possible.back();
    for (const Tier tier : options_.tiers) {
      if (std::find(possible.begin(), possible.end(), tier) == possible.end()) continue;
      const std::size_t first = subject_.samples.size();
      for (const auto& grid : options_.grids) judge(tier, grid);
      if (subject_.samples.size() > first) fill(first, truth(tier));
    }
    fill_full_truth();
    subject_.finished = !stopped();
    return std::move(subject_);
  }

 private:
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  void refuse(Tier tier, std::array<int, 2> grid, const std::string& status,
              const std::string& reason) {
    if (!stopped()) subject_.refusals.push_back({index_, tier, grid, status, reason});
  }

  /// The converged solution; a refusal is noted.
  bool solved(Tier tier, std::array<int, 2> grid, int nodes, Solution& s) {
    if (stopped()) return false;
    Case c = case_;
    c.model.tier = tier;
    c.model.grid = grid;
    c.model.film_nodes = nodes;
    try {
      s = solve_tier(c, tier, control_);
    } catch (const InputError& error) {
      refuse(tier, grid, "input", error.what());
      return false;
    }
    if (!s.verdict.good()) refuse(tier, grid, to_string(s.verdict.status), s.verdict.reason);
    return s.verdict.good();
  }

  /// The values of `s` carried to the limit of fine grids, from its own two finest.
  [[nodiscard]] static std::vector<Quantity> limit_of(const Solution& s,
                                                      std::vector<Quantity> values) {
    const std::size_t n = s.levels.size();
    if (n < 2) return {};
    const auto cells = [&](std::size_t k) { return s.levels[k].grid[0] * s.levels[k].grid[1]; };
    const double ratio = std::sqrt(static_cast<double>(cells(n - 1)) / cells(n - 2));
    for (Quantity& q : values) {
      const double step = q.value - value_in(s.levels[n - 2].quantities, q.name);
      q.value += step / (std::pow(ratio, kLimitOrder) - 1.0);
    }
    return values;
  }

  Truth truth(Tier tier) {
    if (tier == fullest_ && full_tried_) return full_;
    Solution s;
    Truth found;
    if (solved(tier, options_.truth_grid, options_.truth_nodes, s)) {
      found.values = quantities_of(s, tier);
      found.limit = limit_of(s, found.values);
    }
    if (tier == fullest_) {
      full_tried_ = true;
      full_ = found;
    }
    return found;
  }

  void fill(std::size_t first, const Truth& truth) {
    for (std::size_t k = first; k < subject_.samples.size(); ++k) {
      BarSample& s = subject_.samples[k];
      s.truth_tier = value_in(truth.values, s.quantity);
      s.truth_limit = value_in(truth.limit, s.quantity);
    }
  }

  /// The truth of the fullest tier, solved already or wanted for the model bars of those below.
  void fill_full_truth() {
    const auto known = [](const BarSample& s) { return std::isfinite(s.error_model); };
    if (!full_tried_ && std::any_of(subject_.samples.begin(), subject_.samples.end(), known)) {
      full_ = truth(fullest_);
    }
    for (BarSample& s : subject_.samples) s.truth_full = value_in(full_.values, s.quantity);
  }

  void judge(Tier tier, std::array<int, 2> grid) {
    Solution s;
    if (!solved(tier, grid, case_.model.film_nodes, s)) return;
    const auto record = fidelity::measure_bars(s, tier, control_);
    Result result = coupling::summarize(s, tier);
    fidelity::put_bars(record, result);
    subject_.costs.push_back({tier, grid, s.wall_s, record.wall_s});
    const double T_supply = case_.supplies.front().temperature;
    for (const Quantity& q : result.quantities) {
      BarSample b{index_, tier, grid, q.name};
      b.value = q.value;
      b.size = fidelity::natural_size(q, T_supply, result.quantities);
      b.error_grid = q.error_grid;
      b.error_model = q.error_model;
      b.truth_tier = b.truth_limit = b.truth_full = NAN;
      b.given = fidelity::given_by_case(case_, tier, q.name);
      b.richest = record.model.richest;
      b.node_change = value_in(record.node_change, q.name);
      b.model_change = value_in(record.model.change, q.name);
      for (const LevelRecord& level : record.levels) {
        b.levels.push_back(value_in(level.quantities, q.name));
        b.sizes.push_back(1.0 / std::sqrt(level.grid[0] * level.grid[1]));
      }
      subject_.samples.push_back(std::move(b));
    }
  }

  Tier fullest_ = Tier::tehd;
  Truth full_;
  bool full_tried_ = false;
  const Case& case_;
  int index_;
  const HonestyOptions& options_;
  SolveControl control_;
  Subject subject_;
};

double error_of(const BarSample& s, BarKind kind) {
  const double truth = kind == BarKind::grid    ? s.truth_tier
                       : kind == BarKind::limit ? s.truth_limit
                                                : s.truth_full;
  return std::abs(s.value - truth);
}

bool bar_known(const BarSample& s, BarKind kind) {
  if (kind == BarKind::total && !std::isfinite(s.error_model) && !s.richest) return false;
  return std::isfinite(s.error_grid);
}

}  // namespace

HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                              const HonestyOptions& options) {
  const int count = static_cast<int>(cases.size());
  std::vector<Subject> subjects(count);
  std::mutex guard;
  int done = 0;
  parallel_for(count, options.threads, [&](int k) {
    if (options.stop != nullptr && options.stop->load()) return;
    subjects[k] = Trial(cases[k].input, k, options).run();
    const std::lock_guard lock(guard);
    if (options.progress) options.progress(++done, count);
  });
  HonestyRecord out;
  for (int k = 0; k < count; ++k) {
    out.subjects.push_back(cases[k].input.title);
    out.sets.push_back(cases[k].set);
    out.finished.push_back(subjects[k].finished);
    if (!subjects[k].finished) continue;
    const auto take = [](auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
    take(subjects[k].samples, out.samples);
    take(subjects[k].refusals, out.refusals);
    take(subjects[k].costs, out.costs);
  }
  return out;
}

bool testable(const BarSample& s, BarKind kind) {
  constexpr double kExact = 1e-9;  // both bar and error below this part of the size are round-off
  if (!bar_known(s, kind) || (s.given && (kind != BarKind::total || s.richest))) return false;
  const BarAgainstError b = bar_against_error(s, kind);
  return std::isfinite(b.error) && std::isfinite(b.bar) && std::max(b.bar, b.error) > kExact;
}

BarAgainstError bar_against_error(const BarSample& s, BarKind kind) {
  double bar = s.error_grid;
  if (kind == BarKind::total && std::isfinite(s.error_model)) bar += s.error_model;
  return {bar / s.size, error_of(s, kind) / s.size};
}

Coverage coverage_of(const std::vector<BarSample>& samples, BarKind kind) {
  Coverage c;
  int held = 0;
  std::vector<double> ratios;
  for (const BarSample& s : samples) {
    const bool truth = std::isfinite(error_of(s, kind));
    if (truth && !bar_known(s, kind)) ++c.unknown;
    if (!testable(s, kind)) continue;
    const BarAgainstError b = bar_against_error(s, kind);
    held += b.error <= b.bar;
    ratios.push_back(b.error > 0.0 ? b.bar / b.error : INFINITY);
  }
  c.count = static_cast<int>(ratios.size());
  if (c.count == 0) return c;
  c.held = static_cast<double>(held) / c.count;
  std::nth_element(ratios.begin(), ratios.begin() + c.count / 2, ratios.end());
  c.median = ratios[c.count / 2];
  return c;
}

}  // namespace shellback::proof
