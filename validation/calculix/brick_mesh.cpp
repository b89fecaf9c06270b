#include "validation/calculix/brick_mesh.hpp"

namespace shellback::calculix {
namespace {

double on_lattice(const std::vector<double>& line, int m) {
  return 0.5 * (line[m / 2] + line[(m + 1) / 2]);
}

int lattice_side(const std::vector<double>& line) { return 2 * static_cast<int>(line.size()) - 1; }

}  // namespace

BrickMesh::BrickMesh(const Lines& lines)
    : sides_{lattice_side(lines.r), lattice_side(lines.phi), lattice_side(lines.z)} {
  for (int i = 0; i < sides_[0]; ++i) {
    for (int j = 0; j < sides_[1]; ++j) {
      for (int k = 0; k < sides_[2]; ++k) {
        const bool exists = i % 2 + j % 2 + k % 2 <= 1;
        index_.push_back(exists ? static_cast<int>(nodes_.size()) : -1);
        if (!exists) continue;
        nodes_.push_back(
            {on_lattice(lines.r, i), on_lattice(lines.phi, j), on_lattice(lines.z, k), i, j, k});
      }
    }
  }
}

std::array<int, 20> BrickMesh::brick(int a, int b, int c) const {
  std::array<int, 20> node{};
  for (std::size_t m = 0; m < node.size(); ++m) {
    const auto& o = brick_offsets()[m];
    node[m] = at(2 * a + o[0], 2 * b + o[1], 2 * c + o[2]);
  }
  return node;
}

const std::array<std::array<int, 3>, 20>& brick_offsets() {
  static constexpr std::array<std::array<int, 3>, 20> kOffsets{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
       {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
       {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
  return kOffsets;
}

const std::array<GaussPoint, 5>& gauss_points() {
  static constexpr std::array<GaussPoint, 5> kPoints{{{-0.906179845938664, 0.236926885056189},
                                                      {-0.538469310105683, 0.478628670499366},
                                                      {0.0, 0.568888888888889},
                                                      {0.538469310105683, 0.478628670499366},
                                                      {0.906179845938664, 0.236926885056189}}};
  return kPoints;
}

}  // namespace shellback::calculix
