#include "bearing/over_time/worn_bearing.hpp"

#include <utility>

#include "bearing/over_time/cycle_search.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// The case with this wear, and with a surface on its way from new to worn.
Case worn_case(const Case& c, const FilmGrid& grid, const Field& wear) {
  Case out = c;
  out.bearing.wear = wear_table(full_grid(grid), mirror_to_full(grid, wear));
  out.surfaces.shell = worn_surface(c, largest(wear));
  return out;
}

Field no_wear(const BearingModel& m) { return Field(m.domain.grid.cells(), 0.0); }

/// The wear of a tape, and the case that has it.
Case read_worn_case(const Case& c, Tape& tape, Field& wear) {
  FilmGrid grid;
  tape(grid, wear);
  return worn_case(c, grid, wear);
}

/// The last good solution with its wear, and the one before.
template <class Held>
class Worn : public WornBearing {
 public:
  [[nodiscard]] const Field& wear() const final { return wear_; }
  void go_back() final {
    now_ = std::move(before_);
    wear_ = std::move(wear_before_);
  }

 protected:
  Worn(const Case& c, Tier tier, const SolveControl& control)
      : case_(c), tier_(tier), control_(control) {}
  /// `next` and its verdict; false, and why, if it has none.
  bool take(Held next, const Verdict& verdict, const Field& wear, Verdict& why) {
    if (!verdict.good()) {
      why = verdict;
      return false;
    }
    before_ = std::exchange(now_, std::move(next));
    wear_before_ = std::exchange(wear_, wear);
    return true;
  }

  Case case_;
  Tier tier_;
  const SolveControl& control_;
  Held now_{};
  Field wear_;

 private:
  Held before_{};
  Field wear_before_;
};

class UnderStandingLoad final : public Worn<Solution> {
 public:
  UnderStandingLoad(const Case& c, Tier tier, const SolveControl& control)
      : Worn(c, tier, control) {
    now_ = solve_tier(c, tier, control);
    wear_ = no_wear(now_.model);
  }
  UnderStandingLoad(const Case& c, Tier tier, const SolveControl& control, Tape& tape)
      : Worn(c, tier, control) {
    const Case worn = read_worn_case(c, tape, wear_);
    now_.model = make_bearing(worn, physics_of(worn, tier), worn.model.grid);
    now_.point = operating_point(now_.model);
    tape(now_);
  }

  [[nodiscard]] const Verdict& verdict() const override { return now_.verdict; }
  [[nodiscard]] const BearingModel& model() const override { return now_.model; }
  [[nodiscard]] WearLoad load() const override {
    return wear_load_of(now_.model, now_.point, now_.film, case_.running_in->limit_pressure);
  }
  [[nodiscard]] const Field& contact() const override { return now_.film.p_contact; }
  [[nodiscard]] const Field& gap() const override { return now_.film.gap.cell; }

  bool wear_to(const Field& wear, double within, Verdict& why) override {
    SolveControl control = control_;
    control.heat_within = within / now_.model.clearance;
    const Case worn = worn_case(case_, now_.model.domain.grid, wear);
    Solution next = solve_tier_from(worn, tier_, now_, control, Otherwise::failure);
    const Verdict ended = next.verdict;
    return take(std::move(next), ended, wear, why);
  }
  bool wear_from_cold(const Field& wear, Verdict& why) override {
    const Case worn = worn_case(case_, now_.model.domain.grid, wear);
    Solution next = solve_tier(worn, tier_, control_, now_.model.solids);
    const Verdict ended = next.verdict;
    return take(std::move(next), ended, wear, why);
  }

  void tell(RunningInState& state, RunningInRun& run) const override {
    state.p_asperity_max = largest(now_.film.p_contact);
    state.torque = friction_of(now_.model, now_.point, now_.film).torque();
    state.h_min = now_.film.least.h;
    run.solution = now_;
  }
  void keep(Tape& tape) override { tape(now_.model.domain.grid, wear_, now_); }
};

class OverLoadCycle final : public Worn<std::unique_ptr<CycleSearch>> {
 public:
  OverLoadCycle(const Case& c, Tier tier, const SolveControl& control) : Worn(c, tier, control) {
    Cost cost;
    now_ = search_cycle(c, tier, control, cost);
    wear_ = no_wear(model());
  }
  OverLoadCycle(const Case& c, Tier tier, const SolveControl& control, Tape& tape)
      : Worn(c, tier, control) {
    const Case worn = read_worn_case(c, tape, wear_);
    now_ = std::make_unique<CycleSearch>(worn, tier, physics_of(worn, tier), control);
    now_->ended(tape);
  }

  [[nodiscard]] const Verdict& verdict() const override { return now_->verdict(); }
  [[nodiscard]] const BearingModel& model() const override { return now_->film().model(); }
  [[nodiscard]] WearLoad load() const override { return now_->told().wear_load(); }
  [[nodiscard]] const Field& contact() const override { return now_->told().largest_contact(); }
  [[nodiscard]] const Field& gap() const override { return now_->told().smallest_gap(); }

  bool wear_to(const Field& wear, double /*within*/, Verdict& why) override {
    const Case worn = worn_case(case_, model().domain.grid, wear);
    auto next = std::make_unique<CycleSearch>(worn, tier_, physics_of(worn, tier_), control_,
                                              model().solids);
    if (next->begin_reshaped(*now_)) static_cast<void>(next->follow());
    const Verdict ended = next->verdict();
    return take(std::move(next), ended, wear, why);
  }
  bool wear_from_cold(const Field& wear, Verdict& why) override {
    const Case worn = worn_case(case_, model().domain.grid, wear);
    Cost cost;
    auto next = search_cycle(worn, tier_, control_, cost);
    const Verdict ended = next->verdict();
    return take(std::move(next), ended, wear, why);
  }

  void tell(RunningInState& state, RunningInRun& run) const override {
    CycleResult r = now_->result();
    state.p_asperity_max = value_of(r, "p_asperity_max");
    state.torque = value_of(r, "friction_torque");
    state.h_min = value_of(r, "h_min");
    state.cycles = r.cycles;
    run.cycle = std::move(r);
  }
  void keep(Tape& tape) override {
    FilmGrid grid = model().domain.grid;
    tape(grid, wear_);
    now_->ended(tape);
  }
};

}  // namespace

std::unique_ptr<WornBearing> new_bearing(const Case& c, Tier tier, const SolveControl& control) {
  if (c.cycle) return std::make_unique<OverLoadCycle>(c, tier, control);
  return std::make_unique<UnderStandingLoad>(c, tier, control);
}

std::unique_ptr<WornBearing> kept_bearing(const Case& c, Tier tier, const SolveControl& control,
                                          Tape& tape) {
  if (c.cycle) return std::make_unique<OverLoadCycle>(c, tier, control, tape);
  return std::make_unique<UnderStandingLoad>(c, tier, control, tape);
}

}  // namespace shellback::bearing
