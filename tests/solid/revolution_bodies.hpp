#pragma once
/// Bodies that several tests of solid/ share.
#include <Eigen/Dense>
#include <vector>

#include "core/make_grid.hpp"
#include "core/revolution_mesh.hpp"
#include "solid/revolution_elasticity.hpp"

namespace shellback::test {

/// Of the KS rig, seed 000 [m].
inline constexpr double kRadius = 23.9e-3, kWidth = 17.2e-3;

inline solid::Material steel() { return {"steel", 50.0, 7800.0, 460.0, 210e9, 0.3, 11e-6}; }
inline solid::Material polymer() { return {"polymer", 0.3, 1500.0, 1000.0, 2e9, 0.4, 60e-6}; }

/// Bush of 24 mm radius and 17 mm width: its film grid and mesh.
struct Bush {
  FilmGrid grid;
  RevolutionMesh mesh;
};
inline Bush bush(bool half, const std::vector<double>& thickness, int full_nz = 13,
                 int harmonics = 24) {
  Bush b;
  b.grid = make_grid(0.024, 0.017, 48, full_nz, half);
  const auto rows = rows_outwards(0.024, thickness, surface_row(0.024, harmonics));
  b.mesh = make_revolution_mesh(rows.face, rows.layer, axial_elements(b.grid), half);
  return b;
}

/// Displacement of the middle cell under a pressure that is uniform along the axis.
inline double under_uniform(const Eigen::MatrixXd& c, int cell) { return c.row(cell).sum(); }

/// || W C - (W C)^T || / || W C ||, W = diag(dz): deviation from Betti's law.
inline double asymmetry(const Eigen::MatrixXd& c, const FilmGrid& grid) {
  const Eigen::Map<const Eigen::VectorXd> dz(grid.dz.data(), grid.nz);
  const Eigen::MatrixXd w = dz.asDiagonal() * c;
  return (w - w.transpose()).norm() / w.norm();
}

/// What an operator on the full grid does to fields that are even in z, on the half grid of the
/// same bearing with its middle cell halved (odd full grids).
inline Eigen::MatrixXd even_part(const Eigen::MatrixXd& full) {
  const Eigen::Index nz = (full.rows() + 1) / 2, middle = nz - 1;
  Eigen::MatrixXd half(nz, nz);
  for (Eigen::Index i = 0; i < nz; ++i) {
    for (Eigen::Index j = 0; j < nz; ++j) {
      half(i, j) = full(middle + i, middle + j) + (j > 0 ? full(middle + i, middle - j) : 0.0);
    }
  }
  return half;
}

}  // namespace shellback::test
