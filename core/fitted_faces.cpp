#include "core/fitted_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback {
namespace {

/// Largest ratio of two cells beside a hole [-]: what finite volumes bear without losing an order
/// (textbook: 1.2 to 1.5).
constexpr double kMostGrowth = 1.5;

/// Faces behind `a` up to `b`, of `n` cells that are even or, where an edge has a width for those
/// beside it, grow from that.
void add_segment(const GridEdge& a, const GridEdge& b, int n, std::vector<double>& face) {
  const double length = b.at - a.at;
  const bool even = std::min(a.beside, b.beside) >= length / n;
  const auto size = [&](int k, double growth) {
    return even ? length / n
                : std::min(a.beside * std::pow(growth, k), b.beside * std::pow(growth, n - 1 - k));
  };
  const auto whole = [&](double growth) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) sum += size(k, growth);
    return sum;
  };
  double growth = kMostGrowth;
  if (!even && whole(growth) > length) {
    growth = root_between([&](double g) { return whole(g) - length; }, 1.0, growth, kRoundOff);
  }
  const double scale = length / whole(growth);
  double at = a.at;
  for (int k = 0; k < n; ++k) {
    at += scale * size(k, growth);
    face.push_back(k + 1 == n ? b.at : even ? a.at + length * (k + 1) / n : at);
  }
}

/// The widest of them.
double widest(const GridEdge& a, const GridEdge& b, int n) {
  std::vector<double> face{a.at};
  add_segment(a, b, n, face);
  double most = 0.0;
  for (int k = 0; k < n; ++k) most = std::max(most, face[k + 1] - face[k]);
  return most;
}

bool is_hole(const GridEdge& a, const GridEdge& b) {
  return std::isfinite(b.beside) && a.strip >= 0 && a.strip == b.strip;
}

/// Cells that it takes to grow from a hole's rows, or between two, by no more than kMostGrowth
/// each, the first against its row as well.
int cells_that_grow(const GridEdge& a, const GridEdge& b, int most) {
  for (int n = 1; n < most; ++n) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      sum += std::min(a.beside * std::pow(kMostGrowth, k),
                      b.beside * std::pow(kMostGrowth, n - 1 - k));
    }
    if (!(kMostGrowth * sum < b.at - a.at)) return n;
  }
  return most;
}

/// What each segment has at least, the first of these that there are cells for: `rows` in holes
/// (`cut` in one that mid-width cuts, the first) and beside them as many as grow from those; only
/// the rows; one each.
std::vector<int> least_counts(const GridEdges& edges, int n, int rows, int cut) {
  const int segments = static_cast<int>(edges.size()) - 1;
  for (const bool grow : {true, false}) {
    std::vector<int> least(segments, 1);
    int sum = 0;
    for (int s = 0; s < segments; ++s) {
      if (is_hole(edges[s], edges[s + 1])) {
        least[s] = s == 0 ? cut : rows;
      } else if (grow) {
        least[s] = cells_that_grow(edges[s], edges[s + 1], n);
      }
      sum += least[s];
    }
    if (sum <= n) return least;
  }
  return std::vector<int>(segments, 1);
}

}  // namespace

std::vector<double> fitted_faces(const GridEdges& edges, int n, int rows, int cut) {
  const int segments = static_cast<int>(edges.size()) - 1;
  if (segments > n) {
    throw InputError(fmt::format(
        "{} cells cannot resolve {} edges of supplies (each needs a cell); use a finer grid", n,
        segments));
  }
  const double total = edges.back().at - edges.front().at;
  const std::vector<int> least = least_counts(edges, n, rows, cut);
  std::vector<int> count(segments);
  int used = 0;
  for (int s = 0; s < segments; ++s) {
    const double share = (edges[s + 1].at - edges[s].at) / total * n;
    count[s] = std::max(least[s], static_cast<int>(std::lround(share)));
    used += count[s];
  }
  // One more where cells are widest, or one less where the widest of those that are left comes out
  // smallest; what a hole has beyond its rows goes first.
  while (used != n) {
    int best = -1;
    double worst = 0.0;
    for (int s = 0; s < segments; ++s) {
      if (used > n && count[s] == least[s]) continue;
      const double key = used < n ? (edges[s + 1].at - edges[s].at) / count[s]
                         : is_hole(edges[s], edges[s + 1])
                             ? INFINITY
                             : 1.0 / widest(edges[s], edges[s + 1], count[s] - 1);
      if (best < 0 || key > worst) {
        worst = key;
        best = s;
      }
    }
    const int more = used < n ? 1 : -1;
    count[best] += more;
    used += more;
  }
  std::vector<double> face{edges.front().at};
  for (int s = 0; s < segments; ++s) add_segment(edges[s], edges[s + 1], count[s], face);
  return face;
}

}  // namespace shellback
