#include "bearing/kept_run.hpp"
#include "bearing/march_members.hpp"
#include "bearing/warm_up.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {

WarmUp warm_up_over_cycles(const Case& c, Tier tier, const WarmUpOptions& o,
                           const SolveControl& control) {
  if (!c.cycle->repeats()) {
    throw InputError("load_cycle.period",
                     "a warm-up passes many cycles, and the case has a single event; give its "
                     "period");
  }
  WarmUp out;
  SolveControl within = control;  // of each cycle; kept is what lies between them
  within.kept = nullptr;
  CycleSearch search(c, tier, within);
  CycleMarch march;
  const auto members = [&](Tape& tape) {
    tape(out.instants, march);
    search.ended(tape);
  };
  if (!take_up_noted(control.kept, members)) {
    search.begin(c.supplies.front().temperature);
    march.bodies = uniform_bodies(*search.film().model().solids, o.T_start);
  }
  out.solution.model = search.film().model();
  MarchSpan span;
  span.duration = o.end;
  span.first = span.shortest = c.cycle->length();
  out.end = march_over_cycles(search, span, march, [&](const Instant& i) {
    out.instants.push_back(i);
    keep_between(control.kept, members);
  });
  keep_stopped(control.kept, out.end.verdict);
  out.solution.verdict = out.end.verdict;
  return out;
}

}  // namespace shellback::bearing
