#pragma once
/// The film by active sets: semismooth Newton on (1)-(2) of reynolds.hpp.
///
/// Each step solves the linearised (1) for p in full cells and theta in cavitated ones, then moves
/// cells across. If an active set comes back, the steps are those of the Fischer-Burmeister form.
/// A step that leaves the range of the pressure law stops the iteration: what is to be done then is
/// the caller's (reynolds.cpp); it may go on from another state.
#include <set>

#include "fluid/film_solution.hpp"
#include "fluid/film_update.hpp"

namespace shellback::fluid {

enum class ActiveSetEnd {
  converged,
  limit,         ///< of the steps, or of Fischer-Burmeister's line search
  singular,      ///< the film's matrix; the verdict tells of an empty ring
  not_a_number,  ///< the verdict tells where
  beyond_law,    ///< a cell asked for alpha dp >= 1: too long a step, or a film that does not exist
};

class ActiveSet {
 public:
  /// The arguments must outlive it.
  ActiveSet(const FilmScene& scene, const Gap& gap, const Field& profile, const OilLaw& oil,
            const FilmState& guess, const ReynoldsOptions& options);

  /// Iterates on out.value.state until it ends; after beyond_law it may be called again.
  ActiveSetEnd run();
  /// The verdict of ActiveSetEnd::limit.
  [[nodiscard]] Verdict stopped() const;

  Outcome<FilmSolution> out;  ///< of all runs; its verdict is set for not_a_number and singular

 private:
  bool factorize();
  ActiveSetEnd converged();
  ActiveSetEnd singular();
  [[nodiscard]] UpdateReport newton_step(Field& residual);

  const FilmScene& scene_;
  const Gap& gap_;
  const Field& profile_;
  const OilLaw& oil_;
  double tolerance_;
  int most_;
  int it_ = 0;
  bool cycling_ = false;
  std::set<std::size_t> seen_;  ///< hashes of active sets met
  RingMatrix matrix_;
};

}  // namespace shellback::fluid
