#include "validation/rig/rig_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "core/stopwatch.hpp"

namespace shellback::validation {
namespace {

using bearing::CourseRun;
using bearing::CycleResult;
using bearing::Stretch;
using bearing::Tier;

std::vector<RigCourse> courses_of(const RigPlan& plan) {
  std::vector<RigCourse> courses;
  for (const double peak : plan.peaks) {
    courses.push_back({peak, nullptr, 0, up_and_down(plan.rpm), {}, false});
  }
  if (!plan.bands) return courses;
  const double peak = plan.peaks.back();
  courses.push_back({peak, &heavier_bodies(), 1, up_and_down(plan.rpm), {}, false});
  courses.push_back({peak, nullptr, 0, plan.few_rpm, {}, {}});  // what the following stand beside
  for (const RigUnknown& unknown : body_unknowns()) {
    for (const int end : {0, 1}) courses.push_back({peak, &unknown, end, plan.few_rpm, {}, {}});
  }
  return courses;
}

CourseRun run_of(const RigPlan& plan, const RigCourse& course, RigBearing bearing,
                 const StudyCrew& crew, int task) {
  std::vector<Stretch> stretches;
  for (const double rpm : course.rpm) {
    const RigSetting setting{course.peak, rpm, plan.grid, course.unknown, course.end};
    stretches.push_back({rig_case(bearing, setting), plan.hold});
  }
  bearing::WarmUpOptions options;
  options.T_start = plan.T_start;
  const auto control = crew.control(task, stretches.front().subject, app::RunOf::course,
                                    {{"speeds", course.rpm}, {"hold", {plan.hold}}});
  return run_course(stretches, Tier::tehd, options, control);
}

void run_courses(const RigPlan& plan, StudyCrew& crew, RigStudy& study) {
  study.courses = courses_of(plan);
  const int count = 2 * static_cast<int>(study.courses.size());
  crew.work("run-up and run-down", count, [&](int k) {
    RigCourse& course = study.courses[static_cast<std::size_t>(k / 2)];
    course.run[k % 2] = run_of(plan, course, kRigBearings[k % 2], crew, k);
    course.tried[k % 2] = true;
  });
}

std::vector<RigPoint> points_of(const RigPlan& plan) {
  std::vector<RigPoint> points;
  for (const double peak : plan.peaks) {
    for (const double rpm : plan.rpm) {
      for (const OilModel oil : kOilModels) points.push_back({peak, rpm, oil, 0.0, nullptr, 0, {}});
      points.push_back({peak, rpm, OilModel::full, plan.warmer, nullptr, 0, {}});
    }
    if (!plan.bands) continue;
    for (const double rpm : plan.few_rpm) {
      for (const RigUnknown& unknown : film_unknowns()) {
        for (const int end : {0, 1}) {
          points.push_back({peak, rpm, OilModel::full, 0.0, &unknown, end, {}});
        }
      }
    }
  }
  return points;
}

/// Temperature of the shell's back in the run-up [K]; not-a-number if it did not come so far.
double temperature_of(const RigStudy& study, const RigPoint& p, RigBearing bearing) {
  const RigCourse* course = study.course(p.peak);
  for (std::size_t k = 0; k <= course->highest(); ++k) {
    if (course->rpm[k] != p.rpm) continue;
    const bearing::Instant* i = course->at(bearing, k);
    return i == nullptr ? NAN : i->T_shell_back;
  }
  return NAN;
}

/// Smallest film at mid-width over the cycle [m].
double mid_width_film(const CycleResult& r) {
  const auto& g = r.fields.grid;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < g.nt; ++i) least = std::min(least, r.fields.h_min[g.index(i, g.nz / 2)]);
  return least;
}

RigCycle cycle_of(const RigPlan& plan, const RigPoint& p, RigBearing bearing, double T,
                  const StudyCrew& crew, int task) {
  RigCycle out;
  out.T = T + p.warmer;
  if (std::isnan(T)) {
    out.verdict = {Status::iteration_limit};
    return out;
  }
  const RigSetting setting{p.peak, p.rpm, plan.grid, p.unknown, p.end};
  const bearing::Case c = rig_isothermal_case(bearing, setting, p.oil, out.T);
  out.T = *c.oil_temperature;
  const auto control = crew.control(task, c);
  const CycleResult r = solve_cycle(c, Tier::isothermal, control);
  StudyCrew::keep(control, r.verdict);
  out.verdict = r.verdict;
  if (!r.verdict.good()) return out;
  out.torque = value_of(r, "friction_torque");
  out.asperity = value_of(r, "friction_torque_asperity");
  out.p_max = value_of(r, "p_max");
  out.h_min = value_of(r, "h_min");
  const double h = mid_width_film(r);
  out.shear = h > 0.0 ? std::abs(c.operation.omega) * c.bearing.radius / h : NAN;
  return out;
}

void run_points(const RigPlan& plan, StudyCrew& crew, RigStudy& study) {
  study.points = points_of(plan);
  const int count = 2 * static_cast<int>(study.points.size());
  crew.work("isothermal cycles", count, [&](int k) {
    RigPoint& p = study.points[static_cast<std::size_t>(k / 2)];
    const RigBearing bearing = kRigBearings[k % 2];
    p.cycle[k % 2] = cycle_of(plan, p, bearing, temperature_of(study, p, bearing), crew, k);
  });
}

void sum_up(RigStart& start) {
  start.full_film = NAN;
  if (!start.verdict[0].good() || !start.verdict[1].good()) return;
  start.series = rig_series(start.cycle[0].instants, start.cycle[1].instants);
  start.breakaway = rig_torque(value_of(start.cycle[0], "breakaway_torque"),
                               value_of(start.cycle[1], "breakaway_torque"));
  start.full_film = time_of_full_film(start.series, start.breakaway);
}

void run_starts(const RigPlan& plan, StudyCrew& crew, RigStudy& study) {
  for (const double T : plan.start_films) {
    for (const bool worn : {false, true}) {
      study.starts.emplace_back();
      study.starts.back().worn = worn;
      study.starts.back().T = T;
    }
  }
  const std::size_t count = study.starts.size();
  std::vector<std::array<double, 2>> boundary(count);
  crew.work("start and stop", 2 * static_cast<int>(count), [&](int k) {
    RigStart& start = study.starts[static_cast<std::size_t>(k / 2)];
    const bearing::Case c =
        rig_start_stop_case(kRigBearings[k % 2], start.worn, start.T, plan.grid);
    const auto control = crew.control(k, c);
    start.cycle[k % 2] = solve_cycle(c, Tier::isothermal, control);
    StudyCrew::keep(control, start.cycle[k % 2].verdict);
    start.verdict[k % 2] = start.cycle[k % 2].verdict;
    boundary[static_cast<std::size_t>(k / 2)][k % 2] =
        c.surfaces.contact->friction * std::hypot(c.cycle->x.front(), c.cycle->y.front()) *
        c.bearing.radius;
  });
  for (std::size_t k = 0; k < count; ++k) {
    sum_up(study.starts[k]);
    study.starts[k].boundary = rig_torque(boundary[k][0], boundary[k][1]);
  }
}

}  // namespace

RigPlan rig_plan(bool quick) {
  RigPlan plan;
  plan.peaks = {40e3, 80e3};
  plan.rpm = {1000, 2000, 3000, 4000, 5000, 6000, 7000};
  plan.few_rpm = {1000, 4000, 7000};
  plan.start_films = {333.15, 313.15, 353.15};
  if (quick) {
    plan.rpm = plan.few_rpm;
    plan.grid = {48, 7};
    plan.bands = false;
  }
  return plan;
}

std::vector<double> up_and_down(const std::vector<double>& rpm) {
  std::vector<double> all = rpm;
  for (std::size_t k = rpm.size(); k-- > 1;) all.push_back(rpm[k - 1]);
  return all;
}

const bearing::Instant* RigCourse::at(RigBearing bearing, std::size_t k) const {
  const CourseRun& r = run[bearing == RigBearing::test ? 0 : 1];
  return k < r.ends.size() ? &r.instants[r.ends[k]] : nullptr;
}

std::size_t RigCourse::highest() const {
  return static_cast<std::size_t>(std::max_element(rpm.begin(), rpm.end()) - rpm.begin());
}

double RigCourse::torque(std::size_t k) const {
  const bearing::Instant* test = at(RigBearing::test, k);
  const bearing::Instant* support = at(RigBearing::support, k);
  return test == nullptr || support == nullptr ? NAN : rig_torque(test->torque, support->torque);
}

bool RigPoint::good() const { return cycle[0].verdict.good() && cycle[1].verdict.good(); }

double RigPoint::torque() const {
  return good() ? rig_torque(cycle[0].torque, cycle[1].torque) : NAN;
}

std::string RigPoint::reason() const {
  std::string words;
  for (int k = 0; k < 2; ++k) {
    const Verdict& v = cycle[k].verdict;
    if (v.good()) continue;
    const char* bearing = to_string(kRigBearings[k]);
    std::string why = app::reason_of(v);
    if (std::isnan(cycle[k].T)) {
      why = fmt::format("no film temperature: the run-up of the {} did not reach this speed",
                        bearing);
    }
    words += fmt::format("{}{}: {}", words.empty() ? "" : "; ", bearing,
                         why.empty() ? to_string(v.status) : why);
  }
  return words;
}

const RigPoint* RigStudy::point(double peak, double rpm, OilModel oil, double warmer) const {
  const auto found = std::find_if(points.begin(), points.end(), [&](const RigPoint& p) {
    return p.peak == peak && p.rpm == rpm && p.oil == oil && p.warmer == warmer &&
           p.unknown == nullptr;
  });
  return found == points.end() ? nullptr : &*found;
}

const RigCourse* RigStudy::course(double peak) const {
  const auto found = std::find_if(courses.begin(), courses.end(), [&](const RigCourse& c) {
    return c.peak == peak && c.unknown == nullptr;
  });
  return found == courses.end() ? nullptr : &*found;
}

int RigStudy::count_failed() const {
  const auto failed = [](const Verdict& v) { return !v.good() && v.status != Status::interrupted; };
  int n = 0;
  for (const RigCourse& c : courses) {
    for (const CourseRun& r : c.run) n += failed(r.end.verdict) ? 1 : 0;
  }
  for (const RigPoint& p : points) {
    for (const RigCycle& c : p.cycle) n += failed(c.verdict) ? 1 : 0;
  }
  for (const RigStart& s : starts) {
    for (const Verdict& v : s.verdict) n += failed(v) ? 1 : 0;
  }
  return n;
}

RigStudy run_rig_study(const StudyOptions& options) {
  return run_rig_study(rig_plan(options.quick), options);
}

int count_pieces(const RigPlan& plan) {
  const std::size_t starts = 2 * plan.start_films.size();
  return static_cast<int>(2 * (starts + courses_of(plan).size() + points_of(plan).size()));
}

RigStudy run_rig_study(const RigPlan& plan, const StudyOptions& options) {
  const Stopwatch watch;
  RigStudy study;
  study.plan = plan;
  study.threads = options.threads;
  study.specific_area = rig_projected_area();
  StudyCrew crew(options);
  run_starts(plan, crew, study);
  run_courses(plan, crew, study);
  run_points(plan, crew, study);
  study.interrupted = crew.stopped();
  study.wall_s = watch.seconds();
  return study;
}

}  // namespace shellback::validation
