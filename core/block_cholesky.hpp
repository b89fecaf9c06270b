#pragma once
/// Cholesky factorisation of a symmetric positive definite block tridiagonal matrix.
///
///   A = L L^T,  L = [ L_0                 ]     W_k = E L_k^-T, E the coupling of block k to
///                   [ W_0  L_1            ]     the first rows (the head) of block k + 1
///                   [      W_1  L_2  ...  ]     [textbook: block elimination]
///
/// Blocks are dense and may differ in size (zero included). Made for meshes of revolution, whose
/// node groups couple a group only to the corner line of the next; dense blocks of 20 to 150 rows
/// run several times faster than a general sparse factorisation of the same matrix.
#include <vector>

#include "core/eigen.hpp"

namespace shellback {

struct BlockTridiagonal {
  /// Square blocks; only the lower triangles are read. After `factorise`: L_k.
  std::vector<Eigen::MatrixXd> diagonal;
  /// coupling[k] is head rows of block k + 1 x columns of block k. After `factorise`: W_k.
  std::vector<Eigen::MatrixXd> coupling;
};

/// Replaces the matrix by its factor. False if it is not positive definite; the content is then
/// of no use.
[[nodiscard]] bool factorise(BlockTridiagonal& matrix);

/// Right-hand sides or solutions, one matrix (rows of the block x right-hand sides) per block.
using BlockColumns = std::vector<Eigen::MatrixXd>;

/// y <- L^-1 y. Blocks before `first` must be zero and are skipped.
void solve_lower(const BlockTridiagonal& factor, BlockColumns& y, int first = 0);

/// x <- L^-T x on the blocks 0 .. last, as if the matrix ended there (default: all blocks).
/// Together with solve_lower this solves the system with the blocks after `last` held at zero:
/// the leading blocks of L are the factor of the leading blocks of A.
void solve_upper(const BlockTridiagonal& factor, BlockColumns& x, int last = -1);

}  // namespace shellback
