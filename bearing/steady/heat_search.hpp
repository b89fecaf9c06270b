#pragma once
/// The ways to a steady film with heat, one by one; tiers.cpp says in what order they are gone.
#include <optional>

#include "bearing/control.hpp"
#include "bearing/film/follow.hpp"
#include "bearing/heat/heat_iteration.hpp"
#include "bearing/heat/heat_march.hpp"
#include "bearing/steady/level.hpp"

namespace shellback::bearing {

/// Each way leaves `s` at its last state and answers how it ended.
class HeatSearch {
 public:
  HeatSearch(Solution& s, Level level, const SolveControl& control)
      : s_(s), level_(level), control_(control) {}

  /// The film in oil and between walls of the supply's temperature.
  [[nodiscard]] Verdict cold_film();
  /// The outer iteration over film, heat and deformation.
  [[nodiscard]] Verdict iterate();
  /// From a light load, or a low speed, along the branch of steady states to the whole. Where the
  /// branch turns back or is lost, the bearing is followed in time from its last state under a
  /// little more: it runs away, or comes to rest on another branch, which is followed on.
  [[nodiscard]] Verdict along_branch();
  /// From the first film of cold_film through time, walls warming with their heat capacities.
  [[nodiscard]] Verdict through_time();

  /// True if the search ends here: found, stopped, or no work is left.
  [[nodiscard]] bool over(const Verdict& v) const;
  /// Methods of others know nothing of a path of loads.
  [[nodiscard]] bool may_follow() const;
  /// True if along_branch has found the beginning of one, on this grid.
  [[nodiscard]] bool branch_begun() const { return has_own_limit(s_); }
  /// Film and heat as they stand.
  [[nodiscard]] Reached here() const { return {s_.film, s_.heat}; }
  void back_to(Reached at);

 private:
  [[nodiscard]] double supply_temperature() const;
  [[nodiscard]] std::optional<Branch> follow();
  [[nodiscard]] Verdict no_branch() const;
  [[nodiscard]] Corrector corrector() const;
  /// Along the branch on which the bearing has come to rest beyond the one that ended. Where it
  /// rests under the whole as loosely as on the way, and no result is found: the one that ended,
  /// lost, for the reason that the whole has.
  [[nodiscard]] Branch follow_on(const Branch& ended);
  /// Whether the end of such a branch is that of all states with more: of more load, and of more
  /// speed, which makes more heat; but for a loaded journal that rubs, whose film carries better
  /// the faster it turns, and for supplies, which cool: other branches may begin above.
  [[nodiscard]] bool speaks_of_more(const Branch& branch);
  /// `after`: what followed in time.
  [[nodiscard]] Verdict ended(const Branch& branch, const MarchEnd& after);

  Solution& s_;
  Level level_;
  const SolveControl& control_;
  FilmEquilibrium cold_film_;
};

}  // namespace shellback::bearing
