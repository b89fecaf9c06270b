#pragma once
/// Elastic compliance and thermal deformation of shell and shaft, by circumferential harmonics.
///
///   K_n u_n = R P p_n + G_n T_n,    gap_n(j) = 1/dz_j sum_m P_mj u_m            (1)
///
/// K_n: stiffness of the body of revolution for harmonic n (solid/elastic_element.hpp); P:
/// integrals of the surface's shape functions over the axial film cells (core/revolution_mesh.hpp),
/// the same for force and displacement; p_n: pressure harmonic on the axial film cells [Pa]; T_n:
/// nodal temperature rise [K]. Hence
///
///   compliance C_n = R diag(1/dz) P^T K_n^-1 P   (nz x nz) [m/Pa]               (2)
///   thermal deformation     U_n = diag(1/dz) P^T K_n^-1 G_n   (nz x nodes) [m/K]             (3)
///
/// and diag(dz) C_n is symmetric and positive semi-definite. Sign: a positive entry opens the gap.
/// Pressure pushes the shell outwards and the shaft inwards: both open it. Thermal deformation of
/// the bore opens it; that of the shaft (shaft_thermal_deformation) closes it.
///
/// The sections are built with rows_outwards / rows_of_cylinder and axial_elements; the shell's
/// bore is the innermost line of its mesh, the shaft's journal surface the outermost. Small
/// strains, isotropic layers that stick to each other, end faces free of traction. On a half
/// grid z = 0 is a plane of symmetry. Source: textbook (semi-analytical finite elements).
///
/// Rigid-body motion of a body that nothing holds: harmonic 0 along the axis (no effect on the
/// gap), harmonic 1 translation and, on a full grid, tilt. The net force is balanced by a body
/// force per volume that is distributed like the rigid motion (uniform for the translation), and
/// displacements are those relative to the volume mean of the body. That the same mean is used
/// for force and displacement keeps (2) symmetric. A uniform shift of the surface against the
/// volume mean stays in C_1; it is a shift of the journal position and changes no pressure.
#include <vector>

#include "core/grid.hpp"
#include "core/harmonics.hpp"
#include "core/revolution_mesh.hpp"
#include "solid/elastic_system.hpp"
#include "solid/material.hpp"

namespace shellback::solid {

/// How the outer surface of the body is held.
enum class Support {
  held,     ///< no displacement under load; free to grow with temperature
  free,     ///< no traction, under load and temperature alike
  clamped,  ///< no displacement, under load and temperature alike
};

/// The end faces. `plane_strain` keeps them from moving along the axis: a slice of a long body.
enum class AxialEnds { free, plane_strain };

/// Which operators are wanted.
struct ElasticOptions {
  int harmonics = 48;               ///< highest circumferential harmonic [-]
  Support support = Support::held;  ///< of the outer surface
  AxialEnds ends = AxialEnds::free;
  bool thermal_deformation = true;  ///< also (3); about doubles the work
  Elimination order = Elimination::cheapest;
  std::vector<int> only{};  ///< harmonics that are wanted; empty: 0 .. harmonics
};

struct ElasticOperators {
  HarmonicOperator compliance;           ///< C_n of (2), for each harmonic that is wanted [m/Pa]
  HarmonicOperator thermal_deformation;  ///< U_n of (3) [m/K]; empty if not wanted
};

/// Operators of the shell with its housing. `layers[mesh.layer[row]]` is the material of a row.
/// Throws InputError if a material has no valid elastic constants.
[[nodiscard]] ElasticOperators shell_elasticity(const RevolutionMesh& mesh, const FilmGrid& grid,
                                                const std::vector<Material>& layers,
                                                const ElasticOptions& options);

/// C_n of a solid shaft (mesh from r = 0) loaded over the bearing width. On the axis the
/// displacement is regular: u_r = u_phi = 0 and u_z free for n = 0, u_phi = -u_r and u_z = 0 for
/// n = 1, all zero for n >= 2. Rows so deep that the field of harmonic n, (r/R)^n, has no energy
/// left there (below 1e-10) are left out. Throws as shell_elasticity.
[[nodiscard]] HarmonicOperator shaft_compliance(const RevolutionMesh& mesh, const FilmGrid& grid,
                                                const Material& material, int harmonics,
                                                AxialEnds ends = AxialEnds::free,
                                                Elimination order = Elimination::cheapest);

/// Gap opening [m/K] of each axial cell per nodal temperature of a free solid shaft (mesh from
/// r = 0), the same all round: -U_0 of (3), nz x nodes. A shaft of one temperature opens the gap by
/// -expansion R per kelvin. Throws as shell_elasticity.
[[nodiscard]] Eigen::MatrixXd shaft_thermal_deformation(const RevolutionMesh& mesh,
                                                        const FilmGrid& grid,
                                                        const Material& material);

/// Thermal deformation of the bore [m] of each axial cell for 1 K uniform temperature rise of the
/// whole body.
[[nodiscard]] Eigen::VectorXd uniform_expansion(const ElasticOperators& operators);

}  // namespace shellback::solid
