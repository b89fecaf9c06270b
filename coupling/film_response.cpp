#include "coupling/film_response.hpp"

#include "coupling/gmres.hpp"
#include "coupling/solids.hpp"

namespace shellback::coupling {

LinearFilm::LinearFilm(const BearingModel& model, const FilmEquilibrium& s, double tolerance)
    : model_(model), s_(s), tolerance_(tolerance) {
  const fluid::FilmScene& scene = model.scene;
  const int n = scene.grid.cells();
  RingMatrix matrix;
  fluid::assemble_film(scene, s.flow, fluid::active_set_unknowns(s.film), matrix);
  if (!s.elastic.empty()) {
    tau_ = model.solids->winkler();
    kappa_.resize(n);
    Field soft(n);
    for (int k = 0; k < n; ++k) {
      kappa_[k] = 1.0 / (1.0 - tau_ * s.dp_contact[k]);
      soft[k] = free(k) ? kappa_[k] * tau_ : 0.0;
    }
    fluid::add_gap_compliance(scene, s.flow, soft, matrix);
  }
  good_ = factor_.factorize(matrix);
}

LinearFilm::Answer LinearFilm::winkler(const Field& a, const Field& b, const Field& r) const {
  const int n = model_.scene.grid.cells();
  Answer x{a, {}, Field(n)};
  if (kappa_.empty()) {
    factor_.solve(x.u.data());
    for (int k = 0; k < n; ++k) x.P[k] = (free(k) ? x.u[k] : 0.0) + r[k];
    return x;
  }
  // d = kappa (b + tau (u_F + r)): the part that is known beforehand moves the right-hand side.
  Field known(n);
  for (int k = 0; k < n; ++k) known[k] = kappa_[k] * (b[k] + tau_ * r[k]);
  std::vector<double> phi, z;
  fluid::to_faces(model_.scene.grid, known, phi, z);
  const Field moved = fluid::outflow_by_gap(model_.scene, s_.flow, phi, z);
  for (int k = 0; k < n; ++k) x.u[k] -= moved[k];
  factor_.solve(x.u.data());
  x.d = std::move(known);
  for (int k = 0; k < n; ++k) {
    const double du = free(k) ? x.u[k] : 0.0;
    x.d[k] += kappa_[k] * tau_ * du;
    x.P[k] = du + r[k] + s_.dp_contact[k] * x.d[k];
  }
  return x;
}

FilmResponse LinearFilm::solve(const Field& a, const Field& r) {
  constexpr int kMostKrylov = 80;
  const std::size_t n = a.size();
  const Field none(n, 0.0);
  Answer x = winkler(a, none, r);
  if (!kappa_.empty()) {
    const auto beyond_winkler = [&](const Field& P) {
      Field y = model_.solids->compliance(P);
      for (std::size_t k = 0; k < n; ++k) y[k] -= tau_ * P[k];
      return y;
    };
    const Field rhs = beyond_winkler(x.P);
    const auto apply = [&](const Field& b) {
      Field y = beyond_winkler(winkler(none, b, none).P);
      for (std::size_t k = 0; k < n; ++k) y[k] = b[k] - y[k];
      return y;
    };
    const KrylovResult found = gmres(apply, rhs, tolerance_, kMostKrylov);
    krylov_iterations_ += found.iterations;
    converged_ = converged_ && found.reduction <= tolerance_;
    x = winkler(a, found.x, r);
  }
  FilmResponse answer{Field(n, 0.0), std::move(x.d), std::move(x.P)};
  for (std::size_t k = 0; k < n; ++k) {
    if (!s_.film.full[k]) answer.theta[k] = x.u[k];
  }
  return answer;
}

FilmResponse LinearFilm::to_position(int component) {
  const fluid::FilmScene& scene = model_.scene;
  const FilmGrid& g = scene.grid;
  Field a = fluid::outflow_by_position(scene, s_.flow, component);
  for (double& x : a) x = -x;
  Field r(g.cells());
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      r[k] = s_.dp_contact[k] * fluid::gap_slope(component, scene.angles.cos_cell[i],
                                                 scene.angles.sin_cell[i], g.z[j]);
    }
  }
  return solve(a, r);
}

FilmResponse LinearFilm::to_storage(const Field& s) {
  Field a = s;
  for (double& x : a) x = -x;
  return solve(a, Field(s.size(), 0.0));
}

}  // namespace shellback::coupling
