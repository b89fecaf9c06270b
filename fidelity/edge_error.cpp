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

LastCells last_cells(const FilmGrid& g, const Field& h, int i, bool low) {
  LastCells last;
  for (int k = 0; k < 3; ++k) {
    const int j = low ? k : g.nz - 1 - k;
    last.s[k] = std::abs(g.z[j] - (low ? g.z_face.front() : g.z_face.back()));
    last.h[k] = h[g.index(i, j)];
  }
  return last;
}

}  // namespace

double edge_error(const FilmGrid& g, const Field& h, const fluid::SmallestGap& least) {
  const bool low = !g.half && least.z == g.z_face.front();
  if (g.nz < 3 || (!low && least.z != g.z_face.back())) return 0.0;
  int row = 0;
  for (int i = 1; i < g.nt; ++i) {
    if (std::abs(g.phi[i] - least.phi) < std::abs(g.phi[row] - least.phi)) row = i;
  }
  const LastCells last = last_cells(g, h, row, low);
  return left_of_edge(last.s, last.h);
}

double edge_error(const FilmGrid& g, const Field& h, const Field& in_supply) {
  if (g.nz < 3 || h.empty()) return 0.0;
  double least = *std::min_element(h.begin(), h.end());
  double left = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (const bool low : {true, false}) {
      if (largest(last_cells(g, in_supply, i, low).h) > 0.0) continue;
      const LastCells last = last_cells(g, h, i, low);
      if (last.on_edge() >= least) continue;
      least = last.on_edge();
      left = left_of_edge(last.s, last.h);
    }
  }
  return left;
}

}  // namespace shellback::fidelity
