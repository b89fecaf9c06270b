#include "bearing/over_time/running_in.hpp"

#include <optional>

#include "bearing/over_time/wear_march.hpp"
#include "bearing/over_time/worn_in_shape.hpp"
#include "bearing/pressed_layer.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Where the states that were followed ended first, and how often; never: nothing.
std::optional<note::StatesEnd> states_end(const std::vector<RunningInState>& states, bool flows) {
  std::optional<note::StatesEnd> ends;
  for (std::size_t k = 1; k < states.size(); ++k) {
    if (!states[k].anew) continue;
    if (!ends)
      ends = note::StatesEnd{states[k].t, states[k - 1].torque, states[k].torque, 0, flows};
    ++ends->times;
  }
  return ends;
}

}  // namespace

void expect_running_in(const Case& c, Tier tier) {
  if (!c.running_in) {
    throw InputError(c.path,
                     "there is no [running_in]; give wear_coefficient = \"1e-8\" and until = "
                     "\"200 s\" or \"worn_in\" with limit_pressure = \"5 MPa\"");
  }
  if (tier != Tier::isothermal && tier != Tier::thd && tier != Tier::tehd) {
    throw InputError("model.tier", "running-in needs a solved film; take isothermal, thd or tehd");
  }
  if (c.cycle && !c.cycle->repeats()) {
    throw InputError("running_in.until",
                     "a single event does not run a bearing in: wear needs a mean over a cycle; "
                     "give load_cycle.period, or leave out [load_cycle] and give operation.load");
  }
}

RunningInRun run_in(const Case& c, Tier tier, const SolveControl& control,
                    const std::function<void(const RunningInRun&)>& seen,
                    const std::vector<double>& steps) {
  expect_running_in(c, tier);
  RunningInRun run;
  SolveControl within = control;  // of each shape; kept is what lies between them
  within.kept = nullptr;
  Tape* tape = control.kept != nullptr ? control.kept->under_way() : nullptr;
  const auto b =
      tape != nullptr ? kept_bearing(c, tier, within, *tape) : new_bearing(c, tier, within);
  run.verdict = b->verdict();
  if (!run.verdict.good()) return run;
  if (tape != nullptr) {
    members(*tape, *b, run);
  } else {
    note_state(*b, 0.0, 0.0, {}, b->wear(), run);
  }
  if (seen) seen(run);
  if (!steps.empty()) {
    WearMarch(*b, c, control, seen, run).through(steps);
  } else if (c.running_in->duration) {
    WearMarch(*b, c, control, seen, run).to(*c.running_in->duration);
  } else {
    find_worn_in(*b, control, c.running_in->limit_pressure, run);
  }
  const bool flows = pressed_layer(c, 0).has_value() && b->model().physics.elastic;
  if (flows && !c.cycle) run.warnings.emplace_back(note::Plain::marks_begin_anew);
  const double depth = run.states.back().depth;
  if (run.verdict.good() && depth <= kComplementarity * b->model().contact->sigma()) {
    run.warnings.emplace_back(note::Plain::nothing_wears);
  }
  if (!c.running_in->worn) run.warnings.emplace_back(note::Plain::roughness_stays);
  if (const auto ends = states_end(run.states, flows)) run.warnings.emplace_back(*ends);
  if (c.shell && !c.shell->layers.empty() && depth > c.shell->layers.front().thickness) {
    run.warnings.emplace_back(note::WornThrough{depth, c.shell->layers.front().thickness});
  }
  if (depth > c.bearing.radial_clearance) {
    run.warnings.emplace_back(note::WornBeyondClearance{depth, c.bearing.radial_clearance});
  }
  if (const double edge = largest(wear_table(run.grid, run.wear).height); edge > depth) {
    run.warnings.emplace_back(note::WearLedOn{depth, edge});
  }
  return run;
}

}  // namespace shellback::bearing
