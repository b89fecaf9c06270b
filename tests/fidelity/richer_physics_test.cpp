// The way to the full physics: complete, one effect a step, only where the data are.
#include <catch2/catch.hpp>

#include "../bearing/sample_bearing.hpp"
#include "app/words/effect_words.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/left_out.hpp"

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
  const Solution coarse = solve(c, Tier::isothermal);
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
    CHECK(std::abs(q.value) <= std::sqrt(1.0 * e.effects.size()) * apart * (1.0 + 1e-12));
  }
}
