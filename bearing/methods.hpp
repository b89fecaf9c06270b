#pragma once
/// Numerical methods by name. The first of each is what Shellback uses; the others are what other
/// programs use, to be compared with (chart, stress). Of them bearing/ has the nodal sets across
/// the film; cavitation and elasticity by another method need what solves the equilibrium in the
/// place of Newton's method: `stand_in`. Those of others are in validation/rivals/.
#include "core/outcome.hpp"

namespace shellback::bearing {

struct FilmTask;
struct FilmEquilibrium;
struct EquilibriumCost;

/// Solves for the equilibrium from a state, which is left at the last iterate whatever the verdict;
/// as newton (bearing/film/newton.hpp).
using EquilibriumMethod = Verdict (*)(const FilmTask& task, FilmEquilibrium& state,
                                      EquilibriumCost& cost);

enum class CavitationMethod {
  active_set,          ///< p and theta, semismooth Newton on the active set (mass-conserving)
  fischer_burmeister,  ///< p and theta, Fischer-Burmeister Newton (mass-conserving)
  p_theta,             ///< p and theta by relaxation, cell after cell (mass-conserving)
  swift_stieber,       ///< Reynolds condition: p >= 0, oil not conserved
};
enum class AcrossFilm {
  lobatto,  ///< Gauss-Lobatto-Legendre nodes
  layers,   ///< finite volumes, even layers
  mean,     ///< one temperature across the film
};
enum class ElasticMethod {
  newton,       ///< film, position and displacement in one Newton iteration
  fixed_point,  ///< displacement under-relaxed from film to film
};

/// What oil a cavitated cell hands on while the film changes in time (fluid/fill_front.hpp). A
/// steady film is the same with both.
enum class FillTransport {
  upwind,    ///< its own fill ratio, of first order: fronts of oil widen on their way
  van_leer,  ///< oil of second order, fronts kept sharp; each stage of a step solved twice
};

struct Methods {
  CavitationMethod cavitation = CavitationMethod::active_set;
  AcrossFilm across = AcrossFilm::lobatto;
  ElasticMethod elastic = ElasticMethod::newton;
  FillTransport transport = FillTransport::van_leer;
  int layers = 20;          ///< of AcrossFilm::layers, 2 to 60
  double relaxation = 0.0;  ///< of ElasticMethod::fixed_point: part of each change taken [-]; 0:
                            ///< Aitken's
  EquilibriumMethod stand_in = nullptr;  ///< for Newton's method where another is asked for; none:
                                         ///< that is refused
};

}  // namespace shellback::bearing
