#include "bearing/course.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/first_film.hpp"
#include "bearing/kept_run.hpp"
#include "bearing/march_members.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

bool alike(const std::optional<Profile>& a, const std::optional<Profile>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->phi == b->phi && a->z == b->z && a->height == b->height;
}

bool alike(const std::optional<EdgeOpening>& a, const std::optional<EdgeOpening>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->depth == b->depth && a->length == b->length;
}

/// Supplies at the same places: the film's cells follow them.
bool alike(const std::vector<Supply>& a, const std::vector<Supply>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Supply& x, const Supply& y) {
    return x.kind == y.kind && x.angle == y.angle && x.z == y.z && x.arc == y.arc &&
           x.length == y.length && x.diameter == y.diameter;
  });
}

bool same_bore(const Bearing& a, const Bearing& b) {
  return a.radius == b.radius && a.width == b.width && a.radial_clearance == b.radial_clearance &&
         alike(a.profile, b.profile) && alike(a.shape, b.shape) && alike(a.wear, b.wear) &&
         alike(a.edge_relief, b.edge_relief) && alike(a.chamfer, b.chamfer);
}

bool one_bearing(const Case& a, const Case& b) {
  return a.shell == b.shell && a.shaft == b.shaft && same_bore(a.bearing, b.bearing) &&
         alike(a.supplies, b.supplies) && a.model.grid == b.model.grid &&
         a.model.axial_spacing == b.model.axial_spacing &&
         a.bearing.reference_temperature == b.bearing.reference_temperature &&
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
      : tier_(tier), options_(options), control_(control), within_(control), run_(run) {
    within_.kept = nullptr;
  }

  /// How many stretches lie behind, those of a run that is gone on with included.
  std::size_t take_up() {
    if (control_.kept != nullptr && control_.kept->under_way() != nullptr)
      members(*control_.kept->under_way());
    return run_.ends.size();
  }

  /// True if the stretch was passed to its end.
  bool pass(const Stretch& s) {
    const MarchEnd end = s.subject.cycle ? over_cycles(s) : steadily_loaded(s);
    run_.end = end;
    run_.end.t += begun_;
    keep_stopped(control_.kept, end.verdict);
    if (!end.verdict.good()) return false;
    run_.ends.push_back(run_.instants.size() - 1);
    begun_ += s.duration;
    return true;
  }

 private:
  void tell(Instant i, const std::function<void(Tape&)>& march) {
    i.t += begun_;
    run_.instants.push_back(i);
    keep_between(control_.kept, [&](Tape& tape) {
      members(tape);
      march(tape);
    });
  }
  void members(Tape& tape) { tape(run_.instants, run_.ends, begun_); }

  MarchEnd over_cycles(const Stretch& s) {
    constexpr double kSteps = 16.0;    // of a stretch at least: see the head of course.hpp
    constexpr double kFirst = 1024.0;  // first step, of a stretch: shorter where walls move by 2 K
    CycleSearch search(s.subject, tier_, within_);
    CycleMarch march;
    const auto members = [&](Tape& tape) {
      search.ended(tape);
      tape(march);
    };
    MarchSpan span;
    span.duration = s.duration;
    span.shortest = s.subject.cycle->length();
    span.first = std::max(span.shortest, s.duration / kFirst);
    span.longest = std::max(span.shortest, s.duration / kSteps);
    span.until_rest = false;
    if (!take_up_noted(control_.kept, members)) {
      search.begin(s.subject.supplies.front().temperature);
      march.bodies =
          bodies_ ? *bodies_ : uniform_bodies(*search.film().model().solids, options_.T_start);
      // The orbit is found before its heat counts.
      if (!search.pass_between(march.bodies.walls)) return {search.verdict()};
    }
    const MarchEnd end =
        march_over_cycles(search, span, march, [&](const Instant& i) { tell(i, members); });
    bodies_ = std::move(march.bodies);
    return end;
  }

  MarchEnd steadily_loaded(const Stretch& s) {
    Solution now;
    const Physics physics = physics_of(s.subject, tier_);
    now.target = load_target(s.subject);
    now.model = make_bearing(s.subject, physics, s.subject.model.grid);
    const SolidEffects effects{physics.elastic, true, physics.thermal_deformation, true};
    if (!solids_) {
      solids_ = std::make_shared<const Solids>(s.subject, now.model.scene.grid, effects);
      if (!bodies_) bodies_ = uniform_bodies(*solids_, options_.T_start);
    }
    now.model.solids = solids_;
    MarchStand stand{bodies_->state};
    const auto members = [&](Tape& tape) { tape(now, stand); };
    if (!take_up_noted(control_.kept, members)) {
      const Verdict v = begin_film(now);
      if (!v.good()) return {v};
    }
    MarchOptions march;
    march.end = s.duration;
    march.error = options_.error;
    const MarchEnd end =
        march_heat(now, stand, march, within_, [&](const Instant& i) { tell(i, members); });
    bodies_->state = std::move(stand.bodies);
    return end;
  }

  /// Between the bodies as they are.
  Verdict begin_film(Solution& now) {
    const SolidTemperature walls = solids_->at(bodies_->state);
    now.heat = cold_heat(now.model, options_.T_start);
    now.heat.T_shell = walls.shell.surface;
    now.heat.T_shaft = walls.shaft.temperature;
    if (now.model.physics.thermal_deformation)
      now.heat.thermal_deformation = walls.thermal_deformation;
    now.T_film = now.model.input.supplies.front().temperature;
    return first_film(now, now.T_film, within_);
  }

  Tier tier_;
  const WarmUpOptions& options_;
  const SolveControl& control_;
  SolveControl within_;  ///< of what lies between two steps
  CourseRun& run_;
  double begun_ = 0.0;  ///< of the present stretch [s]
  std::optional<Bodies> bodies_;
  std::shared_ptr<const Solids> solids_;  ///< under a steady load
};

}  // namespace

double CourseRun::imbalance_at_ends() const {
  double most = 0.0;
  for (const std::size_t k : ends) {
    const Instant& i = instants[k];
    most = larger(most, std::abs(i.heat_in - i.heat_out - i.stored) / std::abs(i.heat_in));
  }
  return most;
}

CourseRun run_course(const std::vector<Stretch>& stretches, Tier tier, const WarmUpOptions& options,
                     const SolveControl& control) {
  expect_course(stretches, tier);
  CourseRun run;
  Course course(tier, options, control, run);
  for (std::size_t k = course.take_up(); k < stretches.size() && course.pass(stretches[k]);) ++k;
  return run;
}

}  // namespace shellback::bearing
