#include <fmt/format.h>

#include <cmath>

#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "validation/rig/rig_page.hpp"
#include "validation/rig/rig_statements.hpp"

namespace shellback::validation {
namespace {

std::string changed_words(const RigUnknown* unknown, int end) {
  if (unknown == nullptr) return "";
  return fmt::format(", {} at its {} end", unknown->name, end == 0 ? "low" : "high");
}

std::string shown(double v) { return std::isfinite(v) ? fmt::format("{:.3f}", v) : "-"; }

void write_torques(std::ostream& out, const RigStudy& s, double peak) {
  out << fmt::format("{:.0f} kN, friction torque of the rig [N m]\n", 1e-3 * peak);
  out << fmt::format("{:>8} {:>10} {:>8} {:>8} {:>9} {:>11} {:>9} {:>9}\n", "rpm", "film [C]",
                     "eta(T)", "(T, p)", "(T, p, g)", "3 K warmer", "heat, up", "down");
  const RigCourse* course = s.course(peak);
  for (std::size_t k = 0; k < s.plan.rpm.size(); ++k) {
    const double rpm = s.plan.rpm[k];
    const auto torque = [&](OilModel oil, double warmer) {
      const RigPoint* p = s.point(peak, rpm, oil, warmer);
      return p == nullptr ? std::string("-") : shown(p->torque());
    };
    const bearing::Instant* up = course == nullptr ? nullptr : course->at(RigBearing::test, k);
    out << fmt::format("{:>8.0f} {:>10} {:>8} {:>8} {:>9} {:>11} {:>9} {:>9}\n", rpm,
                       up == nullptr ? "-" : fmt::format("{:.1f}", up->T_shell_back - kZeroCelsius),
                       torque(OilModel::temperature, 0.0), torque(OilModel::pressure, 0.0),
                       torque(OilModel::full, 0.0), torque(OilModel::full, s.plan.warmer),
                       course == nullptr ? "-" : shown(course->torque(k)),
                       course == nullptr ? "-" : shown(course->torque(course->down_from(k))));
  }
  out << "\n";
}

std::string course_failure(const RigCourse& c, int k) {
  const auto& end = c.run[k].end;
  const std::size_t passed = c.run[k].ends.size();
  return fmt::format("run-up and run-down, {:.0f} kN{}, {}, at {:.0f} rpm after {:.0f} s: {}",
                     1e-3 * c.peak, changed_words(c.unknown, c.end), to_string(kRigBearings[k]),
                     passed < c.rpm.size() ? c.rpm[passed] : c.rpm.back(), end.t,
                     app::reason_of(end.verdict));
}

std::string point_failure(const RigPoint& p) {
  return fmt::format("isothermal, {:.0f} kN, {:.0f} rpm, {}{}{}: {}", 1e-3 * p.peak, p.rpm,
                     to_string(p.oil), p.warmer != 0.0 ? ", warmer" : "",
                     changed_words(p.unknown, p.end), p.reason());
}

}  // namespace

std::vector<std::string> rig_failures(const RigStudy& study) {
  std::vector<std::string> lines;
  int stopped = 0;
  const auto failed = [&](const Verdict& v) {
    if (v.status == Status::interrupted) ++stopped;
    return !v.good() && v.status != Status::interrupted;
  };
  for (const RigCourse& c : study.courses) {
    for (int k = 0; k < 2; ++k) {
      if (!c.tried[k]) ++stopped;
      if (c.tried[k] && failed(c.run[k].end.verdict)) lines.push_back(course_failure(c, k));
    }
  }
  for (const RigPoint& p : study.points) {
    const bool test = failed(p.cycle[0].verdict);
    if (failed(p.cycle[1].verdict) || test) lines.push_back(point_failure(p));
  }
  for (const RigStart& s : study.starts) {
    for (int k = 0; k < 2; ++k) {
      if (!failed(s.verdict[k])) continue;
      lines.push_back(fmt::format("start and stop, {} surface, {:.0f} degC, {}: {}",
                                  s.worn ? "worn" : "new", s.T - kZeroCelsius,
                                  to_string(kRigBearings[k]), app::reason_of(s.verdict[k])));
    }
  }
  if (stopped > 0) {
    lines.push_back(fmt::format("{} solves were stopped or not begun: interrupted", stopped));
  }
  return lines;
}

void write_rig_tables(std::ostream& out, const RigStudy& study) {
  out << fmt::format("KS rig: test bearing and two supports, grid {} x {}, substitute load\n\n",
                     study.plan.grid[0], study.plan.grid[1]);
  for (const double peak : study.plan.peaks) write_torques(out, study, peak);
  for (const RigStatement& s : rig_statements(study)) {
    out << fmt::format("{:<9}  {:<5} {}\n{:17}ours {}; asked {}\n", to_string(s.met), s.section,
                       s.words, "", s.ours, s.range);
  }
  const auto failures = rig_failures(study);
  if (!failures.empty()) out << "\nnot found\n";
  for (const std::string& line : failures) out << "  - " << line << "\n";
  out << fmt::format("\n{} threads, {:.0f} s\n", study.threads, study.wall_s);
}

}  // namespace shellback::validation
