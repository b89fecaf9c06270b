#include "bearing/film/film_impedance.hpp"

#include <cmath>

#include "core/decompositions.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

using Basis = std::vector<Eigen::VectorXd>;

/// L: what an answer brings into the cells [kg per unit].
Field content_by(const FilmResponse& answer, const fluid::OilStore& store) {
  Field m(answer.theta.size());
  for (std::size_t k = 0; k < m.size(); ++k) {
    m[k] = store.by_theta[k] * answer.theta[k];
    if (!answer.elastic.empty()) m[k] += store.by_gap[k] * answer.elastic[k];
  }
  return m;
}

/// m_0: with what the gap takes up that the motion itself opens.
Field content_by_motion(const Solution& s, const FilmResponse& slow, const fluid::OilStore& store,
                        int component) {
  const fluid::FilmScene& scene = s.point.scene;
  Field m = content_by(slow, store);
  const Field slope = fluid::gap_slopes(scene.grid, scene.angles, component);
  for (std::size_t k = 0; k < m.size(); ++k) m[k] += store.by_gap[k] * slope[k];
  return m;
}

Field cavitated_part(Field m, const FilmEquilibrium& film) {
  for (std::size_t k = 0; k < m.size(); ++k) {
    if (film.film.full[k]) m[k] = 0.0;
  }
  return m;
}

Eigen::VectorXd vector_of(const Field& f) {
  return Eigen::VectorXd::Map(f.data(), static_cast<Eigen::Index>(f.size()));
}

Field field_of(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

/// Takes from w what it has along the basis, twice, so that rounding leaves nothing; returns that.
Eigen::VectorXd take_along(const Basis& basis, Eigen::VectorXd& w) {
  Eigen::VectorXd along = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(basis.size()));
  for (int again = 0; again < 2; ++again) {
    for (std::size_t k = 0; k < basis.size(); ++k) {
      const double part = basis[k].dot(w);
      along[static_cast<Eigen::Index>(k)] += part;
      w -= part * basis[k];
    }
  }
  return along;
}

}  // namespace

ForceByMotion::ForceByMotion(LinearFilm& film, const Solution& s, int component, double highest,
                             double tolerance) {
  const fluid::FilmDomain& domain = s.model.domain;
  const fluid::OilStore store =
      fluid::oil_store(s.point.scene, s.film.gap, s.film.oil, s.film.film);
  const FilmResponse slow = film.to_position(component);
  by_place_ = fluid::wrench(domain, slow.total);
  const Field m = content_by_motion(s, slow, store, component);
  by_cavitated_ = fluid::wrench(domain, film.pressure_by_storage(cavitated_part(m, s.film)));
  Basis basis{vector_of(m)};
  size_ = basis.front().norm();
  converged_ = film.converged() && std::isfinite(size_);
  if (!converged_ || size_ == 0.0) return;
  basis.front() /= size_;
  double left = 1.0;
  while (left > tolerance) {
    const FilmResponse answer = film.to_storage(field_of(basis.back()));
    by_basis_.push_back(fluid::wrench(domain, answer.total));
    Eigen::VectorXd w = vector_of(content_by(answer, store));
    const Eigen::VectorXd along = take_along(basis, w);
    const auto n = along.size();
    H_.conservativeResizeLike(Eigen::MatrixXd::Zero(n + 1, n));
    H_.col(n - 1) << along, w.norm();
    left = combination(highest).left;
    if (!film.converged() || n == kMostIterations) break;
    basis.push_back(w / H_(n, n - 1));
  }
  converged_ = film.converged() && left <= tolerance;
}

ForceByMotion::Combination ForceByMotion::combination(double nu) const {
  const auto n = H_.cols();
  // (I - i nu H) y = b, real parts above imaginary ones.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * (n + 1), 2 * n);
  A.block(0, 0, n, n).setIdentity();
  A.block(n + 1, n, n, n).setIdentity();
  A.block(0, n, n + 1, n) += nu * H_;
  A.block(n + 1, 0, n + 1, n) -= nu * H_;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(2 * (n + 1));
  b[0] = size_;
  const Eigen::VectorXd y = least_squares(A, b);
  Combination c;
  c.y.resize(n);
  c.y.real() = y.head(n);
  c.y.imag() = y.tail(n);
  c.left = (b - A * y).norm() / size_;
  return c;
}

fluid::Wrench ForceByMotion::by_velocity() const {
  fluid::Wrench w{};
  if (by_basis_.empty()) return w;
  for (std::size_t i = 0; i < w.size(); ++i) w[i] = size_ * by_basis_.front()[i];
  return w;
}

std::array<std::complex<double>, 4> ForceByMotion::at(double nu) const {
  std::array<std::complex<double>, 4> force{};
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = by_place_[i];
  if (by_basis_.empty()) return force;
  const Eigen::VectorXcd y = combination(nu).y;
  for (std::size_t k = 0; k < by_basis_.size(); ++k) {
    const auto moved = std::complex<double>(0.0, nu) * y[static_cast<Eigen::Index>(k)];
    for (std::size_t i = 0; i < force.size(); ++i) force[i] += moved * by_basis_[k][i];
  }
  return force;
}

}  // namespace shellback::bearing
