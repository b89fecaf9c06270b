#include "app/pictures/svg_contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr double kStraight = 0.05;  ///< distance from a line that nobody sees [px]
constexpr double kFullTurn = 360.0;

/// One set of values per circumferential position, sorted into [0, 360] with both ends added.
Surface closed_around(const FilmGrid& grid, const std::vector<double>& y,
                      const std::vector<double>& values) {
  const int nt = grid.nt;
  const auto ny = y.size();
  EXPECTS(values.size() == static_cast<std::size_t>(nt) * ny);
  std::vector<double> degree(nt);
  for (int i = 0; i < nt; ++i) {
    const double turns = grid.phi[i] / (2.0 * kPi);
    degree[i] = kFullTurn * (turns - std::floor(turns));
  }
  std::vector<int> order(nt);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return degree[a] < degree[b]; });
  // Weight of the first position at the seam, between the last (one turn back) and the first.
  const int first = order.front();
  const int last = order.back();
  const double gap = degree[first] + kFullTurn - degree[last];
  const double w = gap > 0.0 ? (kFullTurn - degree[last]) / gap : 1.0;
  Surface s{{}, y, {}};
  const auto add_seam = [&](double x) {
    s.x.push_back(x);
    for (std::size_t j = 0; j < ny; ++j) {
      s.value.push_back(w * values[first * ny + j] + (1.0 - w) * values[last * ny + j]);
    }
  };
  if (degree[first] > 0.0) add_seam(0.0);
  for (const int i : order) {
    s.x.push_back(degree[i]);
    s.value.insert(s.value.end(), values.begin() + i * ny, values.begin() + (i + 1) * ny);
  }
  add_seam(kFullTurn);
  return s;
}

/// Marching squares on the surface, framed by a ring of nodes of the same places that lie below
/// the level, so that every contour closes.
class Marching {
 public:
  Marching(const Surface& s, double level, const Place& place)
      : s_(s),
        level_(level),
        place_(place),
        nx_(static_cast<int>(s.x.size()) + 2),
        ny_(static_cast<int>(s.y.size()) + 2),
        next_(2 * nx_ * ny_, -1) {}

  std::string path() {
    for (int i = 0; i + 1 < nx_; ++i) {
      for (int j = 0; j + 1 < ny_; ++j) link_cell(i, j);
    }
    std::string d;
    for (int start = 0; start < static_cast<int>(next_.size()); ++start) {
      std::vector<Point> loop;
      for (int edge = start; next_[edge] >= 0;) {
        loop.push_back(crossing(edge));
        edge = std::exchange(next_[edge], -1);
      }
      append_loop(d, loop);
    }
    return d;
  }

 private:
  [[nodiscard]] bool framed(int i, int j) const {
    return i == 0 || j == 0 || i == nx_ - 1 || j == ny_ - 1;
  }
  [[nodiscard]] double value(int i, int j) const {
    return framed(i, j) ? level_ - 1.0 : s_.at(i - 1, j - 1);
  }
  [[nodiscard]] bool inside(int i, int j) const { return value(i, j) >= level_; }
  [[nodiscard]] double x(int i) const { return s_.x[std::clamp(i - 1, 0, nx_ - 3)]; }
  [[nodiscard]] double y(int j) const { return s_.y[std::clamp(j - 1, 0, ny_ - 3)]; }
  // Edge from node (i, j): even numbers along x, odd numbers along y.
  [[nodiscard]] int along_x(int i, int j) const { return 2 * (i * ny_ + j); }
  [[nodiscard]] int along_y(int i, int j) const { return 2 * (i * ny_ + j) + 1; }

  /// Links the crossings of one cell so that the inside lies to the left.
  void link_cell(int i, int j) {
    // Corners and edges counter-clockwise; edge k leads from corner k to corner k + 1.
    const std::array<bool, 4> in{inside(i, j), inside(i + 1, j), inside(i + 1, j + 1),
                                 inside(i, j + 1)};
    const std::array<int, 4> edge{along_x(i, j), along_y(i + 1, j), along_x(i, j + 1),
                                  along_y(i, j)};
    for (int k = 0; k < 4; ++k) {
      if (!in[k] || in[(k + 1) % 4]) continue;  // the contour leaves the inside on edge k ...
      int back = (k + 3) % 4;                   // ... and came in on the nearest edge behind it
      while (in[back]) back = (back + 3) % 4;
      next_[edge[k]] = edge[back];
    }
  }

  [[nodiscard]] Point crossing(int edge) const {
    const int node = edge / 2;
    const int i = node / ny_;
    const int j = node % ny_;
    const int i2 = i + (edge % 2 == 0 ? 1 : 0);
    const int j2 = j + (edge % 2 == 0 ? 0 : 1);
    const double a = value(i, j);
    const double b = value(i2, j2);
    const double t = (level_ - a) / (b - a);
    return place_(x(i) + t * (x(i2) - x(i)), y(j) + t * (y(j2) - y(j)));
  }

  static void append_loop(std::string& d, const std::vector<Point>& loop) {
    std::vector<Point> kept;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point& after = loop[(k + 1) % loop.size()];
      if (kept.empty() || !on_line(kept.back(), loop[k], after)) kept.push_back(loop[k]);
    }
    if (kept.size() > 2) d += line_path(kept) + "Z";
  }

  static bool on_line(Point a, Point p, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length == 0.0) return std::hypot(p.x - a.x, p.y - a.y) < kStraight;
    const bool between = (p.x - a.x) * dx + (p.y - a.y) * dy >= 0.0;
    return between && std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) < kStraight * length;
  }

  const Surface& s_;
  double level_;
  const Place& place_;
  int nx_;
  int ny_;
  std::vector<int> next_;  ///< per edge the edge on which its contour goes on; -1: none
};

}  // namespace

bool drawable(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Surface unrolled(const FilmGrid& grid, const Field& field) {
  const int nz = grid.nz;
  EXPECTS(field.size() == static_cast<std::size_t>(grid.cells()));
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  std::vector<double> y{1e3 * grid.z_face.front()};
  for (const double z : grid.z) y.push_back(1e3 * z);
  y.push_back(1e3 * grid.z_face.back());
  std::vector<double> values;
  for (int i = 0; i < grid.nt; ++i) {
    const auto rim = [&](int j, int inner, double z) {
      const double a = field[grid.index(i, j)];
      if (nz == 1) return a;
      const double slope = (field[grid.index(i, inner)] - a) / (grid.z[inner] - grid.z[j]);
      return std::clamp(a + slope * (z - grid.z[j]), *low, *high);
    };
    values.push_back(rim(0, 1, grid.z_face.front()));
    for (int j = 0; j < nz; ++j) values.push_back(field[grid.index(i, j)]);
    values.push_back(rim(nz - 1, nz - 2, grid.z_face.back()));
  }
  return closed_around(grid, y, values);
}

Surface around(const FilmGrid& grid, const std::vector<double>& y,
               const std::vector<double>& values) {
  return closed_around(grid, y, values);
}

std::string superlevel_path(const Surface& surface, double level, const Place& place) {
  return Marching(surface, level, place).path();
}

void draw_bands(Svg& svg, const Surface& surface, const ColourScale& scale, const Place& place,
                int bands) {
  const double lowest = *std::min_element(surface.value.begin(), surface.value.end());
  svg.fill(superlevel_path(surface, lowest, place), colour_at(scale.map, 0.5 / bands));
  for (int k = 1; k < bands; ++k) {
    const double level = scale.low + (scale.high - scale.low) * k / bands;
    svg.fill(superlevel_path(surface, level, place), colour_at(scale.map, (k + 0.5) / bands));
  }
}

}  // namespace shellback::app
