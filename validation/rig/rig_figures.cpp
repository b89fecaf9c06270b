#include "validation/rig/rig_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/html_page.hpp"
#include "app/pictures/svg_lines.hpp"
#include "core/constants.hpp"
#include "validation/rig/rig_bands.hpp"

namespace shellback::validation {
namespace {

using app::Box;
using app::Frame;
using app::LinePlot;
using app::Point;
using app::Series;
using app::Svg;
using app::Theme;

constexpr double kWidth = 560.0;   ///< [px]
constexpr double kHeight = 360.0;  ///< [px]
constexpr double kMargin = 14.0;   ///< right of the box, for half a label [px]
constexpr double kMega = 1e-6;
constexpr double kMinute = 60.0;  ///< [s]

const std::string& colour_of(const RigStudy& study, double peak, const Theme& theme) {
  return theme.series[peak == study.plan.peaks.back() ? 3 : 0];
}

std::string load_words(double peak) { return fmt::format("{:.0f} kN", 1e-3 * peak); }

LinePlot over_speed(const RigStudy& study, const std::string& title, const std::string& y_title) {
  LinePlot plot;
  plot.title = title;
  plot.x = app::round_axis(0.0, study.plan.rpm.back(), 8, "speed [rpm]");
  plot.y_title = y_title;
  return plot;
}

/// A circle on each value, a cross on the axis where there is none.
void draw_marks(Svg& svg, const Frame& frame, const std::vector<Series>& series,
                const Theme& theme) {
  for (const Series& s : series) {
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      if (std::isfinite(s.y[k])) {
        svg.circle(frame.at(s.x[k], s.y[k]), 2.6, s.colour, {s.colour, 1.0});
        continue;
      }
      const Point at = frame.at(s.x[k], frame.y.low);
      svg.line({at.x - 4.0, at.y - 10.0}, {at.x + 4.0, at.y - 2.0}, {theme.more, 1.8});
      svg.line({at.x - 4.0, at.y - 2.0}, {at.x + 4.0, at.y - 10.0}, {theme.more, 1.8});
    }
  }
}

void draw_bands(Svg& svg, const Frame& frame, const RigStudy& study, const Theme& theme) {
  svg.begin_clip(frame.box);
  for (const double peak : study.plan.peaks) {
    std::vector<Point> outline;
    std::vector<Point> back;
    for (const RigBand& band : rig_bands(study, peak)) {
      if (!std::isfinite(band.low)) continue;
      outline.push_back(frame.at(band.rpm, band.high));
      back.push_back(frame.at(band.rpm, band.low));
    }
    outline.insert(outline.end(), back.rbegin(), back.rend());
    if (outline.size() > 2) {
      svg.shade(app::line_path(outline) + "Z", colour_of(study, peak, theme), 0.14);
    }
  }
  svg.end_clip();
}

double highest_torque(const RigStudy& study) {
  double most = 0.0;
  const auto take = [&](double v) {
    if (std::isfinite(v)) most = std::max(most, v);
  };
  for (const RigPoint& p : study.points) take(p.torque());
  for (const RigCourse& c : study.courses) {
    for (std::size_t k = 0; k < c.rpm.size(); ++k) take(c.torque(k));
  }
  return most;
}

std::string oil_figure(const RigStudy& study, OilModel oil, int number) {
  const Theme theme = app::page_theme();
  LinePlot plot = over_speed(study, fmt::format("Isothermal, {}", to_string(oil)),
                             "friction torque of the rig [N m]");
  plot.y = app::round_axis(0.0, highest_torque(study), 6, plot.y_title);
  const bool full = oil == OilModel::full;
  for (const double peak : study.plan.peaks) {
    Series at{load_words(peak), {}, {}, colour_of(study, peak, theme), ""};
    Series warm{
        full ? fmt::format("{:.0f} K warmer", study.plan.warmer) : "", {}, {}, at.colour, "5 4"};
    for (const double rpm : study.plan.rpm) {
      const RigPoint* p = study.point(peak, rpm, oil);
      const RigPoint* w = study.point(peak, rpm, oil, study.plan.warmer);
      at.x.push_back(rpm);
      at.y.push_back(p == nullptr ? NAN : p->torque());
      warm.x.push_back(rpm);
      warm.y.push_back(w == nullptr ? NAN : w->torque());
    }
    plot.series.push_back(at);
    if (full) plot.series.push_back(warm);
  }
  Svg svg(kWidth, kHeight);
  const Frame frame = draw_lines(svg, {0.0, 0.0, kWidth - kMargin, kHeight}, plot, theme);
  if (full && study.plan.bands) draw_bands(svg, frame, study, theme);
  std::erase_if(plot.series, [](const Series& s) { return !s.dash.empty(); });
  draw_marks(svg, frame, plot.series, theme);
  std::string more =
      full ? " Dashed: films 3 K warmer, as the paper measured in the run-down." : "";
  if (full && study.plan.bands) more += " Shaded: unknown inputs, each alone.";
  return app::figure_html(
      svg, plot.title,
      fmt::format("After Figure {} of the paper. Films at the temperature of the "
                  "shell's back in our run-up.{}",
                  number, more));
}

std::string solved_figure(const RigStudy& study) {
  const Theme theme = app::page_theme();
  LinePlot plot =
      over_speed(study, "Temperature solved (ours)", "friction torque of the rig [N m]");
  plot.y = app::round_axis(0.0, highest_torque(study), 6, plot.y_title);
  for (const double peak : study.plan.peaks) {
    const RigCourse* course = study.course(peak);
    Series up{load_words(peak) + " up", {}, {}, colour_of(study, peak, theme), ""};
    Series down{"down", {}, {}, up.colour, "5 4"};
    for (std::size_t k = 0; k < course->rpm.size(); ++k) {
      for (Series* series : {&up, &down}) {
        if (series == &up ? k > course->highest() : k < course->highest()) continue;
        series->x.push_back(course->rpm[k]);
        series->y.push_back(course->torque(k));
      }
    }
    plot.series.push_back(up);
    plot.series.push_back(down);
  }
  for (const RigCourse& c : study.courses) {
    if (c.unknown == nullptr || c.has_run_down()) continue;
    Series ends{"", {}, {}, theme.muted, "1 4"};
    for (std::size_t k = 0; k < c.rpm.size(); ++k) {
      ends.x.push_back(c.rpm[k]);
      ends.y.push_back(c.torque(k));
    }
    plot.series.push_back(ends);
  }
  Svg svg(kWidth, kHeight);
  const Frame frame = draw_lines(svg, {0.0, 0.0, kWidth - kMargin, kHeight}, plot, theme);
  std::erase_if(plot.series, [](const Series& s) { return s.dash == "1 4"; });
  draw_marks(svg, frame, plot.series, theme);
  const char* bands = study.plan.bands ? "Dotted: 80 kN with supply temperature and cooling at the "
                                         "ends of their ranges. "
                                       : "";
  return app::figure_html(
      svg, plot.title,
      fmt::format("No counterpart in the paper. Film, shells, housings and shaft solved; at the "
                  "end of each step of 20 minutes. {}Crosses: {}, see below.",
                  bands, study.interrupted ? "not known" : "not found"));
}

/// A quantity of both bearings over time.
std::string time_figure(const RigStudy& study, const RigCourse& course, const std::string& title,
                        const std::string& unit, double bearing::Instant::*value, double zero) {
  const Theme theme = app::page_theme();
  LinePlot plot;
  plot.title = title;
  plot.y_title = unit;
  plot.from_zero = false;
  double end = 0.0;
  for (const RigBearing b : kRigBearings) {
    const int k = b == RigBearing::test ? 0 : 1;
    Series s{to_string(b), {}, {}, theme.series[k == 0 ? 3 : 0], ""};
    for (const bearing::Instant& i : course.run[k].instants) {
      s.x.push_back(i.t / kMinute);
      s.y.push_back(i.*value - zero);
      end = std::max(end, s.x.back());
    }
    plot.series.push_back(s);
  }
  plot.x = app::round_axis(0.0, std::max(end, 1.0), 8, "time [min]");
  Svg svg(kWidth, kHeight);
  draw_lines(svg, {0.0, 0.0, kWidth - kMargin, kHeight}, plot, theme);
  return app::figure_html(
      svg, title,
      fmt::format("{}, {:.0f} minutes a step, bodies from the supply's temperature.",
                  load_words(course.peak), study.plan.hold / kMinute));
}

/// Run-down less run-up over speed, as taken and with heavier bodies.
std::string hysteresis_figure(const RigStudy& study) {
  const Theme theme = app::page_theme();
  LinePlot plot = over_speed(study, "Run-down less run-up, back of the test bearing's shell",
                             "temperature [K]");
  int colour = 0;
  for (const RigCourse& c : study.courses) {
    if (!c.has_run_down()) continue;
    Series s{load_words(c.peak) + (c.unknown != nullptr ? ", ten times the heat capacity" : ""),
             {},
             {},
             theme.series[static_cast<std::size_t>(colour++)],
             ""};
    for (std::size_t k = 0; k < c.highest(); ++k) {
      const bearing::Instant* up = c.at(RigBearing::test, k);
      const bearing::Instant* down = c.at(RigBearing::test, c.down_from(k));
      s.x.push_back(c.rpm[k]);
      s.y.push_back(up == nullptr || down == nullptr ? NAN : down->T_shell_back - up->T_shell_back);
    }
    plot.series.push_back(s);
  }
  plot.y = app::round_axis(-1.0, 4.0, 5, plot.y_title);
  plot.series.push_back({"paper: 3 K",
                         {study.plan.rpm.front(), study.plan.rpm.back()},
                         {3.0, 3.0},
                         theme.muted,
                         "5 4"});
  Svg svg(kWidth, kHeight);
  const Frame frame = draw_lines(svg, {0.0, 0.0, kWidth - kMargin, kHeight}, plot, theme);
  plot.series.pop_back();
  draw_marks(svg, frame, plot.series, theme);
  return app::figure_html(
      svg, plot.title,
      "The bodies of the cases are rings round each shell; rod, brackets, base and the "
      "oil's tank are heavier and not published.");
}

std::string film_figure(const RigStudy& study, const std::string& title, const std::string& unit,
                        double RigCycle::*value, double factor, double reference,
                        const std::string& words) {
  const Theme theme = app::page_theme();
  LinePlot plot = over_speed(study, title, unit);
  for (const double peak : study.plan.peaks) {
    Series s{load_words(peak), {}, {}, colour_of(study, peak, theme), ""};
    for (const double rpm : study.plan.rpm) {
      const RigPoint* p = study.point(peak, rpm, OilModel::full);
      s.x.push_back(rpm);
      s.y.push_back(p == nullptr || !p->cycle[0].verdict.good() ? NAN
                                                                : factor * (p->cycle[0].*value));
    }
    plot.series.push_back(s);
  }
  Series paper{
      "paper", {study.plan.rpm.back() - 200.0, study.plan.rpm.back()}, {}, theme.muted, "5 4"};
  if (value == &RigCycle::p_max) paper.x.front() = study.plan.rpm.front();
  paper.y = {reference, reference};
  plot.series.push_back(paper);
  double high = reference;
  for (const Series& one : plot.series) {
    for (const double y : one.y) high = std::isfinite(y) ? std::max(high, y) : high;
  }
  plot.y = app::round_axis(0.0, 1.1 * high, 6, unit);
  Svg svg(kWidth, kHeight);
  const Frame frame = draw_lines(svg, {0.0, 0.0, kWidth - kMargin, kHeight}, plot, theme);
  plot.series.pop_back();
  draw_marks(svg, frame, plot.series, theme);
  return app::figure_html(svg, title, words);
}

}  // namespace

std::string torque_figures(const RigStudy& study) {
  return oil_figure(study, OilModel::temperature, 5) + oil_figure(study, OilModel::pressure, 6) +
         oil_figure(study, OilModel::full, 7) + solved_figure(study);
}

std::string course_figures(const RigStudy& study) {
  const RigCourse* course = study.course(study.plan.peaks.back());
  return time_figure(study, *course, "Back of the shell over time", "temperature [°C]",
                     &bearing::Instant::T_shell_back, kZeroCelsius) +
         time_figure(study, *course, "Torque of each bearing over time", "torque [N m]",
                     &bearing::Instant::torque, 0.0) +
         hysteresis_figure(study);
}

std::string film_figures(const RigStudy& study) {
  constexpr double kPaperShear = 22.0;  // 2.2e7 1/s at 7000 rpm
  constexpr double kPaperPeak = 200.0;  // [MPa], 80 kN
  return film_figure(study, "Largest film pressure, test bearing", "[MPa]", &RigCycle::p_max, kMega,
                     kPaperPeak, "The paper: around 200 MPa at 80 kN at every speed.") +
         film_figure(study, "Largest shear rate at mid-width, test bearing", "[1e6 1/s]",
                     &RigCycle::shear, kMega, kPaperShear,
                     "The paper: 2.2e7 1/s at 7000 rpm, ten times less at 1000 rpm.");
}

std::string start_figures(const RigStudy& study) {
  const Theme theme = app::page_theme();
  LinePlot plot;
  plot.title = "Start and stop under 2.5 kN";
  plot.y_title = "friction torque of the rig [N m]";
  double end = 1.0;
  Series speed{"speed, 0 to 260 rpm", {}, {}, theme.muted, "5 4"};
  for (const RigStart& start : study.starts) {
    if (start.T != study.plan.start_films.front()) continue;
    Series s{
        start.worn ? "worn surface" : "new surface", {}, {}, theme.series[start.worn ? 2 : 3], ""};
    for (const RigInstant& i : start.series) {
      s.x.push_back(i.t);
      s.y.push_back(i.t > 0.0 || start.breakaway == 0.0 ? i.torque : 0.0);
      end = std::max(end, i.t);
      if (!start.worn) {
        speed.x.push_back(i.t);
        speed.y.push_back(i.omega * 30.0 / kPi / 100.0);
      }
    }
    plot.series.push_back(s);
  }
  plot.series.push_back(speed);
  plot.x = app::round_axis(0.0, end, 8, "time [s]");
  Svg svg(1.5 * kWidth, kHeight);
  const Frame frame = draw_lines(svg, {0.0, 0.0, 1.5 * kWidth - kMargin, kHeight}, plot, theme);
  for (const double t : {1.5, 2.0}) {
    svg.line(frame.at(t, frame.y.low), frame.at(t, frame.y.high), {theme.muted, 0.9, "2 3"});
  }
  return app::figure_html(
      svg, plot.title,
      "After Figure 15 of the paper. Dotted: published times of full film, 1.5 s (worn) "
      "and 2.0 s (new). Speed in hundreds of rpm.");
}

}  // namespace shellback::validation
