#include "fidelity/edge_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

double left_of_edge(const std::array<double, 3>& s, const std::array<double, 3>& h) {
  constexpr double kPunch = 0.5;  // a beside a flat rigid punch
  const double last = h[1] - h[0];
  if (!(last > 0.0)) return 0.0;
  const auto missed = [&](double a) {
    const double power[]{std::pow(s[0], a), std::pow(s[1], a), std::pow(s[2], a)};
    return (power[2] - power[1]) / (power[1] - power[0]) - (h[2] - h[1]) / last;
  };
  if (missed(1.0) <= 0.0) return 0.0;
  const double a = missed(kPunch) >= 0.0 ? kPunch : root_between(missed, kPunch, 1.0, kRoundOff);
  const double first = std::pow(s[0], a);
  return last * (first / (std::pow(s[1], a) - first) - s[0] / (s[1] - s[0]));
}

namespace {

struct LastCells {
  std::array<double, 3> s{};  ///< from the edge, nearest first [m]
  std::array<double, 3> h{};  ///< [m]
  [[nodiscard]] double on_edge() const { return h[0] - (h[1] - h[0]) * s[0] / (s[1] - s[0]); }
};

/// Of row i from cell j inwards, on whose outer face z the film ends.
LastCells last_cells(const FilmGrid& g, const Field& h, int i, int j, int inwards) {
  LastCells last;
  const double edge = inwards > 0 ? g.z_face[j] : g.z_face[j + 1];
  for (int k = 0; k < 3; ++k) {
    last.s[k] = std::abs(g.z[j + k * inwards] - edge);
    last.h[k] = h[g.index(i, j + k * inwards)];
  }
  return last;
}

LastCells at_side(const FilmGrid& g, const Field& h, int i, bool low) {
  return last_cells(g, h, i, low ? 0 : g.nz - 1, low ? 1 : -1);
}

/// The least gap on the edges at which lands of three cells and more end along the bearing beside a
/// supply, as (1) leads to it where it falls; infinite: there are none.
double least_beside_supplies(const FilmGrid& g, const Field& h, const Field& in_supply) {
  double least = INFINITY;
  for (int i = 0; i < g.nt; ++i) {
    const auto film = [&](int j) { return j >= 0 && j < g.nz && in_supply[g.index(i, j)] == 0.0; };
    for (int j = 0; j < g.nz; ++j) {
      for (const int inwards : {-1, 1}) {
        const int beside = j - inwards;
        const bool ends = film(j) && beside >= 0 && beside < g.nz && !film(beside);
        if (!ends || !film(j + inwards) || !film(j + 2 * inwards)) continue;
        const LastCells last = last_cells(g, h, i, j, inwards);
        if (last.h[1] <= last.h[0]) continue;
        least = std::min(least, last.on_edge() - left_of_edge(last.s, last.h));
      }
    }
  }
  return least;
}

}  // namespace

double edge_error(const bearing::Solution& s) {
  return edge_error(s.model.domain.grid, s.film.gap.cell, fluid::in_supply(s.model.supply),
                    s.film.least);
}

double part_hidden_at_edge(const bearing::Solution& s) {
  return s.film.least.h > 0.0 ? edge_error(s) / s.film.least.h : 0.0;
}

double edge_error(const FilmGrid& g, const Field& h, const Field& in_supply,
                  const fluid::SmallestGap& least) {
  if (g.nz < 3) return 0.0;
  const double beside = least.h - least_beside_supplies(g, h, in_supply);
  const bool low = !g.half && least.z == g.z_face.front();
  if (!low && least.z != g.z_face.back()) return std::max(0.0, beside);
  int row = 0;
  for (int i = 1; i < g.nt; ++i) {
    if (std::abs(g.phi[i] - least.phi) < std::abs(g.phi[row] - least.phi)) row = i;
  }
  const LastCells last = at_side(g, h, row, low);
  return std::max(left_of_edge(last.s, last.h), beside);
}

double edge_error(const FilmGrid& g, const Field& h, const Field& in_supply) {
  if (g.nz < 3 || h.empty()) return 0.0;
  double least = *std::min_element(h.begin(), h.end());
  double left = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (const bool low : {true, false}) {
      if (largest(at_side(g, in_supply, i, low).h) > 0.0) continue;
      const LastCells last = at_side(g, h, i, low);
      if (last.on_edge() >= least) continue;
      least = last.on_edge();
      left = left_of_edge(last.s, last.h);
    }
  }
  return std::max(left, least - least_beside_supplies(g, h, in_supply));
}

}  // namespace shellback::fidelity
