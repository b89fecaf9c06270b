#include "bearing/march_over_cycles.hpp"
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
  CycleSearch search(c, tier, control);
  search.begin(c.supplies.front().temperature);
  out.solution.model = search.film().model();
  Bodies bodies = uniform_bodies(*out.solution.model.solids, o.T_start);
  MarchSpan span;
  span.duration = o.end;
  span.first = span.shortest = c.cycle->length();
  out.end =
      march_over_cycles(search, span, bodies, [&](const Instant& i) { out.instants.push_back(i); });
  out.solution.verdict = out.end.verdict;
  return out;
}

}  // namespace shellback::bearing
