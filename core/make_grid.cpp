#include "core/make_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback {
namespace {

constexpr double kMergeFraction = 0.2;  ///< of an even cell: closer edges count as one [-]

/// Rows of cells in a hole: one on few cells, so that all others are left for the film; with 32
/// along the bearing four, which tell a circle from a square.
int rows_of_hole(int full_nz) { return std::clamp(full_nz / 8, 1, 4); }

/// Nearer than this, of an even cell, two edges of a strip are one, too: it has no width [-].
constexpr double kNoStrip = 1e-6;

bool is_strip(const GridEdge& a, const GridEdge& b, double cell) {
  return a.strip >= 0 && a.strip == b.strip && b.at - a.at > kNoStrip * cell;
}

/// Sorted edges less those that lie too close behind another one.
void append_merged(GridEdges& edges, const GridEdge& next, double cell) {
  const GridEdge& last = edges.back();
  if (next.at - last.at > kMergeFraction * cell || is_strip(last, next, cell)) {
    edges.push_back(next);
  }
}

void sort_by_place(GridEdges& edges) {
  std::stable_sort(edges.begin(), edges.end(),
                   [](const GridEdge& a, const GridEdge& b) { return a.at < b.at; });
}

std::vector<double> circumferential_faces(int nt, GridEdges edges) {
  for (GridEdge& e : edges) e.at -= 2.0 * kPi * std::floor(e.at / (2.0 * kPi));
  sort_by_place(edges);
  const double cell = 2.0 * kPi / nt;
  const GridEdge start = edges.empty() ? GridEdge(0.0) : edges.front();
  const GridEdge end(start.at + 2.0 * kPi, start.strip);
  GridEdges merged{start};
  for (const GridEdge& e : edges) append_merged(merged, e, cell);
  const bool closes = end.at - merged.back().at <= kMergeFraction * cell;
  if (closes && merged.size() > 1 && !is_strip(merged.back(), end, cell)) merged.pop_back();
  merged.push_back(end);
  return fitted_faces(merged, nt);
}

/// `edges` lie between `from` and `to`, sorted. Cells at the ends stay as wide as even ones,
/// whatever grows from a hole.
std::vector<double> axial_faces(int n, GridEdge from, double to, GridEdges edges, int rows,
                                int cut) {
  const double even = (to - from.at) / n;
  GridEdge last(to);
  last.beside = even;
  from.beside = std::min(from.beside, even);
  const bool grows = from.beside < even || std::any_of(edges.begin(), edges.end(),
                                                       [&](auto& e) { return e.beside < even; });
  if (!grows) from.beside = last.beside = std::numeric_limits<double>::infinity();
  edges.insert(edges.begin(), from);
  edges.push_back(last);
  return fitted_faces(edges, n, rows, cut);
}

/// Faces of the half z >= 0 of an odd grid: its first cell is half as wide as the next one.
std::vector<double> odd_half_faces(int n, double to, const GridEdges& edges) {
  if (n == 1) return {0.0, to};
  if (edges.empty()) {
    const double dz = to / (n - 0.5);
    std::vector<double> face{0.0};
    for (int j = 0; j < n; ++j) face.push_back(j + 1 == n ? to : (j + 0.5) * dz);
    return face;
  }
  // With edges: mirror them, fit the full width with an odd number of cells in the middle segment.
  const double first = edges.front().at;
  const int full = 2 * n - 1;
  const double share = 2.0 * first / (2.0 * to) * full;
  int middle = std::max(0, static_cast<int>(std::lround((share - 1.0) / 2.0)));  // full cells
  if (std::isfinite(edges.front().beside)) middle = std::max(middle, (rows_of_hole(full) - 1) / 2);
  // each segment outside needs a cell
  middle = std::max(0, std::min(middle, n - 1 - static_cast<int>(edges.size())));
  std::vector<double> face{0.0};
  for (int j = 0; j <= middle; ++j) face.push_back(first * (j + 0.5) / (middle + 0.5));
  const int rows = rows_of_hole(full);
  const auto outer =
      axial_faces(n - 1 - middle, edges.front(), to, {edges.begin() + 1, edges.end()}, rows, rows);
  face.back() = outer.front();
  face.insert(face.end(), outer.begin() + 1, outer.end());
  return face;
}

/// Between axial positions over B/2 and the coordinate in which cells are even.
struct Grading {
  double a;
  [[nodiscard]] double even(double z) const {
    return a > 0.0 ? std::atanh(z * std::tanh(a)) / a : z;
  }
  /// What a width at z is in that coordinate.
  [[nodiscard]] double even_width(double width, double z) const {
    const double most = std::tanh(a);
    return a > 0.0 ? width * most / (a * (1.0 - z * z * most * most)) : width;
  }
  [[nodiscard]] double graded(double x) const {
    return a > 0.0 ? std::tanh(a * x) / std::tanh(a) : x;
  }
};

/// The strip of an edge at z < 0 whose other edge lies at z > 0; -1: none.
int cut_strip(const GridEdge& e, const GridEdges& all) {
  const bool cut = e.strip >= 0 && std::any_of(all.begin(), all.end(), [&](const GridEdge& other) {
                     return other.strip == e.strip && other.at > 0.0;
                   });
  return cut ? e.strip : -1;
}

/// The strip of the edge next to mid-width, of `outwards` from there, if mid-width cuts it; else
/// -1.
int strip_of_middle(const GridEdges& outwards, const GridEdges& all) {
  if (outwards.empty()) return -1;
  const auto low = std::find_if(all.begin(), all.end(), [&](const GridEdge& e) {
    return e.at < 0.0 && e.strip == outwards.front().strip;
  });
  return low != all.end() ? cut_strip(*low, all) : -1;
}

/// Adds the edges that yield where no other is near, if there are cells for all of them.
void append_yielding(GridEdges& edges, const GridEdges& yielding, int full_nz, bool half) {
  const int cells = half ? (full_nz + 1) / 2 : full_nz;
  if (static_cast<int>(edges.size() + yielding.size()) >= cells) return;
  for (const GridEdge& e : yielding) {
    const double near = kMergeFraction * std::min(2.0 / full_nz, 1.0 - std::abs(e.at));
    const bool taken = std::any_of(edges.begin(), edges.end(), [&](const GridEdge& other) {
      return std::abs(e.at - other.at) <= near;
    });
    if (std::abs(e.at) > near && !taken) edges.push_back(e);
  }
  sort_by_place(edges);
}

/// Edges on which axial faces lie [-, over B/2], sorted, those that count as one merged: by their
/// distance on the bearing, so that one of its edges is lost on graded cells where it is on even
/// ones.
GridEdges axial_edges(double end, int full_nz, bool half, const GridEdges& z_edges) {
  GridEdges edges, lands, yielding;
  for (const GridEdge& e : z_edges) {
    const double place = half ? std::abs(e.at) : e.at;
    const bool in_middle = half && place <= 2e-12 * end;
    const bool within = !in_middle && std::abs(e.at) < end * (1.0 - 1e-12);
    if (!within || (half && e.yields && e.at < 0.0)) continue;  // its image yields, too
    GridEdge scaled(place / end, e.strip);
    scaled.beside = e.beside / end;
    (e.yields ? yielding : edges).push_back(scaled);
  }
  sort_by_place(edges);
  const GridEdge middle(0.0, strip_of_middle(edges, z_edges));
  const double cell = 2.0 / full_nz;
  // no face lies at mid-width of an odd half: its first edge has nothing to merge with
  GridEdges merged{half && full_nz % 2 == 0 ? middle : GridEdge(-1.0)};
  for (const GridEdge& e : edges) {
    const double land = 1.0 - std::abs(e.at);
    if (land > kMergeFraction * cell) {
      append_merged(merged, e, cell);
    } else if (e.strip >= 0 && land > kNoStrip * cell) {
      lands.push_back(e);  // it throttles all that leaves there
    }
  }
  merged.erase(merged.begin());
  append_yielding(merged, lands, full_nz, half);
  append_yielding(merged, yielding, full_nz, half);
  return merged;
}

/// Axial faces of all cells that are solved [m].
std::vector<double> graded_faces(double end, int full_nz, bool half, const GridEdges& z_edges,
                                 const Grading& grading) {
  GridEdges edges = axial_edges(end, full_nz, half, z_edges);
  const int rows = rows_of_hole(full_nz);
  for (GridEdge& e : edges) {
    e.beside = grading.even_width(e.beside / rows, e.at);
    e.at = grading.even(e.at);
  }
  const int nz = half ? (full_nz + 1) / 2 : full_nz;
  const bool split = half && full_nz % 2 == 1;
  GridEdge from(half ? 0.0 : -1.0);
  if (half) from.strip = strip_of_middle(edges, z_edges);
  std::vector<double> face =
      split ? odd_half_faces(nz, 1.0, edges)
            : axial_faces(nz, from, 1.0, edges, rows, half ? (rows + 1) / 2 : rows);
  for (double& z : face) z = end * grading.graded(z);
  face.back() = end;
  if (!half) face.front() = -end;
  return face;
}

/// True if with every edge its mirror image is there too.
bool mirror_images(const GridEdges& edges, double width) {
  return std::all_of(edges.begin(), edges.end(), [&](const GridEdge& e) {
    return std::any_of(edges.begin(), edges.end(), [&](const GridEdge& other) {
      return std::abs(e.at + other.at) < 1e-12 * width;
    });
  });
}

GridEdges mirrored(const GridEdges& edges) {
  GridEdges out;
  for (const GridEdge& e : edges) {
    out.push_back(e);
    out.back().at = -e.at;
  }
  return out;
}

/// True if the sorted edges come behind their mirror images, place by place: of the two one does,
/// unless they are alike.
bool behind_its_image(const GridEdges& edges) {
  GridEdges sorted = edges, image = mirrored(edges);
  sort_by_place(sorted);
  sort_by_place(image);
  return std::lexicographical_compare(
      image.begin(), image.end(), sorted.begin(), sorted.end(),
      [](const GridEdge& a, const GridEdge& b) { return a.at < b.at; });
}

/// The same cells seen from the other end; of a grid that holds both halves.
FilmGrid mirrored(FilmGrid g) {
  for (std::vector<double>* z : {&g.z, &g.z_face}) {
    std::reverse(z->begin(), z->end());
    for (double& x : *z) x = -x;
  }
  std::reverse(g.dz.begin(), g.dz.end());
  return g;
}

}  // namespace

FilmGrid make_grid(double radius, double width, int nt, int full_nz, bool half,
                   const GridEdges& phi_edges, const GridEdges& z_edges, double grading) {
  // A bearing that looks alike from both ends gets a grid that does.
  if (!half && full_nz > 1 && mirror_images(z_edges, width)) {
    return full_grid(make_grid(radius, width, nt, full_nz, true, phi_edges, z_edges, grading));
  }
  // And one seen from its other end the mirror image: edges are merged, and cells given out, in the
  // order in which they lie.
  if (!half && behind_its_image(z_edges)) {
    return mirrored(
        make_grid(radius, width, nt, full_nz, false, phi_edges, mirrored(z_edges), grading));
  }
  FilmGrid g;
  g.radius = radius;
  g.width = width;
  g.half = half;
  g.nt = nt;
  const bool split_cell = half && full_nz % 2 == 1;
  g.nz = half ? (full_nz + 1) / 2 : full_nz;
  g.z_face = graded_faces(0.5 * width, full_nz, half, z_edges, Grading{grading});
  g.phi_face = circumferential_faces(nt, phi_edges);
  for (int i = 0; i < nt; ++i) {
    g.phi.push_back(0.5 * (g.phi_face[i] + g.phi_face[i + 1]));
    g.dphi.push_back(g.phi_face[i + 1] - g.phi_face[i]);
  }
  for (int j = 0; j < g.nz; ++j) {
    g.z.push_back(split_cell && j == 0 ? 0.0 : 0.5 * (g.z_face[j] + g.z_face[j + 1]));
    g.dz.push_back(g.z_face[j + 1] - g.z_face[j]);
  }
  return g;
}

}  // namespace shellback
