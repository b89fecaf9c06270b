#pragma once
/// Bending of the shaft between its supports, beside the local compliance of its surface.
///
/// shaft_compliance (revolution_elasticity.hpp) balances the net force and moment of the pressure
/// by body forces over its own length l: it bends too, but as a body without supports. What lacks
/// is the answer to "support forces at +-L/2 instead of those body forces", a load of its own that
/// beam theory has in closed form. The body forces are distributed as the rigid motions are: of a
/// turn they are -c r cos(phi) along the axis, too, a couple of c I per length, which bears the
/// part beta of the moment. Per unit net force F and unit net moment M (about mid-width, by
/// forces along F at a distance z), with a = l/2, for z >= 0, f even and g odd:
///
///   E I f = -[ (L z^2/4 - z^3/6)/2 - (a^2 z^2/2 - a z^3/3 + z^4/12)/(4 a) ]
///           - E I z^2/(4 a kGA)                                                             (1)
///   E I g = -[ (1 - beta) 3/(4 a) + beta/(2 a) - 1/L ] z^3/6 + (1 - beta) z^5/(80 a^3)
///           - (1 - beta) E I z^3/(4 a^3 kGA)                                                (2)
///   beta = (R^2/4)/(R^2/4 + l^2/12)                                                         (3)
///
/// are displacements along F against the tangent of the axis at mid-width; I = pi R^4/4,
/// kGA = E A 3/(7 + 6 nu) (shear of a circle: 6 (1 + nu)/(7 + 6 nu), Cowper, textbook). Only the
/// first harmonic bends; with the film's force pi R p_1 dz on an axial cell the gap opens by
///
///   C_jk = pi R dz_k [ f(z_j) + f(z_k) + g(z_j) z_k + z_j g(z_k) ]        [m/Pa] (4)
///
/// The second and fourth terms move and turn the journal as a whole: they make diag(dz) C
/// symmetric, as work asks, and change no pressure. Negative entries: away from mid-width the shaft
/// comes nearer to the loaded side. Supports are hinges as far to either side. Valid for
/// |z| <= L/2, slender enough that plane sections stay plane (St. Venant; the local part has the
/// rest). Derived from E I u'' = moment about z of all loads beyond z, k G A u' = their sum;
/// textbook beam theory.
#include "core/eigen.hpp"
#include "core/grid.hpp"
#include "solid/material.hpp"

namespace shellback::solid {

/// C of (4), nz x nz; on a half grid F is that of both halves and M is zero. `span`: L, at least
/// the bearing's width; `length`: l of the section that shaft_compliance had [m].
[[nodiscard]] Eigen::MatrixXd shaft_bending(const FilmGrid& grid, const Material& material,
                                            double span, double length);

/// Displacement of a free shaft's axis at mid-width along the net force of the film [m/N], counted
/// from the mean of the section of length l that shaft_compliance balances by body forces: what
/// this bends as a beam, growing with l^3, though no film sees more of it than a journal that has
/// moved as a whole. Of a force F spread evenly over the width b = 2 c, balanced by F/l; a = l/2:
///
///   w/F = [ a^3/20 - (c^4/20 + c^3 (a - c)/8 + c^2 (a - c)^2/12)/a ]/(2 E I)               (5)
///
/// Slender sections. Shear, and the change of the sections' shape by the bending, are left out: at
/// the surface they nearly cancel. Textbook beam theory, from (1)'s equation.
[[nodiscard]] double free_shaft_shift(double radius, double width, const Material& material,
                                      double length);

}  // namespace shellback::solid
