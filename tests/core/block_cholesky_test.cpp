#include "core/block_cholesky.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace shellback;

namespace {

constexpr int kSize[4] = {5, 0, 7, 3};  // an empty block in the middle
constexpr int kHead[4] = {3, 0, 4, 3};

struct System {
  BlockTridiagonal blocks;
  Eigen::MatrixXd dense;
};

/// Random symmetric matrix made definite by its diagonal.
System random_system(int first_block) {
  std::srand(1);
  System s;
  Eigen::Index total = 0;
  for (int k = first_block; k < 4; ++k) total += kSize[k];
  s.dense = Eigen::MatrixXd::Zero(total, total);
  Eigen::Index at = 0;
  for (int k = first_block; k < 4; ++k) {
    Eigen::MatrixXd d = Eigen::MatrixXd::Random(kSize[k], kSize[k]);
    d = (d + d.transpose() + 12.0 * Eigen::MatrixXd::Identity(kSize[k], kSize[k])).eval();
    s.blocks.diagonal.push_back(d);
    s.dense.block(at, at, kSize[k], kSize[k]) = d;
    if (k < 3) {
      const Eigen::MatrixXd c = Eigen::MatrixXd::Random(kHead[k + 1], kSize[k]);
      s.blocks.coupling.push_back(c);
      s.dense.block(at + kSize[k], at, kHead[k + 1], kSize[k]) = c;
      s.dense.block(at, at + kSize[k], kSize[k], kHead[k + 1]) = c.transpose();
    }
    at += kSize[k];
  }
  return s;
}

}  // namespace

TEST_CASE("BlockSolutionIsTheDenseSolution", "[block_cholesky]") {
  System s = random_system(0);
  REQUIRE(factorise(s.blocks));
  const Eigen::MatrixXd rhs = Eigen::MatrixXd::Random(15, 2);
  BlockColumns x{rhs.topRows(5), Eigen::MatrixXd(0, 2), rhs.middleRows(5, 7), rhs.bottomRows(3)};
  solve_lower(s.blocks, x);
  solve_upper(s.blocks, x);
  Eigen::MatrixXd joined(15, 2);
  joined << x[0], x[2], x[3];
  CHECK((s.dense * joined - rhs).norm() < 1e-13 * rhs.norm());
}

TEST_CASE("LeadingBlocksOfTheFactorSolveTheHeldSystem", "[block_cholesky]") {
  System s = random_system(2);  // blocks of 7 and 3
  const Eigen::MatrixXd leading = s.dense.topLeftCorner(7, 7);
  REQUIRE(factorise(s.blocks));
  const Eigen::MatrixXd rhs = Eigen::MatrixXd::Random(7, 1);
  BlockColumns x{rhs, Eigen::MatrixXd::Zero(3, 1)};
  solve_lower(s.blocks, x);
  solve_upper(s.blocks, x, 0);
  CHECK((leading * x[0] - rhs).norm() < 1e-13 * rhs.norm());
}

TEST_CASE("IndefiniteMatrixIsReported", "[block_cholesky]") {
  System s = random_system(2);
  s.blocks.diagonal[1](0, 0) = -1.0;
  CHECK_FALSE(factorise(s.blocks));
}
