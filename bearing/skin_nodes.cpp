#include "bearing/skin_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/between.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// Shape functions of a row's inner face, middle and outer face at a part x of its height.
std::array<double, 3> shapes(double x) {
  return {(1.0 - x) * (1.0 - 2.0 * x), 4.0 * x * (1.0 - x), x * (2.0 * x - 1.0)};
}

/// (1), for the radii of the mesh: two for each row, its inner face and its middle, and the
/// outermost face.
Eigen::MatrixXd radii_of_skin(const RevolutionMesh& mesh, SkinOf surface, const SkinNodes& skin) {
  const auto depth_of = [&](double r) {
    return surface == SkinOf::bore ? r - mesh.r_face.front() : mesh.r_face.back() - r;
  };
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2 * mesh.rows + 1, skin.count);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(2 * mesh.rows + 1);
  const GaussRule rule = gauss_rule(3);  // exact for shapes, temperature and radius together
  const auto integrate = [&](int row, double from, double to, const auto& add) {
    const double bottom = mesh.r_face[row], height = mesh.r_face[row + 1] - bottom;
    for (std::size_t g = 0; g < rule.x.size(); ++g) {
      const double r = 0.5 * (from + to) + 0.5 * (to - from) * rule.x[g];
      const std::array<double, 3> n = shapes((r - bottom) / height);
      for (int k = 0; k < 3; ++k) add(2 * row + k, 0.5 * rule.w[g] * (to - from) * r * n[k], r);
    }
  };
  for (int row = 0; row < mesh.rows; ++row) {
    const double low = mesh.r_face[row], high = mesh.r_face[row + 1];
    integrate(row, low, high, [&](int line, double w, double) { own[line] += w; });
    for (std::size_t s = 0; s + 1 < skin.depth.size(); ++s) {
      const double ends[] = {skin.depth[s], skin.depth[s + 1]};
      const double at[] = {
          surface == SkinOf::bore ? mesh.r_face.front() + ends[0] : mesh.r_face.back() - ends[1],
          surface == SkinOf::bore ? mesh.r_face.front() + ends[1] : mesh.r_face.back() - ends[0]};
      const double from = std::max(low, at[0]), to = std::min(high, at[1]);
      if (!(to > from)) continue;
      integrate(row, from, to, [&](int line, double w, double r) {
        const double x = (depth_of(r) - ends[0]) / (ends[1] - ends[0]);
        const auto node = static_cast<Eigen::Index>(s);
        held(line, node) += w * (1.0 - x);
        if (node + 1 < skin.count) held(line, node + 1) += w * x;
      });
    }
  }
  for (int line = 0; line < own.size(); ++line) {
    if (line == 0 && mesh.r_face.front() == 0.0) {  // the axis has no part in the integral
      const Between at = shellback::between(skin.depth, depth_of(0.0));
      held(0, std::min(at.left, skin.count - 1)) = at.left < skin.count ? 1.0 : 0.0;
    } else {
      held.row(line) /= own[line];
    }
  }
  return held;
}

}  // namespace

Eigen::SparseMatrix<double> nodes_of_skins(const RevolutionMesh& mesh, const FilmGrid& grid,
                                           SkinOf surface, const SkinNodes& skin) {
  EXPECTS(skin.count > 0 && static_cast<int>(skin.depth.size()) - skin.count <= 1);
  const Eigen::MatrixXd along_r = radii_of_skin(mesh, surface, skin);
  std::vector<Eigen::Triplet<double>> entries;
  const double end = grid.z_face.back() * (1.0 + 1e-9);
  const auto put = [&](int node, int line) {
    const double z = mesh.z[node];
    if (std::abs(z) > end) return;
    const Between at = shellback::between(grid.z, grid.half ? std::abs(z) : z);
    const std::array<std::pair<int, double>, 2> cells{
        {{at.left, 1.0 - at.weight}, {at.right, at.weight}}};
    for (const auto& [j, part] : cells) {
      if (part == 0.0) continue;
      for (int s = 0; s < skin.count; ++s) {
        const double x = along_r(line, s);
        if (x != 0.0) entries.emplace_back(node, j * skin.count + s, part * x);
      }
    }
  };
  for (int k = 0; k <= mesh.rows; ++k) {
    for (int m = 0; m < mesh.line_nodes(); ++m) put(mesh.group_begin(k) + m, 2 * k);
    if (k == mesh.rows) break;
    for (int m = 0; m <= mesh.cols; ++m) put(mesh.mid_node(k, m), 2 * k + 1);
  }
  Eigen::SparseMatrix<double> out(mesh.nodes(), grid.nz * skin.count);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace shellback::bearing
