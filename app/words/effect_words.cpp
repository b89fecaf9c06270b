#include "app/words/effect_words.hpp"

#include <cmath>

namespace shellback::app {
namespace {

using bearing::EffectKind;
using bearing::Limiter;

struct EffectWords {
  const char* name;
  const char* meaning;
};

EffectWords entry_of(EffectKind effect) {
  switch (effect) {
    case EffectKind::heating:
      return {"heating", "beta dT of the oil flow; below 0.02 none, above 0.3 resolve it"};
    case EffectKind::temperature_across_film:
      return {"temperature across the film", "Nahme number; below 0.05 none, above 0.2 resolve it"};
    case EffectKind::elastic_deformation:
      return {
          "elastic deformation",
          "largest opening over smallest film (or roughness, if more); below 0.03 none, above 0.1 "
          "model it"};
    case EffectKind::thermal_deformation:
      return {"thermal deformation",
              "largest thermal change of the gap over clearance; above 0.05 model it"};
    case EffectKind::viscosity_with_pressure:
      return {"viscosity with pressure",
              "alpha p_max; below 0.05 none, above 0.1 model it, above 10 use Roelands"};
    case EffectKind::shear_thinning:
      return {"shear thinning",
              "loss of viscosity at the smallest film; below 0.02 none, above 0.05 model it"};
    case EffectKind::roughness_and_contact:
      return {"roughness and contact",
              "smallest film over roughness; above 6 none, below 4 model it"};
    case EffectKind::film_inertia:
      return {"inertia of the film",
              "rho omega c^2/eta; below 0.3 none, above 1 it matters, and is not modelled"};
    case EffectKind::inertia_of_fed_oil:
      return {"inertia of the fed oil",
              "its head over the pressure that drives it out of the supply; below 0.02 none, above "
              "0.1 the film's flow is too large"};
    case EffectKind::turbulence:
      break;
  }
  return {"turbulence and Taylor vortices",
          "Reynolds number over 41.2 sqrt(R/c); above 1 the laminar film is left"};
}

}  // namespace

const char* name_of(EffectKind effect) { return entry_of(effect).name; }

const char* meaning_of(const bearing::Effect& effect) {
  return std::isnan(effect.indicator) ? "not computed in this tier" : entry_of(effect.kind).meaning;
}

const char* words_of(Limiter limiter) {
  switch (limiter) {
    case Limiter::rejected_steps:
      return "Newton steps rejected";
    case Limiter::backflow_nodes:
      return "film nodes with flow against the rotation";
    case Limiter::upwind_columns:
      return "film columns with upwind fluxes across the film";
    case Limiter::held_at_hardness:
      return "cells whose contact pressure is held at the hardness";
    case Limiter::beyond_contact_law:
      return "cells pressed beyond the range of the contact law";
    case Limiter::bent_edges:
      return "places on side edges, beside grooves and openings whose gap is held open, as cells "
             "do not resolve it there";
    case Limiter::steps_too_long:
      break;
  }
  return "steps in time that err by more than they may";
}

}  // namespace shellback::app
