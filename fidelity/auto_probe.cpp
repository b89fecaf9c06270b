#include "fidelity/auto_probe.hpp"

#include <algorithm>

#include "bearing/steady/effects.hpp"
#include "core/largest.hpp"
#include "fidelity/held_film.hpp"
#include "fidelity/left_out.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

/// Relative changes of friction and smallest film from `s` to its held film, all of whose
/// quantities `all` is told.
Bars changes(const Solution& s, const Held& held, const std::atomic<bool>* stop,
             EquilibriumCost& cost, std::vector<Quantity>* all = nullptr) {
  const auto friction = [](const Solution& of) {
    return friction_of(of.model, of.point, of.film).torque();
  };
  const FilmGrid& g = s.model.domain.grid;
  const Solution film = held_film(s, {g.nt, g.full_nz()}, held, stop);
  add(film.cost, cost);
  if (!film.verdict.good()) return {};
  if (all != nullptr) *all = quantities_of(film, Tier::isothermal);
  return {friction(film) / friction(s) - 1.0, film.film.least.h / s.film.least.h - 1.0};
}

/// What a held film changes of every quantity that it tells, over its natural size.
void add_changes(const Solution& s, const std::vector<Quantity>& held, EffectChoice& to) {
  const std::vector<Quantity> here = quantities_of(s, Tier::isothermal);
  const double T = mean_supply_temperature(s.model.input);
  for (const Quantity& q : here) {
    const double size = natural_size(q, T, here);
    const double change = std::abs(value_in(held, q.name) - q.value) / size;
    if (!std::isfinite(change) || is_of_heat(q.name)) continue;
    const auto known = std::find_if(to.left.begin(), to.left.end(),
                                    [&](const auto& one) { return one.first == q.name; });
    auto& part = known != to.left.end() ? known->second : to.left.emplace_back(q.name, 0.0).second;
    part += kModelSafety * change;
  }
}

/// True if the indicator number itself says that the effect is not there.
bool absent(const Effect& e) {
  return e.kind == EffectKind::roughness_and_contact ? std::isinf(e.indicator) : e.indicator == 0.0;
}

}  // namespace

void add(const EquilibriumCost& from, EquilibriumCost& to) {
  to.factorizations += from.factorizations;
  to.newton_iterations += from.newton_iterations;
}

double EffectChoice::left_of(const std::string& name) const {
  const auto of = [this](const std::string& of_film) {
    for (const auto& [known, part] : left) {
      if (known == of_film) return part;
    }
    return left.empty() ? 0.0 : double{NAN};
  };
  return is_of_heat(name) ? of("friction_torque") + of("side_flow") : of(name);
}

NodeChoice choose_nodes(Solution& probe, double tolerance, bool given, const SolveControl& control,
                        EquilibriumCost& cost) {
  constexpr int kMostNodes = 9;  // that are chosen; a case may give more
  NodeChoice out;
  const Model& model = probe.model.input.model;
  if (!probe.model.physics.film_energy || model.methods.across != AcrossFilm::lobatto) return out;
  while (true) {
    out.nodes = model.film_nodes;
    auto more = with_more_nodes(probe, control);
    out.known = more.has_value();
    if (!out.known) return out;
    add(more->cost, cost);
    const auto here = scalars(probe);
    out.left = change(here, scalars(*more));
    const auto small = [&](const char* name) {
      return std::abs(value_in(out.left, name)) <=
             kNegligible * tolerance * std::abs(value_in(here, name));
    };
    const bool enough = small("friction_torque") && small("h_min");
    if (enough || given || more->model.input.model.film_nodes > kMostNodes) return out;
    probe = std::move(*more);
  }
}

EffectChoice choose_effects(const Solution& probe, double tolerance, const std::atomic<bool>* stop,
                            EquilibriumCost& cost) {
  const Case& c = probe.model.input;
  const Friction friction = friction_of(probe.model, probe.point, probe.film);
  EffectChoice out{effects_of(probe, friction, c.model.tier), c.model.switches};
  for (Effect& e : out.effects) {
    if (!e.included) continue;
    const Held held{without(e.kind, probe.model.physics), e.kind != EffectKind::heating};
    std::vector<Quantity> without_it;
    const Bars off = absent(e) ? Bars{0.0, 0.0} : changes(probe, held, stop, cost, &without_it);
    if (!std::isfinite(off.friction)) continue;  // the film does not stand without it
    e.change_in_friction = -off.friction;
    e.change_in_h_min = -off.h_min;
    const Bars size{std::abs(off.friction), std::abs(off.h_min)};
    if (!size.within(kNegligible * tolerance)) continue;
    if (!switch_off(e.kind, c.model.switches, out.switches)) continue;
    e.included = false;
    out.left_out.friction += kModelSafety * size.friction;
    out.left_out.h_min += kModelSafety * size.h_min;
    add_changes(probe, without_it, out);
  }
  return out;
}

Bars unknown_heat(const Solution& lumped, const std::atomic<bool>* stop, EquilibriumCost& cost) {
  // In random cases the lumped balance was off by less in 9 of 10 (docs/constants.md).
  constexpr double kUnknownHeat = 0.5;  // of the temperature rise [-]
  const double rise = lumped.T_film - mean_supply_temperature(lumped.model.input);
  Bars bars{0.0, 0.0};
  if (rise == 0.0) return bars;
  for (const double part : {kUnknownHeat, -kUnknownHeat}) {
    Held held{lumped.model.physics};
    held.warmer = part * rise;
    const Bars off = changes(lumped, held, stop, cost);
    bars.friction = larger(bars.friction, std::abs(off.friction));
    bars.h_min = larger(bars.h_min, std::abs(off.h_min));
  }
  return bars;
}

}  // namespace shellback::fidelity
