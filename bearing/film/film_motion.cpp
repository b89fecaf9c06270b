#include "bearing/film/film_motion.hpp"

#include <cmath>

#include "core/decompositions.hpp"
#include "core/largest.hpp"
#include "fluid/gap.hpp"

namespace shellback::bearing {
namespace {

using Motion = Eigen::VectorXd;

/// s_k of a cell; tilts over half the width, so that all are without unit.
Motion slopes(const FilmGrid& g, int unknowns, int c) {
  const double phi = g.phi[c / g.nz];
  Motion s(unknowns);
  for (int k = 0; k < unknowns; ++k) {
    s(k) = fluid::gap_slope(k, std::cos(phi), std::sin(phi), g.z[c % g.nz]);
    if (k > 1) s(k) /= 0.5 * g.width;
  }
  return s;
}

/// (1) with tilts as they move the ends [m]; none for a journal that is held.
Motion fitted(const FilmGrid& g, int unknowns, const Field& force, const Field& dh) {
  if (unknowns == 0) return Motion(0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Motion b = Motion::Zero(unknowns);
  for (int c = 0; c < g.cells(); ++c) {
    if (!(force[c] > 0.0)) continue;
    const Motion s = slopes(g, unknowns, c);
    A += force[c] * s * s.transpose();
    b += force[c] * dh[c] * s;
  }
  return least_squares(A, b);
}

}  // namespace

Field carrying_force(const BearingModel& model, const FilmEquilibrium& film) {
  Field pressure = film.film.p;
  for (std::size_t c = 0; c < film.p_contact.size(); ++c) pressure[c] += film.p_contact[c];
  return per_cell(model.domain.grid, std::move(pressure));
}

std::array<double, 4> motion_of(const BearingModel& model, int unknowns, const Field& force,
                                const Field& dh) {
  const FilmGrid& g = model.domain.grid;
  const Motion a = fitted(g, unknowns, force, dh);
  std::array<double, 4> out{};
  for (int k = 0; k < unknowns; ++k) out[k] = k < 2 ? a(k) : a(k) / (0.5 * g.width);
  return out;
}

std::vector<char> away_from_fronts(const FilmGrid& g, const std::vector<char>& full) {
  std::vector<char> inside = full;
  for (int i = 0; i < g.nt; ++i) {
    const int east = g.next(i);
    const int west = g.previous(i);
    for (int j = 0; j < g.nz; ++j) {
      bool all = full[g.index(i, j)];
      for (const int n : {east, west, g.next(east), g.previous(west)}) {
        all = all && full[g.index(n, j)];
      }
      inside[g.index(i, j)] = all;
    }
  }
  return inside;
}

std::optional<double> loaded_film_error(const BearingModel& model, int unknowns,
                                        const FilmEquilibrium& film, const Field& missing,
                                        const std::vector<char>& counts, double loaded) {
  const FilmGrid& g = model.domain.grid;
  const auto carries = [&](int c) {
    return film.film.full[c] && model.supply.cell[c] < 0 && film.film.p[c] >= loaded;
  };
  const double sigma = model.domain.rough.sigma;
  const auto height = [&](int c) { return std::max(film.gap.cell[c], 0.0) + sigma; };
  Field force(g.cells(), 0.0);
  double sum = 0.0, squares = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (!counts[c] || !carries(c)) continue;
    force[c] = film.film.p[c] * g.area(c);
    sum += force[c];
    squares += force[c] * std::pow(missing[c] / height(c), 2);
  }
  if (!(sum > 0.0)) return std::nullopt;
  const Motion a = fitted(g, unknowns, force, missing);
  double worst = std::sqrt(squares / sum);
  for (int c = 0; c < g.cells(); ++c) {
    if (carries(c)) worst = larger(worst, std::abs(a.dot(slopes(g, unknowns, c))) / height(c));
  }
  return worst;
}

}  // namespace shellback::bearing
