#pragma once
/// Element matrices of the eight-node ring for circumferential harmonic n.
///
///   u = (u_r cos n phi, u_phi sin n phi, u_z cos n phi)
///   eps = (u_r,r; (u_r + n u_phi)/r; u_z,z; u_r,z + u_z,r; u_phi,r - (u_phi + n u_r)/r;
///          u_phi,z - n u_z/r)                                     [textbook]
///
/// The strain is B0 + n B1, so stiffness and thermal load are polynomials in n whose
/// coefficients are integrated once: K = K0 + n K1 + n^2 K2, G = G0 + n G1. All integrals are over
/// the section with weight r; the factor pi (2 pi for n = 0) of the circumference is common to
/// both sides of the equations and left out.
///
/// Quadrature is 2 points in r times 3 in z. Two in r, so that thin layers and Poisson's ratios
/// near 0.5 do not lock. Three in z, since the 2 x 2 rule gives the mode u_r = xi (3 eta^2 - 1),
/// u_z = -(dr/dz) eta (3 xi^2 - 1) (xi along r, eta along z) no energy; neighbours cannot share its
/// u_z part, but in a flat element that part is small, and a thin soft layer would follow any
/// pressure of that shape: it zigzags. With three points in z the mode has its energy.
///
/// Local freedom 3 a + c is component c (r, phi, z) at node a of RevolutionMesh::element.
#include "core/eigen.hpp"
#include "core/revolution_mesh.hpp"
#include "solid/material.hpp"

namespace shellback::solid {

struct ElasticElement {
  Eigen::Matrix<double, 24, 24> k0, k1, k2;  ///< stiffness per radian [N/m]
  Eigen::Matrix<double, 24, 8> g0, g1;       ///< load per nodal temperature rise [N/K]
};

/// Isotropic elasticity. Poisson's ratio in (-1, 0.5), Young's modulus positive.
[[nodiscard]] ElasticElement elastic_element(const RevolutionMesh& mesh, int row, int col,
                                             const Material& material);

/// Load of a unit body force along the two rigid motions of harmonic 1: the translation
/// (1, -1, 0) and the tilt (z, -z, -r). [m3], [m4]
[[nodiscard]] Eigen::Matrix<double, 24, 2> rigid_load(const RevolutionMesh& mesh, int row, int col);

}  // namespace shellback::solid
