#include "fidelity/richer_physics.hpp"

#include "coupling/bearing.hpp"

namespace shellback::fidelity {

using namespace coupling;

namespace {

constexpr const char* kHeating = "heating";
constexpr const char* kAcross = "temperature across the film";
constexpr const char* kElastic = "elastic deformation";
constexpr const char* kGrowth = "thermal deformation";
constexpr const char* kPressure = "viscosity with pressure";
constexpr const char* kShear = "shear thinning";
constexpr const char* kRough = "roughness and contact";

bool piezoviscous(const Case& c) {
  return !std::holds_alternative<rheology::NoPressureEffect>(c.oil.pressure);
}
bool thinning(const Case& c) {
  return !std::holds_alternative<rheology::NoShearThinning>(c.oil.shear);
}
bool rough(const Case& c) {
  return c.surfaces.shell.roughness > 0.0 || c.surfaces.shaft.roughness > 0.0;
}

/// Adds one effect after the other to a case.
class Way {
 public:
  Way(const Case& c, Tier tier) : input_(c), tier_(tier) {}
  void take(const char* effect, Tier tier) {
    tier_ = tier;
    push(effect);
  }
  void take(const char* effect, std::optional<bool> Switches::*which) {
    input_.model.switches.*which = true;
    push(effect);
  }
  void take_roughness() {
    Switches& on = input_.model.switches;
    if (rough(input_)) on.flow_factors = true;
    if (input_.surfaces.contact) on.asperity_contact = true;
    push(kRough);
  }
  std::vector<PhysicsStep> steps() { return std::move(steps_); }

 private:
  void push(const char* effect) {
    input_.model.tier = tier_;
    steps_.push_back({effect, input_, tier_});
  }
  Case input_;
  Tier tier_;
  std::vector<PhysicsStep> steps_;
};

}  // namespace

bool knows_its_walls(const Case& c) {
  if (!c.shell || !c.shaft) return false;
  const auto* back = std::get_if<ConvectiveBack>(&c.shell->back);
  return back == nullptr || back->heat_transfer > 0.0;
}

std::vector<PhysicsStep> richer_physics(const Case& c, Tier tier) {
  const Physics has = physics_of(c, tier);
  Case resolved = c;  // what the tier chooses by itself is kept when the tier changes
  resolved.model.switches.elastic_deformation = has.elastic;
  resolved.model.switches.thermal_deformation = has.growth;
  Way way(resolved, tier);
  if (tier == Tier::isothermal) way.take(kHeating, Tier::lumped);
  const bool walls = knows_its_walls(c);
  if (walls && !has.film_energy) way.take(kAcross, Tier::thd);
  if (walls && !has.growth) way.take(kGrowth, &Switches::thermal_deformation);
  if (c.shell && !has.elastic) way.take(kElastic, &Switches::elastic_deformation);
  if (piezoviscous(c) && !has.pressure_dependence) {
    way.take(kPressure, &Switches::pressure_dependence);
  }
  if (thinning(c) && !has.shear_thinning) way.take(kShear, &Switches::shear_thinning);
  const bool factors = rough(c) && !has.flow_factors;
  const bool contact = c.surfaces.contact && !has.contact;
  if (factors || contact) way.take_roughness();
  return way.steps();
}

std::vector<std::string> unknown_effects(const Case& c) {
  std::vector<std::string> out;
  if (!knows_its_walls(c)) {
    out.emplace_back(kAcross);
    out.emplace_back(kGrowth);
  }
  if (!c.shell) out.emplace_back(kElastic);
  return out;
}

std::vector<PhysicsStep> poorer_physics(const Case& c, Tier tier) {
  const Physics has = physics_of(c, tier);
  std::vector<PhysicsStep> out;
  const auto without = [&](const char* effect, auto change) {
    PhysicsStep step{effect, c, tier};
    change(step);
    step.input.model.tier = step.tier;
    out.push_back(std::move(step));
  };
  const auto off = [](std::optional<bool> Switches::*which) {
    return [which](PhysicsStep& s) { s.input.model.switches.*which = false; };
  };
  if (has.film_energy) {
    without(kAcross, [&](PhysicsStep& s) {
      s.tier = Tier::lumped;
      s.input.model.switches.elastic_deformation = has.elastic;
      s.input.model.switches.thermal_deformation.reset();
    });
  }
  if (has.growth) without(kGrowth, off(&Switches::thermal_deformation));
  if (has.elastic) without(kElastic, off(&Switches::elastic_deformation));
  if (piezoviscous(c) && has.pressure_dependence) {
    without(kPressure, off(&Switches::pressure_dependence));
  }
  if (thinning(c) && has.shear_thinning) without(kShear, off(&Switches::shear_thinning));
  if ((rough(c) && has.flow_factors) || has.contact) {
    without(kRough, [](PhysicsStep& s) {
      s.input.model.switches.flow_factors = s.input.model.switches.asperity_contact = false;
    });
  }
  return out;
}

}  // namespace shellback::fidelity
