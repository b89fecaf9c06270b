#pragma once
/// The elastic Newton step: film, displacement and position by preconditioned GMRES, the
/// compliance applied and never assembled.
///
///   J du + J_h (dd + B dq)                  = -R                                     (1)
///   dd - C dP                               =  r_d,  dP = du_F + p_a'(dd + B dq)     (2)
///   L dP                                    =  a                                     (3)
/// J, J_h derivatives of the film residual by its unknowns and by the gap, B = dh/dq, L the
/// quadrature of force and moment, r_d = C(p + p_a) - d, a the wanted change of force.
/// With the Winkler foundation tau in place of C the system is solved exactly: cell by cell
///   dd = kappa (b + tau (du_F + p_a' B dq)),   kappa = 1/(1 - tau p_a'),             (4)
/// one factorised film matrix J + J_h kappa tau, and a small border for dq. Only (2) is then
/// wrong, by (C - tau) dP: GMRES acts on the right-hand side b of (2) alone,
///   b - (C - tau) dP(b) = r_d.                                                        (5)
/// Source: methods 2.1, 2.2; the reduction (5) is ours.
#include "coupling/equilibrium_step.hpp"

namespace shellback::coupling {

/// The step for an elastic bearing; model.solids must be set.
[[nodiscard]] NewtonStep elastic_step(const BearingModel& model, const LoadTarget& target,
                                      const FilmEquilibrium& state, const Field& residual,
                                      const Field& displacement_residual, EquilibriumCost& cost);

}  // namespace shellback::coupling
