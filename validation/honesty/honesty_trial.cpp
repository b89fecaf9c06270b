#include "validation/honesty/honesty_trial.hpp"

#include <algorithm>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "bearing/judge/judge_case.hpp"
#include "core/contract.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/solve.hpp"

namespace shellback::validation {

using namespace bearing;
using bearing::value_in;

namespace {

/// Quantities on the fine grid, and at the limit of fine grids; empty: no result.
struct Truth {
  std::vector<Quantity> values;
  std::vector<Quantity> limit;
};

class Trial {
 public:
  Trial(const Case& c, int index, const HonestyOptions& options, const std::atomic<bool>* stop)
      : case_(c), index_(index), options_(options), stop_(stop), control_{{}, stop} {}

  /// All bars first, so that those are counted whose truth the budget does not reach.
  HonestySubject run() {
    const auto possible = bearing::possible_tiers(case_);
    fullest_ = possible.empty() ? Tier::tehd : possible.back();
    for (const Tier tier : options_.tiers) {
      if (std::find(possible.begin(), possible.end(), tier) == possible.end()) continue;
      for (const auto& grid : options_.grids) judge(tier, grid);
    }
    for (const Tier tier : options_.tiers) fill(tier);
    fill_full_truth();
    subject_.end = stopped() ? CaseEnd::over_budget : CaseEnd::done;
    return std::move(subject_);
  }

 private:
  [[nodiscard]] bool stopped() const { return stop_ != nullptr && stop_->load(); }

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
    if (!s.verdict.good())
      refuse(tier, grid, to_string(s.verdict.status), app::reason_of(s.verdict));
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

  /// The truth of a tier's bars; where the working grids gave none, no truth is wanted.
  void fill(Tier tier) {
    const auto of_tier = [tier](const BarSample& s) { return s.tier == tier; };
    if (std::none_of(subject_.samples.begin(), subject_.samples.end(), of_tier)) return;
    const Truth found = truth(tier);
    for (BarSample& s : subject_.samples) {
      if (!of_tier(s)) continue;
      s.truth_tier = value_in(found.values, s.quantity);
      s.truth_limit = value_in(found.limit, s.quantity);
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
    Result result = bearing::summarize(s, tier);
    fidelity::put_bars(record, result);
    subject_.costs.push_back({tier, grid, s.wall_s, record.wall_s});
    const double T_supply = mean_supply_temperature(case_);
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
  const std::atomic<bool>* stop_;
  SolveControl control_;
  HonestySubject subject_;
};

}  // namespace

HonestySubject try_bars(const Case& c, int index, const HonestyOptions& options,
                        const std::atomic<bool>* stop) {
  return Trial(c, index, options, stop).run();
}

}  // namespace shellback::validation
