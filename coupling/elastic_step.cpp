#include "coupling/elastic_step.hpp"

#include <cmath>

#include "coupling/gmres.hpp"
#include "coupling/solids.hpp"

namespace shellback::coupling {
namespace {

constexpr double kKrylovTolerance = 1e-4;  ///< tighter gains no Newton iteration (methods 2.2)
constexpr int kMostKrylov = 80;

/// The Winkler system of (1)-(4), factorised.
class WinklerFilm {
 public:
  WinklerFilm(const BearingModel& model, const LoadTarget& target, const FilmEquilibrium& s,
              EquilibriumCost& cost);
  [[nodiscard]] bool good() const { return good_; }

  struct Answer {
    Field du;          ///< film unknowns
    Field dd;          ///< displacement [m]
    Field dP;          ///< total pressure [Pa]
    Field dp_contact;  ///< part of it in contact [Pa]
    std::array<double, 4> dq{};
  };
  /// Solves for right-hand sides a of (1) (empty: 0), b of (2), w of (3).
  [[nodiscard]] Answer solve(const Field& a, const Field& b, const fluid::Wrench& w) const;

 private:
  [[nodiscard]] Field by_gap(const Field& cells) const {
    return fluid::residual_by_gap(model_.scene, s_.flow, cells);
  }

  const BearingModel& model_;
  const FilmEquilibrium& s_;
  int m_;
  double tau_;
  Field kappa_;
  RingFactor& factor_ = film_system().factor;
  std::vector<Field> position_gap_;  ///< B dq per unit component, per cell
  std::vector<Field> response_;      ///< A0^-1 of (1)'s dq column
  std::vector<Field> dP_response_;   ///< dP per unit dq, film response included
  std::array<std::array<double, 4>, 4> stiffness_{};
  bool good_ = false;
};

WinklerFilm::WinklerFilm(const BearingModel& model, const LoadTarget& target,
                         const FilmEquilibrium& s, EquilibriumCost& cost)
    : model_(model), s_(s), m_(target.unknowns), tau_(model.solids->winkler()) {
  const fluid::FilmScene& scene = model.scene;
  const FilmGrid& g = scene.grid;
  const int n = g.cells();
  kappa_.resize(n);
  Field soft(n);
  for (int k = 0; k < n; ++k) {
    kappa_[k] = 1.0 / (1.0 - tau_ * s.dp_contact[k]);
    soft[k] = s.film.full[k] && scene.supply.cell[k] < 0 ? kappa_[k] * tau_ : 0.0;
  }
  RingMatrix& matrix = film_system().matrix;
  fluid::assemble_film(scene, s.flow, fluid::active_set_unknowns(s.film), matrix);
  fluid::add_gap_compliance(scene, s.flow, soft, matrix);
  ++cost.factorizations;
  if (!factor_.factorize(matrix)) return;
  good_ = true;
  for (int l = 0; l < m_; ++l) {
    Field gap(n), follow(n);
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int k = g.index(i, j);
        gap[k] = fluid::gap_slope(l, scene.angles.cos_cell[i], scene.angles.sin_cell[i], g.z[j]);
        follow[k] = kappa_[k] * tau_ * s.dp_contact[k] * gap[k];
      }
    }
    Field b = fluid::residual_by_position(scene, s.flow, l);
    const Field more = by_gap(follow);
    for (int k = 0; k < n; ++k) b[k] = -(b[k] + more[k]);
    factor_.solve(b.data());
    Field dP(n);
    for (int k = 0; k < n; ++k) {
      const double du = s.film.full[k] && scene.supply.cell[k] < 0 ? b[k] : 0.0;
      const double dd = kappa_[k] * tau_ * (du + s.dp_contact[k] * gap[k]);
      dP[k] = du + s.dp_contact[k] * (dd + gap[k]);
    }
    const fluid::Wrench w = fluid::wrench(scene, dP);
    for (int k = 0; k < m_; ++k) stiffness_[k][l] = w[k];
    position_gap_.push_back(std::move(gap));
    response_.push_back(std::move(b));
    dP_response_.push_back(std::move(dP));
  }
}

WinklerFilm::Answer WinklerFilm::solve(const Field& a, const Field& b,
                                       const fluid::Wrench& w) const {
  const fluid::FilmScene& scene = model_.scene;
  const int n = scene.grid.cells();
  Answer x;
  Field shifted(n);
  for (int k = 0; k < n; ++k) shifted[k] = kappa_[k] * b[k];
  x.du = by_gap(shifted);
  for (int k = 0; k < n; ++k) x.du[k] = (a.empty() ? 0.0 : a[k]) - x.du[k];
  factor_.solve(x.du.data());
  x.dd.resize(n);
  x.dP.resize(n);
  x.dp_contact.resize(n);
  for (int k = 0; k < n; ++k) {
    const double du = s_.film.full[k] && scene.supply.cell[k] < 0 ? x.du[k] : 0.0;
    x.dd[k] = kappa_[k] * (b[k] + tau_ * du);
    x.dp_contact[k] = s_.dp_contact[k] * x.dd[k];
    x.dP[k] = du + x.dp_contact[k];
  }
  if (m_ == 0) return x;
  const fluid::Wrench now = fluid::wrench(scene, x.dP);
  for (int k = 0; k < m_; ++k) x.dq[k] = w[k] - now[k];
  if (!solve_small(m_, stiffness_, x.dq)) x.dq = {};
  for (int l = 0; l < m_; ++l) {
    const double q = x.dq[l];
    for (int k = 0; k < n; ++k) {
      const double du = response_[l][k];
      const double full = s_.film.full[k] && scene.supply.cell[k] < 0 ? du : 0.0;
      x.du[k] += q * du;
      x.dd[k] += q * kappa_[k] * tau_ * (full + s_.dp_contact[k] * position_gap_[l][k]);
      x.dP[k] += q * dP_response_[l][k];
      x.dp_contact[k] += q * (dP_response_[l][k] - full);
    }
  }
  return x;
}

}  // namespace

NewtonStep elastic_step(const BearingModel& model, const LoadTarget& target,
                        const FilmEquilibrium& s, const Field& residual,
                        const Field& displacement_residual, EquilibriumCost& cost) {
  NewtonStep step;
  const WinklerFilm film(model, target, s, cost);
  if (!film.good()) return step;
  const double tau = model.solids->winkler();
  const fluid::Wrench aim = target.unknowns > 0 ? wanted_change(s.force, target) : fluid::Wrench{};
  Field a = residual;
  for (double& x : a) x = -x;
  const auto beyond_winkler = [&](const WinklerFilm::Answer& x) {
    Field y = model.solids->compliance(x.dP);
    for (std::size_t k = 0; k < y.size(); ++k) y[k] -= tau * x.dP[k];
    if (!s.contact_growth) return y;
    const Field more = model.solids->widening(*s.contact_growth, x.dp_contact);
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += more[k];
    return y;
  };
  // b = r_d + beyond(dP(b)): the inhomogeneous part first, then GMRES on the linear remainder.
  const auto start = film.solve(a, displacement_residual, aim);
  const Field rhs = beyond_winkler(start);
  const auto apply = [&](const Field& b) {
    Field y = beyond_winkler(film.solve({}, b, {}));
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = b[k] - y[k];
    return y;
  };
  const KrylovResult correction = gmres(apply, rhs, kKrylovTolerance, kMostKrylov);
  cost.krylov_iterations += correction.iterations;
  Field b = displacement_residual;
  for (std::size_t k = 0; k < b.size(); ++k) b[k] += correction.x[k];
  auto x = film.solve(a, b, aim);
  step.good = true;
  step.film = std::move(x.du);
  step.elastic = std::move(x.dd);
  step.q = x.dq;
  return step;
}

}  // namespace shellback::coupling
