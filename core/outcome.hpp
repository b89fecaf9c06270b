#pragma once
/// How a solver reports: value, status, history. Failing to converge is a result.
#include <string>
#include <vector>

namespace shellback {

enum class Status {
  converged,
  iteration_limit,  ///< ran out of iterations; the value is the last iterate
  no_steady_state,  ///< shown that no solution exists (limit load, thermal runaway, ...)
  invalid_number,   ///< NaN or infinity met
  interrupted,      ///< stopped by the user
};

/// Why a solve ended, in words for the user. Empty when converged.
struct Verdict {
  Status status = Status::converged;
  std::string reason;  ///< what went wrong, with numbers
  std::string place;   ///< where in the film ("phi 212 deg, z 0.3 mm")
  std::string cure;    ///< what to try
  [[nodiscard]] bool good() const { return status == Status::converged; }
};

template <class T>
struct Outcome {
  T value{};
  Verdict verdict;
  std::vector<double> history;  ///< residual norm per iteration [-], meaning as the solver says
  [[nodiscard]] bool good() const { return verdict.good(); }
};

[[nodiscard]] const char* to_string(Status status);

}  // namespace shellback
