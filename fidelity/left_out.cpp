#include "fidelity/left_out.hpp"

#include <cmath>

#include "fidelity/grid_sequence.hpp"
#include "fidelity/quantities.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

bool has_contact(const Case& c) { return c.surfaces.contact.has_value(); }
bool is_rough(const Case& c) {
  return c.surfaces.shell.roughness > 0.0 || c.surfaces.shaft.roughness > 0.0;
}
bool is_piezoviscous(const Case& c) {
  return !std::holds_alternative<rheology::NoPressureEffect>(c.oil.pressure);
}
bool is_thinning(const Case& c) { return rheology::thins(c.oil); }

}  // namespace

const std::vector<EffectRule>& effect_rules() {
  using P = Physics;
  using S = Switches;
  static const std::vector<EffectRule> rules{
      {EffectKind::temperature_across_film, {{&P::film_energy, nullptr, knows_its_walls}}},
      {EffectKind::thermal_deformation,
       {{&P::thermal_deformation, &S::thermal_deformation, knows_its_walls}}},
      {EffectKind::elastic_deformation, {{&P::elastic, &S::elastic_deformation, can_be_elastic}}},
      {EffectKind::viscosity_with_pressure,
       {{&P::pressure_dependence, &S::pressure_dependence, is_piezoviscous}}},
      {EffectKind::shear_thinning, {{&P::shear_thinning, &S::shear_thinning, is_thinning}}},
      {EffectKind::roughness_and_contact,
       {{&P::flow_factors, &S::flow_factors, is_rough},
        {&P::contact, &S::asperity_contact, has_contact}}},
  };
  return rules;
}

Physics without(EffectKind effect, Physics physics) {
  for (const EffectRule& rule : effect_rules()) {
    if (rule.effect != effect) continue;
    for (const EffectRule::Part& part : rule.parts) physics.*part.has = false;
  }
  return physics;
}

bool switch_off(EffectKind effect, const Switches& given, Switches& switches) {
  for (const EffectRule& rule : effect_rules()) {
    if (rule.effect != effect) continue;
    for (const EffectRule::Part& part : rule.parts) {
      if (part.wish == nullptr || given.*part.wish) return false;
    }
    for (const EffectRule::Part& part : rule.parts) switches.*part.wish = false;
    return true;
  }
  return false;
}

bool knows_its_walls(const Case& c) { return c.shell && c.shaft && heat_leaves(*c.shell); }

std::vector<PhysicsStep> richer_physics(const Case& c, Tier tier) {
  const Physics has = physics_of(c, tier);
  Case input = c;
  input.model.tier = tier;
  input.model.switches.elastic_deformation = has.elastic;  // not to change with the tier
  input.model.switches.thermal_deformation = has.thermal_deformation;
  std::vector<PhysicsStep> steps;
  if (tier == Tier::isothermal) {
    input.model.tier = Tier::lumped;
    steps.push_back({EffectKind::heating, input});
  }
  for (const EffectRule& rule : effect_rules()) {
    bool added = false;
    for (const EffectRule::Part& part : rule.parts) {
      if (has.*part.has || !part.data(c)) continue;
      added = true;
      if (part.wish != nullptr) {
        input.model.switches.*part.wish = true;
      } else {
        input.model.tier = Tier::thd;
      }
    }
    if (added) steps.push_back({rule.effect, input});
  }
  return steps;
}

std::vector<EffectKind> unknown_effects(const Case& c) {
  std::vector<EffectKind> effects;
  for (const EffectRule& rule : effect_rules()) {
    const auto data = rule.parts.front().data;
    const bool of_solids = data == knows_its_walls || data == can_be_elastic;
    if (of_solids && !data(c)) effects.push_back(rule.effect);
  }
  return effects;
}

namespace {

/// Adds the squares of the changes between two results to `squares`.
void add_squares(const std::vector<Quantity>& changes, std::vector<Quantity>& squares) {
  if (squares.empty()) {
    squares = changes;
    for (Quantity& q : squares) q.value = 0.0;
  }
  for (Quantity& q : squares) {
    const double by = value_in(changes, q.name);
    if (std::isfinite(by)) q.value += by * by;
  }
}

}  // namespace

ModelError model_error(const Solution& coarse, const SolveControl& control) {
  ModelError out;
  const Case& c = coarse.model.input;
  out.unknown = unknown_effects(c);
  const auto steps = richer_physics(c, c.model.tier);
  out.richest = steps.empty();
  Solution here = coarse;
  SolveControl bounded = control;
  double work = 0.0;
  for (const PhysicsStep& step : steps) {
    bounded.most_work = price_of_search(step.input, step.input.model.tier) - work;
    auto next = solve_near(step.input, here, bounded, &work);
    out.complete = next.has_value();
    if (!next) {
      out.failed.push_back(step.effect);
      continue;
    }
    const auto before = scalars(here), after = scalars(*next);
    const auto relative = [&](const char* name) {  // torque against a clockwise turn is negative
      return value_in(after, name) / value_in(before, name) - 1.0;
    };
    out.effects.push_back({step.effect, relative("friction_torque"), relative("h_min")});
    add_squares(change(before, after), out.one_by_one);
    here = std::move(*next);
  }
  for (Quantity& q : out.one_by_one) q.value = std::sqrt(q.value);
  if (out.complete) out.change = change(scalars(coarse), scalars(here));
  return out;
}

}  // namespace shellback::fidelity
