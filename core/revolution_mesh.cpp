#include "core/revolution_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback {
namespace {

constexpr int kLeastRowsPerLayer = 2;      ///< a single row cannot bend between two stiff layers
constexpr int kLeastColsPerHalf = 6;       ///< resolves edge loading of a bearing
constexpr double kLargestRatio = 2.0;      ///< ratio of neighbouring element sizes [-]
constexpr double kSurfaceRowDepths = 2.0;  ///< surface row over decay depth R / n [-]

/// Sizes that sum to `total`, at least `least` of them, the first at most `first`, growing by
/// one common factor between 1 and kLargestRatio.
std::vector<double> graded(double total, double first, int least) {
  const auto sum = [](double q, int n) {
    return q - 1.0 < 1e-12 ? static_cast<double>(n) : (std::pow(q, n) - 1.0) / (q - 1.0);
  };
  int n = least;
  while (first * sum(kLargestRatio, n) < total) ++n;
  if (first * n >= total) return std::vector<double>(n, total / n);
  double low = 1.0, high = kLargestRatio;
  for (int k = 0; k < 60; ++k) {  // bisection to round-off
    const double q = 0.5 * (low + high);
    (first * sum(q, n) < total ? low : high) = q;
  }
  std::vector<double> size(n);
  for (int k = 0; k < n; ++k) size[k] = std::pow(high, k) * total / sum(high, n);
  return size;
}

/// Shape functions of the eight-node serendipity square and their derivatives in (xi, eta).
void serendipity(double xi, double eta, ShapePoint& s) {
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int a = 0; a < 4; ++a) {
    const double x = corner[a][0], y = corner[a][1];
    s.n(a) = 0.25 * (1 + x * xi) * (1 + y * eta) * (x * xi + y * eta - 1);
    s.n_r(a) = 0.25 * x * (1 + y * eta) * (2 * x * xi + y * eta);
    s.n_z(a) = 0.25 * y * (1 + x * xi) * (x * xi + 2 * y * eta);
  }
  const auto along_r = [&](int a, double y) {  // mid-side nodes at xi = 0
    s.n(a) = 0.5 * (1 - xi * xi) * (1 + y * eta);
    s.n_r(a) = -xi * (1 + y * eta);
    s.n_z(a) = 0.5 * y * (1 - xi * xi);
  };
  const auto along_z = [&](int a, double x) {  // mid-side nodes at eta = 0
    s.n(a) = 0.5 * (1 + x * xi) * (1 - eta * eta);
    s.n_r(a) = 0.5 * x * (1 - eta * eta);
    s.n_z(a) = -eta * (1 + x * xi);
  };
  along_r(4, -1.0);
  along_z(5, 1.0);
  along_r(6, 1.0);
  along_z(7, -1.0);
}

/// Faces that lie at -z wherever they lie at z, to round-off.
bool mirrors_itself(const std::vector<double>& face) {
  const double round_off = 1e-12 * (face.back() - face.front());
  for (std::size_t k = 0; k < face.size(); ++k) {
    if (std::abs(face[k] + face[face.size() - 1 - k]) > round_off) return false;
  }
  return true;
}

/// Makes z = 0 a face of a mirrored grid: cuts the middle cell, if there is one.
void put_mid_width(std::vector<double>& face) {
  const auto middle = static_cast<std::ptrdiff_t>(face.size() / 2);
  if (face.size() % 2 == 0) {
    face.insert(face.begin() + middle, 0.0);
  } else {
    face[middle] = 0.0;
  }
}

/// Faces with every interval cut into `parts`.
std::vector<double> cut(const std::vector<double>& face, int parts) {
  std::vector<double> fine{face.front()};
  for (std::size_t k = 1; k < face.size(); ++k) {
    for (int m = 1; m < parts; ++m) {
      fine.push_back(face[k - 1] + (face[k] - face[k - 1]) * m / parts);
    }
    fine.push_back(face[k]);
  }
  return fine;
}

}  // namespace

GaussRule gauss_rule(int order) {
  EXPECTS(order == 2 || order == 3);
  if (order == 2) return {{-std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0)}, {1.0, 1.0}};
  return {{-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}};
}

RevolutionMesh make_revolution_mesh(std::vector<double> r_face, std::vector<int> layer,
                                    std::vector<double> z_face, bool half) {
  EXPECTS(r_face.size() == layer.size() + 1 && z_face.size() >= 2);
  EXPECTS(!half || z_face.front() == 0.0);
  RevolutionMesh mesh;
  mesh.rows = static_cast<int>(r_face.size()) - 1;
  mesh.cols = static_cast<int>(z_face.size()) - 1;
  mesh.half = half;
  const auto add = [&](double r, double z) {
    mesh.r.push_back(r);
    mesh.z.push_back(z);
  };
  for (int k = 0; k <= mesh.rows; ++k) {
    for (int m = 0; m <= 2 * mesh.cols; ++m) {
      add(r_face[k], 0.5 * (z_face[m / 2] + z_face[(m + 1) / 2]));
    }
    if (k == mesh.rows) break;
    for (int m = 0; m <= mesh.cols; ++m) add(0.5 * (r_face[k] + r_face[k + 1]), z_face[m]);
  }
  for (int k = 0; k < mesh.rows; ++k) {
    const int inner = mesh.group_begin(k), outer = mesh.group_begin(k + 1);
    for (int c = 0; c < mesh.cols; ++c) {
      mesh.element.push_back({inner + 2 * c, outer + 2 * c, outer + 2 * c + 2, inner + 2 * c + 2,
                              mesh.mid_node(k, c), outer + 2 * c + 1, mesh.mid_node(k, c + 1),
                              inner + 2 * c + 1});
    }
  }
  mesh.r_face = std::move(r_face);
  mesh.z_face = std::move(z_face);
  mesh.layer = std::move(layer);
  return mesh;
}

RadialRows rows_outwards(double radius, const std::vector<double>& thickness, double first,
                         const std::vector<int>& least) {
  EXPECTS(radius > 0.0 && first > 0.0 && !thickness.empty());
  EXPECTS(least.empty() || least.size() == thickness.size());
  RadialRows rows{{radius}, {}};
  double bottom = radius, size = first;
  for (std::size_t l = 0; l < thickness.size(); ++l) {
    EXPECTS(thickness[l] > 0.0);
    double r = bottom;
    const int fewest = std::max(least.empty() ? 0 : least[l], kLeastRowsPerLayer);
    for (const double dr : graded(thickness[l], size, fewest)) {
      rows.face.push_back(r += dr);
      rows.layer.push_back(static_cast<int>(l));
      size = std::max(first, kLargestRatio * dr);
    }
    rows.face.back() = bottom += thickness[l];  // no drift of the interface
  }
  return rows;
}

RadialRows rows_of_cylinder(double radius, double first) {
  EXPECTS(radius > 0.0 && first > 0.0);
  RadialRows rows{{radius}, {}};
  double r = radius;
  for (const double dr : graded(radius, first, kLeastRowsPerLayer)) {
    rows.face.push_back(r -= dr);
    rows.layer.push_back(0);
  }
  rows.face.back() = 0.0;
  std::reverse(rows.face.begin(), rows.face.end());
  return rows;
}

double surface_row(double radius, int harmonics) {
  return kSurfaceRowDepths * radius / std::max(harmonics, 2);
}

std::vector<double> axial_elements(const FilmGrid& grid, double overhang, int per_cell) {
  EXPECTS(overhang >= 0.0 && per_cell >= 1);
  std::vector<double> cells = grid.z_face;
  if (!grid.half && mirrors_itself(cells)) put_mid_width(cells);
  const int per_half = static_cast<int>(cells.size() - 1) / (grid.half ? 1 : 2);
  const int enough = (kLeastColsPerHalf + per_half - 1) / per_half;
  std::vector<double> face = cut(cells, std::max(per_cell, enough));
  return continued(std::move(face), overhang, grid.half);
}

std::vector<double> continued(std::vector<double> face, double length, bool half) {
  EXPECTS(length >= 0.0 && face.size() >= 2);
  if (length == 0.0) return face;
  const double end = face.back();
  double last = end - face[face.size() - 2];
  if (!half) last = std::min(last, face[1] - face[0]);  // as many elements on either side
  std::vector<double> beyond;
  double z = end;
  for (const double dz : graded(length, kLargestRatio * last, 1)) {
    beyond.push_back(z += dz);
  }
  beyond.back() = end + length;
  face.insert(face.end(), beyond.begin(), beyond.end());
  if (half) return face;
  std::vector<double> full;
  for (auto far = beyond.rbegin(); far != beyond.rend(); ++far) full.push_back(-*far);
  full.insert(full.end(), face.begin(), face.end());
  return full;
}

std::vector<int> nearest_along(const RevolutionMesh& longer, const RevolutionMesh& mesh) {
  const int added = longer.cols - mesh.cols, low = longer.half ? 0 : added / 2;
  EXPECTS(longer.r_face == mesh.r_face && longer.half == mesh.half && added >= 0);
  EXPECTS(longer.half || added % 2 == 0);
  std::vector<int> node;
  for (int k = 0; k <= mesh.rows; ++k) {
    for (int m = 0; m < longer.line_nodes(); ++m) {
      node.push_back(mesh.group_begin(k) + std::clamp(m - 2 * low, 0, 2 * mesh.cols));
    }
    if (k == mesh.rows) break;
    for (int m = 0; m <= longer.cols; ++m) {
      node.push_back(mesh.mid_node(k, std::clamp(m - low, 0, mesh.cols)));
    }
  }
  return node;
}

std::vector<double> halved(const std::vector<double>& face) { return cut(face, 2); }

RadialRows halved(const RadialRows& rows) {
  RadialRows fine{halved(rows.face), {}};
  for (const int l : rows.layer) fine.layer.insert(fine.layer.end(), 2, l);
  return fine;
}

std::vector<ShapePoint> shape_points(const RevolutionMesh& mesh, int row, int col,
                                     GaussOrder order) {
  const double r0 = mesh.r_face[row], dr = mesh.r_face[row + 1] - r0;
  const double z0 = mesh.z_face[col], dz = mesh.z_face[col + 1] - z0;
  const GaussRule in_r = gauss_rule(order.r), in_z = gauss_rule(order.z);
  std::vector<ShapePoint> points;
  for (int a = 0; a < order.r; ++a) {
    for (int b = 0; b < order.z; ++b) {
      ShapePoint s;
      serendipity(in_r.x[a], in_z.x[b], s);
      s.r = r0 + 0.5 * (1.0 + in_r.x[a]) * dr;
      s.z = z0 + 0.5 * (1.0 + in_z.x[b]) * dz;
      s.weight = in_r.w[a] * in_z.w[b] * 0.25 * dr * dz;
      s.n_r *= 2.0 / dr;
      s.n_z *= 2.0 / dz;
      points.push_back(s);
    }
  }
  return points;
}

Eigen::MatrixXd cell_integrals(const RevolutionMesh& mesh, const FilmGrid& grid) {
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(mesh.line_nodes(), grid.nz);
  const GaussRule rule = gauss_rule(2);  // exact for the quadratic trace
  for (int c = 0; c < mesh.cols; ++c) {
    const double z0 = mesh.z_face[c], z1 = mesh.z_face[c + 1];
    for (int j = 0; j < grid.nz; ++j) {
      const double a = std::max(z0, grid.z_face[j]), b = std::min(z1, grid.z_face[j + 1]);
      if (b <= a) continue;
      for (int g = 0; g < 2; ++g) {
        const double z = 0.5 * (a + b) + 0.5 * (b - a) * rule.x[g];
        const double t = (2.0 * z - z0 - z1) / (z1 - z0);
        const double w = 0.5 * (b - a) * rule.w[g];
        p(2 * c, j) += w * 0.5 * t * (t - 1.0);
        p(2 * c + 1, j) += w * (1.0 - t * t);
        p(2 * c + 2, j) += w * 0.5 * t * (t + 1.0);
      }
    }
  }
  return p;
}

}  // namespace shellback
