#pragma once
/// Solutions that a test needs before it begins: not found is a failed test that says why.
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "tests/bearing/sample_bearing.hpp"

namespace shellback::bearing::tests {

inline Solution solved(const Case& c, Tier tier) {
  Solution s = solve_tier(c, tier);
  INFO(c.title << ": " << app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  return s;
}

/// Of the standing load that a case has beside its cycle.
inline Quantities steady_values(Case c) {
  c.cycle.reset();
  return solve(c).values();
}

inline CycleResult converged(const Case& c, Tier tier = Tier::isothermal) {
  CycleResult r = solve_cycle(c, tier);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.audit.mass < 1e-12);  // carried as what flows: round-off
  // Films are solved to 1e-5 of their largest flow, and a step lets at most about the gap's oil
  // pass.
  CHECK(r.audit.content < 2e-5);
  return r;
}

inline const CycleQuantity& named(const CycleResult& r, const std::string& name) {
  const CycleQuantity* q = quantity_named(r, name);
  if (q == nullptr) throw std::runtime_error("no quantity " + name);
  return *q;
}

inline double value(const CycleResult& r, const std::string& name) {
  return named(r, name).quantity.value;
}

}  // namespace shellback::bearing::tests
