#include "bearing/over_time/course.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Supplies at the same places: the film's cells follow them.
bool same_places(const std::vector<Supply>& a, const std::vector<Supply>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Supply& x, const Supply& y) {
    return x.kind == y.kind && x.angle == y.angle && x.z == y.z && x.arc == y.arc &&
           x.length == y.length && x.diameter == y.diameter;
  });
}

bool one_bearing(const Case& a, const Case& b) {
  return a.shell == b.shell && a.shaft == b.shaft && a.bearing == b.bearing &&
         same_places(a.supplies, b.supplies) && a.model.grid == b.model.grid &&
         a.model.axial_spacing == b.model.axial_spacing &&
         a.cycle.has_value() == b.cycle.has_value();
}

void expect_course(const std::vector<Stretch>& stretches, Tier tier) {
  if (tier != Tier::thd && tier != Tier::tehd) {
    throw InputError("model.tier",
                     "a course follows the walls' temperatures, which only the tiers thd and tehd "
                     "have");
  }
  if (stretches.empty()) throw InputError("course", "it has no stretch; give one speed or more");
  for (const Stretch& s : stretches) {
    if (!(s.duration > 0.0) || !std::isfinite(s.duration)) {
      throw InputError("course", "the time of a stretch is not a positive number of seconds");
    }
    if (s.subject.cycle && !s.subject.cycle->repeats()) {
      throw InputError("load_cycle.period",
                       "a course passes many cycles, and the case has a single event; give its "
                       "period");
    }
    if (!one_bearing(s.subject, stretches.front().subject)) {
      throw InputError(
          "course",
          "its stretches are not of one bearing: shell, shaft, bore, clearance, places of "
          "supplies and grid may not change on the way");
    }
  }
}

/// The course as it is passed.
class Course {
 public:
  Course(Tier tier, const WarmUpOptions& options, const SolveControl& control, CourseRun& run)
      : tier_(tier), options_(options), control_(control), run_(run) {}

  /// How many stretches lie behind: of a run that is gone on with.
  std::size_t take_up() {
    begin_take_up(control_.kept, told_);
    return run_.ends.size();
  }

  /// True if the stretch was passed to its end.
  bool pass(const Stretch& s) {
    WarmUpOptions one = options_;
    one.end = s.duration;
    one.steps = s.steps;
    Solution now;
    const MarchEnd end =
        pass_stretch(s.subject, tier_, one, StretchEnd::in_time, control_, carried_, now,
                     [this](Instant i, const std::function<void(Tape&)>& stand) {
                       i.t += begun_;
                       run_.instants.push_back(i);
                       keep_between(control_.kept, told_, stand);
                     });
    keep_stopped(control_.kept, end.verdict);
    run_.end = end;
    run_.end.t += begun_;
    if (!end.verdict.good()) return false;
    run_.solution = std::move(now);
    run_.ends.push_back(run_.instants.size() - 1);
    run_.warnings.push_back(end.warnings);
    begun_ += s.duration;
    return true;
  }

 private:
  Tier tier_;
  const WarmUpOptions& options_;
  const SolveControl& control_;
  CourseRun& run_;
  double begun_ = 0.0;  ///< of the present stretch [s]
  CarriedOver carried_;
  std::function<void(Tape&)> told_ = [this](Tape& tape) {
    tape(run_.instants, run_.ends, run_.warnings, begun_);
  };
};

}  // namespace

double CourseRun::imbalance_at_ends() const {
  double most = 0.0;
  if (over_cycles) {
    std::size_t first = 0;
    for (const std::size_t k : ends) {
      most = larger(most, imbalance_over(instants, first, k + 1));
      first = k + 1;
    }
    return most;
  }
  for (const std::size_t k : ends) most = larger(most, imbalance_of(instants[k]));
  return most;
}

CourseRun run_course(const std::vector<Stretch>& stretches, Tier tier, const WarmUpOptions& options,
                     const SolveControl& control) {
  expect_course(stretches, tier);
  CourseRun run;
  run.over_cycles = stretches.front().subject.cycle.has_value();
  Course course(tier, options, control, run);
  for (std::size_t k = course.take_up(); k < stretches.size() && course.pass(stretches[k]);) ++k;
  return run;
}

}  // namespace shellback::bearing
