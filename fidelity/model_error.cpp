#include "fidelity/model_error.hpp"

#include <cmath>

#include "fidelity/richer_physics.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

double relative_change(const CoarseSolution& from, const CoarseSolution& to, const char* name) {
  const double before = value_in(from.quantities, name);
  return (value_in(to.quantities, name) - before) / std::abs(before);
}

EffectChange change_between(const std::string& effect, const CoarseSolution& from,
                            const CoarseSolution& to) {
  return {effect, relative_change(from, to, "friction_torque"), relative_change(from, to, "h_min")};
}

}  // namespace

ModelError model_error(const CoarseSolution& near, const SolveControl& control) {
  ModelError out;
  out.unknown = unknown_effects(near.input);
  const auto steps = richer_physics(near.input, near.tier);
  if (steps.empty()) {
    out.richest = true;
    return out;
  }
  std::optional<CoarseSolution> here;
  for (const PhysicsStep& step : steps) {
    const CoarseSolution& before = here ? *here : near;
    auto next = solve_changed(step.input, step.tier, before, control);
    out.complete = next.has_value();
    if (!next) {
      out.failed.push_back(step.effect);
      continue;
    }
    out.effects.push_back(change_between(step.effect, before, *next));
    here = std::move(next);
  }
  if (!out.complete) return out;
  for (const Quantity& q : near.quantities) {
    const double full = value_in(here->quantities, q.name);
    if (std::isfinite(full)) out.change.push_back({q.name, full - q.value, q.unit, NAN, NAN});
  }
  return out;
}

std::vector<EffectChange> effects_of_included(const CoarseSolution& near,
                                              const SolveControl& control) {
  std::vector<EffectChange> out;
  for (const PhysicsStep& step : poorer_physics(near.input, near.tier)) {
    const auto without = solve_changed(step.input, step.tier, near, control);
    if (without) out.push_back(change_between(step.effect, *without, near));
  }
  return out;
}

}  // namespace shellback::fidelity
