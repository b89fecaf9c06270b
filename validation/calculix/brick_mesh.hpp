#pragma once
/// A body of revolution's sector in twenty-node bricks, for a finite-element program.
///
/// Tensor product of lines in r, phi and z. On the lattice of corner lines and the lines halfway
/// between them, node (i, j, k) exists where at most one of the indices is odd.
#include <array>
#include <vector>

namespace shellback::calculix {

/// Corner lines, ascending.
struct Lines {
  std::vector<double> r;    ///< [m]
  std::vector<double> phi;  ///< [rad]
  std::vector<double> z;    ///< [m]
};

struct Node {
  double r = 0.0, phi = 0.0, z = 0.0;
  int i = 0, j = 0, k = 0;  ///< on the lattice
};

class BrickMesh {
 public:
  explicit BrickMesh(const Lines& lines);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Index in nodes() of lattice point (i, j, k), -1 if there is none.
  [[nodiscard]] int at(int i, int j, int k) const {
    return index_[(static_cast<std::size_t>(i) * sides_[1] + j) * sides_[2] + k];
  }
  /// Bricks along r (0), phi (1), z (2).
  [[nodiscard]] int bricks(int direction) const { return sides_[direction] / 2; }
  /// Nodes of a brick in the order of Abaqus and CalculiX (C3D20): corners, then edges.
  [[nodiscard]] std::array<int, 20> brick(int a, int b, int c) const;

 private:
  std::array<int, 3> sides_;  ///< of the lattice
  std::vector<Node> nodes_;
  std::vector<int> index_;
};

/// Lattice offsets (0, 1, 2) of a brick's nodes, in that order.
[[nodiscard]] const std::array<std::array<int, 3>, 20>& brick_offsets();

/// Gauss-Legendre rule of five points on (-1, 1).
struct GaussPoint {
  double x, w;
};
[[nodiscard]] const std::array<GaussPoint, 5>& gauss_points();

}  // namespace shellback::calculix
