#include "solid/joined_rings.hpp"

#include <Eigen/Dense>

#include "core/contract.hpp"

namespace shellback::solid {
namespace {

/// (1) of one ring.
class Lame {
 public:
  Lame(double inner, const Ring& ring)
      : a_(inner), b_(ring.outer), m_(ring.material), rise_(ring.rise), d_(b_ * b_ - a_ * a_) {}

  [[nodiscard]] double free_inside() const { return a_ * m_.expansion * rise_; }
  [[nodiscard]] double free_outside() const { return b_ * m_.expansion * rise_; }
  /// Displacement of one surface per pressure on one [m/Pa].
  [[nodiscard]] double inside_by_inner() const { return a_ / m_.youngs_modulus * (sum() + nu()); }
  [[nodiscard]] double inside_by_outer() const {
    return -a_ / m_.youngs_modulus * 2.0 * b_ * b_ / d_;
  }
  [[nodiscard]] double outside_by_inner() const {
    return b_ / m_.youngs_modulus * 2.0 * a_ * a_ / d_;
  }
  [[nodiscard]] double outside_by_outer() const { return -b_ / m_.youngs_modulus * (sum() - nu()); }

 private:
  [[nodiscard]] double sum() const { return (b_ * b_ + a_ * a_) / d_; }
  [[nodiscard]] double nu() const { return m_.poisson_ratio; }

  double a_, b_;
  const Material& m_;
  double rise_, d_;
};

}  // namespace

JoinedRings joined_rings(double bore, const std::vector<Ring>& rings) {
  EXPECTS(!rings.empty() && rings.front().outer > bore);
  const auto joints = static_cast<Eigen::Index>(rings.size()) - 1;
  std::vector<Lame> lame;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    lame.emplace_back(k == 0 ? bore : rings[k - 1].outer, rings[k]);
  }
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(joints, joints);
  Eigen::VectorXd gap(joints);  // u(a) of the outer ring less u(b) of the inner one, both free
  for (Eigen::Index k = 0; k < joints; ++k) {
    const Lame &in = lame[static_cast<std::size_t>(k)],
               &out = lame[static_cast<std::size_t>(k) + 1];
    A(k, k) = in.outside_by_outer() - out.inside_by_inner();
    if (k > 0) A(k, k - 1) = in.outside_by_inner();
    if (k + 1 < joints) A(k, k + 1) = -out.inside_by_outer();
    gap(k) = out.free_inside() - in.free_outside();
  }
  JoinedRings joined;
  const Eigen::VectorXd p = joints > 0 ? Eigen::VectorXd(A.partialPivLu().solve(gap)) : gap;
  joined.pressures.assign(p.data(), p.data() + joints);
  joined.opening = lame.front().free_inside();
  if (joints > 0) joined.opening += lame.front().inside_by_outer() * p(0);
  return joined;
}

}  // namespace shellback::solid
