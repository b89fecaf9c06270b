#include "solid/elastic_element.hpp"

#include "core/contract.hpp"

namespace shellback::solid {
namespace {

constexpr GaussOrder kStiffnessOrder{2, 3};  ///< see the header for why
constexpr GaussOrder kFullOrder{3, 3};       ///< integrates shape function times r and z exactly

using Stiffness = Eigen::Matrix<double, 6, 6>;
using Strain = Eigen::Matrix<double, 6, 24>;

Stiffness hooke(const Material& m) {
  const double nu = m.poisson_ratio;
  const double mu = m.shear_modulus();
  const double lambda = 2.0 * mu * nu / (1.0 - 2.0 * nu);
  Stiffness d = Stiffness::Zero();
  d.topLeftCorner<3, 3>().setConstant(lambda);
  d.diagonal() << lambda + 2.0 * mu, lambda + 2.0 * mu, lambda + 2.0 * mu, mu, mu, mu;
  return d;
}

void strain_matrices(const ShapePoint& s, Strain& b0, Strain& b1) {
  b0.setZero();
  b1.setZero();
  for (int a = 0; a < 8; ++a) {
    const double over_r = s.n(a) / s.r;
    const int r = 3 * a, phi = r + 1, z = r + 2;
    b0(0, r) = s.n_r(a);
    b0(1, r) = over_r;
    b1(1, phi) = over_r;
    b0(2, z) = s.n_z(a);
    b0(3, r) = s.n_z(a);
    b0(3, z) = s.n_r(a);
    b0(4, phi) = s.n_r(a) - over_r;
    b1(4, r) = -over_r;
    b0(5, phi) = s.n_z(a);
    b1(5, z) = -over_r;
  }
}

}  // namespace

ElasticElement elastic_element(const RevolutionMesh& mesh, int row, int col,
                               const Material& material) {
  EXPECTS(material.youngs_modulus > 0.0);
  EXPECTS(material.poisson_ratio > -1.0 && material.poisson_ratio < 0.5);
  const Stiffness d = hooke(material);
  const double thermal_stress = d.topLeftCorner<3, 1>().sum() * material.expansion;  // [Pa/K]
  ElasticElement e;
  e.k0.setZero();
  e.k1.setZero();
  e.k2.setZero();
  e.g0.setZero();
  e.g1.setZero();
  Strain b0, b1;
  for (const ShapePoint& s : shape_points(mesh, row, col, kStiffnessOrder)) {
    strain_matrices(s, b0, b1);
    const double w = s.weight * s.r;
    const Strain db0 = w * d * b0, db1 = w * d * b1;
    e.k0.noalias() += b0.transpose() * db0;
    e.k1.noalias() += b0.transpose() * db1 + b1.transpose() * db0;
    e.k2.noalias() += b1.transpose() * db1;
    const double stress = w * thermal_stress;
    e.g0.noalias() += stress * b0.topRows<3>().colwise().sum().transpose() * s.n.transpose();
    e.g1.noalias() += stress * b1.topRows<3>().colwise().sum().transpose() * s.n.transpose();
  }
  return e;
}

Eigen::Matrix<double, 24, 2> rigid_load(const RevolutionMesh& mesh, int row, int col) {
  Eigen::Matrix<double, 24, 2> load = Eigen::Matrix<double, 24, 2>::Zero();
  for (const ShapePoint& s : shape_points(mesh, row, col, kFullOrder)) {
    for (int a = 0; a < 8; ++a) {
      const double w = s.weight * s.r * s.n(a);
      load(3 * a, 0) += w;
      load(3 * a + 1, 0) -= w;
      load(3 * a, 1) += w * s.z;
      load(3 * a + 1, 1) -= w * s.z;
      load(3 * a + 2, 1) -= w * s.r;
    }
  }
  return load;
}

}  // namespace shellback::solid
