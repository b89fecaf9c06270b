#pragma once
/// How a solver reports: value, status, history. Failing to converge is a result.
#include <cmath>
#include <vector>

#include "core/ending.hpp"

namespace shellback {

enum class Status {
  converged,
  iteration_limit,  ///< ran out of iterations; the value is the last iterate
  no_steady_state,  ///< shown that no solution exists (limit load, thermal runaway, ...)
  invalid_number,   ///< NaN or infinity met
  interrupted,      ///< stopped by the user
};

/// A place in the film. Not-a-number: all round, along the whole width; both: no place.
struct FilmPlace {
  double phi = NAN;  ///< [rad]
  double z = NAN;    ///< from mid-width [m]
  [[nodiscard]] bool operator==(const FilmPlace&) const = default;
};

/// How a solve ended; its words are those of app/words.
struct Verdict {
  Status status = Status::converged;
  Ending ending = ending::Plain::none;
  FilmPlace place{};             ///< where it shows
  std::vector<Verdict> cause{};  ///< the ending within, for which this one stands; one, or none

  [[nodiscard]] bool good() const { return status == Status::converged; }
  [[nodiscard]] bool is(ending::Plain plain) const {
    const auto* own = as<ending::Plain>();
    return own != nullptr && *own == plain;
  }
  /// The data of an ending of this kind; none if it is another.
  template <class E>
  [[nodiscard]] const E* as() const {
    return std::get_if<E>(&ending);
  }
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
