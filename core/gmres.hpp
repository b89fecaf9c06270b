#pragma once
/// GMRES without restart for small relative tolerances and few iterations; x starts from zero.
///
/// SPGMR of SUNDIALS without preconditioner, scaling and restart. Stops at |b - A x| <= tolerance
/// |b| or after `most` iterations, whichever is first.
#include <functional>
#include <vector>

namespace shellback {

struct KrylovResult {
  std::vector<double> x;
  int iterations = 0;
  double reduction = 1.0;  ///< |b - A x| / |b| reached [-]
};

using LinearOperator = std::function<std::vector<double>(const std::vector<double>&)>;

[[nodiscard]] KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b,
                                 double tolerance, int most);

}  // namespace shellback
