// The way to the full physics: complete, one effect a step, only where the data are.
#include <catch2/catch.hpp>

#include "../bearing/sample_bearing.hpp"
#include "app/words/effect_words.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/left_out.hpp"
#include "fidelity/solve_case.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;
using fidelity::richer_physics;

namespace {

constexpr Tier kTiers[] = {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd};

bool same(const Physics& a, const Physics& b) {
  return a.film_energy == b.film_energy && a.elastic == b.elastic &&
         a.thermal_deformation == b.thermal_deformation && a.contact == b.contact &&
         a.flow_factors == b.flow_factors && a.pressure_dependence == b.pressure_dependence &&
         a.shear_thinning == b.shear_thinning;
}

}  // namespace

TEST_CASE("TheWayFromEveryTierEndsAtTheFullPhysics") {
  Case c = rig_case();
  const Physics full = physics_of(c, Tier::tehd);
  for (const bool switched_off : {false, true}) {
    Case poor = c;
    if (switched_off) {
      poor.model.switches = {false, false, false, false, false, {}};
    }
    for (const Tier tier : kTiers) {
      const auto steps = richer_physics(poor, tier);
      if (steps.empty()) {
        CHECK(same(physics_of(poor, tier), full));
      } else {
        CHECK(same(physics_of(steps.back().input, steps.back().input.model.tier), full));
      }
    }
  }
}

TEST_CASE("EveryStepAddsAnEffectAndTakesNoneAway") {
  const auto count = [](const Physics& p) {
    return p.film_energy + p.elastic + p.thermal_deformation + p.contact + p.flow_factors +
           p.pressure_dependence + p.shear_thinning;
  };
  for (const Tier tier : kTiers) {
    Physics before = physics_of(rig_case(), tier);
    for (const auto& step : richer_physics(rig_case(), tier)) {
      const Physics here = physics_of(step.input, step.input.model.tier);
      const bool heating =
          step.effect == bearing::EffectKind::heating;  // isothermal to lumped: same equations
      CHECK(count(here) == count(before) + (heating ? 0 : 1));
      before = here;
    }
  }
}

TEST_CASE("NothingIsRicherThanTheFullTier") {
  CHECK(richer_physics(rig_case(), Tier::tehd).empty());
  CHECK(richer_physics(warm_case(), Tier::tehd).empty());
}

TEST_CASE("WithoutShellOnlyHeatingIsJudged") {
  const auto steps = richer_physics(plain_case(), Tier::isothermal);
  REQUIRE(steps.size() == 1);
  CHECK(steps.front().input.model.tier == Tier::lumped);
  CHECK(fidelity::unknown_effects(plain_case()).size() == 3);
  CHECK(fidelity::unknown_effects(rig_case()).empty());
}

TEST_CASE("EachIncludedEffectIsTakenOutAlone") {
  const Physics full = physics_of(rig_case(), Tier::tehd);
  for (const auto& rule : fidelity::effect_rules()) {
    INFO(app::name_of(rule.effect));
    const Physics poorer = fidelity::without(rule.effect, full);
    CHECK_FALSE(same(poorer, full));
    for (const auto& other : fidelity::effect_rules()) {
      if (other.effect == rule.effect) continue;
      for (const auto& part : other.parts) CHECK(poorer.*part.has == full.*part.has);
    }
  }
}

TEST_CASE("OnlyWhatTheCaseLeavesOpenIsSwitchedOff") {
  Switches given;
  given.elastic_deformation = true;
  Switches switches = given;
  CHECK_FALSE(fidelity::switch_off(bearing::EffectKind::elastic_deformation, given, switches));
  CHECK_FALSE(fidelity::switch_off(bearing::EffectKind::temperature_across_film, given, switches));
  CHECK(fidelity::switch_off(bearing::EffectKind::roughness_and_contact, given, switches));
  CHECK(switches.flow_factors == false);
  CHECK(switches.asperity_contact == false);
  CHECK(switches.elastic_deformation == true);
}

TEST_CASE("EffectsThatUndoOneAnotherLeaveABar") {
  // Heat thins the film by about as much as elastic surfaces widen it: the difference of both is
  // small by chance, and each is known on the coarse grid alone.
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  const Solution coarse = solve_tier(c, Tier::isothermal);
  REQUIRE(coarse.verdict.good());
  const fidelity::ModelError e = fidelity::model_error(coarse, {});
  REQUIRE(e.complete);
  REQUIRE(e.one_by_one.size() == e.change.size());
  double largest_effect = 0.0;
  for (const auto& effect : e.effects) {
    largest_effect = std::max(largest_effect, std::abs(effect.h_min));
  }
  // Steps are told over what each begins with; none halves or doubles the film beyond this.
  const double h = value_in(fidelity::scalars(coarse), "h_min");
  CHECK(value_in(e.one_by_one, "h_min") > 0.3 * largest_effect * h);
  for (const Quantity& q : e.change) {
    const double apart = value_in(e.one_by_one, q.name);
    if (!std::isfinite(q.value)) continue;
    // n numbers add up to no more than root n times the root of their squares.
    CHECK(std::abs(q.value) <=
          std::sqrt(static_cast<double>(e.effects.size())) * apart * (1.0 + 1e-12));
  }
}

TEST_CASE("BarsHoldWhereAFilmOpensInTheMiddleAndNotAtItsEdges") {
  // 6 kN at 500 rpm on 50 mm x 25 mm: elastic walls widen the film at mid-width by a quarter and
  // leave its edges, where it is smallest then, as they are; heat thins it.
  Case c = rig_case();
  c.bearing = {0.025, 0.025, 25e-6, 353.15, {}};
  c.operation.omega = 500.0 * kPi / 30.0;
  c.operation.position = LoadGiven{6e3, 270.0 * kDegree};
  c.supplies.front().pressure = 2e5;
  c.supplies.front().temperature = 353.15;
  c.oil_temperature = 353.15;
  c.oil.temperature = rheology::ConstantViscosity{0.01};
  c.oil.pressure = rheology::NoPressureEffect{};
  c.oil.shear = rheology::NoShearThinning{};
  c.surfaces.shell = {0.5e-6, 1.0, 0.4289e-6, 0.6324e-6};
  c.surfaces.shaft = {};
  c.model.tier = Tier::isothermal;
  c.model.grid = {100, 13};
  const Result bars = fidelity::solve_case(c);
  Case rich = c;
  rich.model.tier = Tier::tehd;
  rich.model.grid = {200, 25};
  const Result truth = bearing::solve(rich);
  REQUIRE(bars.verdict.good());
  REQUIRE(truth.verdict.good());
  for (const char* name : {"h_min", "h_min_mid", "friction_torque"}) {
    INFO(name);
    const Quantity* q = quantity_in(bars.quantities, name);
    CHECK(std::abs(truth.value(name) - q->value) <= q->error());
  }
}

TEST_CASE("TemperaturesAreNoSurerThanTheirHeatAndPartsNoMoreThanTheWhole") {
  Case c = rig_case();
  c.model.tier = Tier::tehd;
  c.model.grid = {100, 13};
  const Result r = fidelity::solve_case(c);
  REQUIRE(r.verdict.good());
  const Quantity& torque = *quantity_in(r.quantities, "friction_torque");
  const double of_heat = torque.error_grid / torque.size();
  const double T_supply = mean_supply_temperature(c);
  for (const char* name : {"T_film_max", "T_shell_max", "T_shaft"}) {
    const Quantity& q = *quantity_in(r.quantities, name);
    INFO(name);
    CHECK(q.error_grid >= of_heat * std::abs(q.value - T_supply) * (1.0 - 1e-12));
  }
  const Quantity& part = *quantity_in(r.quantities, "friction_torque_asperity");
  const double most = torque.size() + torque.error_grid;
  CHECK(part.error_grid <= std::max(part.size(), most - part.size()) * (1.0 + 1e-12));
}

TEST_CASE("WhatAnEffectChangesDoesNotHangOnTheSenseOfRotation") {
  Case c = warm_case();
  const Solution forth = solve_tier(c, Tier::isothermal);
  c.operation.omega *= -1.0;
  const Solution back = solve_tier(c, Tier::isothermal);
  REQUIRE((forth.verdict.good() && back.verdict.good()));
  const auto one = fidelity::model_error(forth, {}).effects;
  const auto other = fidelity::model_error(back, {}).effects;
  REQUIRE(one.size() == other.size());
  REQUIRE_FALSE(one.empty());
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(app::name_of(one[k].effect));
    // mirrored supplies are cut by the same cells: to the tolerance of the outer loop
    CHECK(other[k].friction == Approx(one[k].friction).epsilon(1e-2).margin(1e-4));
    CHECK(other[k].h_min == Approx(one[k].h_min).epsilon(1e-2).margin(1e-4));
  }
}
