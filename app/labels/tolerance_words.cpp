#include "app/labels/tolerance_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/reading/sweep_case.hpp"
#include "bearing/case_limits.hpp"
#include "fidelity/auto_tier.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/land_error.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app {

using bearing::Case;
using bearing::Comparison;
using bearing::Result;
using bearing::Tier;
using fidelity::kFineGrid;
using fidelity::RelativeBars;
using fidelity::Shortfall;

namespace {

constexpr const char* kGrid = "model.grid";
constexpr const char* kNodes = "model.film_nodes";
constexpr const char* kByAuto =
    "expected to meet it (physics and grid as the tolerance wants them)";

std::string percent(double part) { return figures(100.0 * part, 2) + " %"; }

constexpr double kMostAsked = bearing::kValueRanges.tolerance.high;  ///< by a case [-]

/// A tolerance that holds `part`, in two figures rounded up.
std::string tolerance_above(double part) {
  const double unit = std::pow(10.0, std::floor(std::log10(100.0 * part)) - 1.0);
  return fmt::format("{:.4g} %", unit * std::ceil(100.0 * part / unit));
}

constexpr const char* kNotLaminar = "the film is not laminar, and no tier knows another";

std::string missed_words(const Shortfall& s) {
  std::string words;
  const auto add = [&](const char* name, const RelativeBars& bars) {
    if (!(bars.total() > s.tolerance)) return;
    words += fmt::format("{}{} +-{}", words.empty() ? "" : ", ", name, percent(bars.total()));
    if (bars.model > 0.5 * bars.total()) words += " (most of it the physics left out)";
  };
  add("friction torque", s.friction);
  add("smallest film", s.h_min);
  if (!s.laminar) words += std::string(words.empty() ? "" : ", ") + kNotLaminar;
  return words;
}

std::string grid_words(const std::array<int, 2>& grid) {
  return fmt::format("[{},{}]", grid[0], grid[1]);
}

/// Whether the case has as many nodes across the film as there can be.
bool nodes_at_most(const Case& c) {
  return c.model.film_nodes + fidelity::kMoreNodes > bearing::kValueRanges.film_nodes[1];
}

/// ", in some 60 times the time": where a grid is so much finer that whoever copies the command
/// ought to know.
std::string long_words(const std::array<int, 2>& grid, const std::array<int, 2>& own) {
  constexpr double kTold = 10.0;   // times [-]
  constexpr double kGrowth = 1.2;  // of the time with the cells (docs/benchmark.md: 1.1 to 1.7) [-]
  const double cells = static_cast<double>(grid[0]) * grid[1] / (own[0] * own[1]);
  const double times = std::pow(cells, kGrowth);
  return times < kTold ? "" : fmt::format(", in some {} times the time", figures(times, 1));
}

/// The same command with the grid and the nodes proposed, or, where there are no finer ones, with a
/// tolerance that they keep. `rest`: words that the command needs besides.
void take_grid(const Case& c, const Shortfall& s, const std::string& command,
               const std::string& rest, const std::array<int, 2>& own, Missed& missed) {
  if (s.grid == own && !s.more_nodes) {
    const std::string blank = rest.empty() ? "" : rest + " ";
    const double largest = std::fmax(s.friction.total(), s.h_min.total());
    if (largest > kMostAsked) {
      missed.outlook = "no finer grid is worth its time, and no tolerance is as wide as this";
      return;
    }
    missed.outlook = "no finer grid is worth its time; the tolerance that this one keeps";
    missed.command =
        command_line(command, c, blank + set_words("model.tolerance", tolerance_above(largest)),
                     {"model.tolerance"});
    return;
  }
  const std::array<int, 2> grid =
      s.grid == own ? own : fidelity::with_lands_cut(c, s.grid, std::max(kFineGrid[1], s.grid[1]));
  missed.outlook =
      s.expected > s.tolerance
          ? fmt::format("the finest grid worth its time leaves about +-{}", percent(s.expected))
          : fmt::format("expected to meet it, if bars fall as the cells' size lets expect (+-{})",
                        percent(s.expected));
  missed.outlook += long_words(grid, own);
  std::string words = rest;
  std::vector<std::string> replaced;
  const auto put = [&](const char* key, const std::string& value) {
    words += (words.empty() ? "" : " ") + set_words(key, value);
    replaced.emplace_back(key);
  };
  if (grid != own) put(kGrid, grid_words(grid));
  if (s.more_nodes) put(kNodes, std::to_string(c.model.film_nodes + fidelity::kMoreNodes));
  missed.command = command_line(command, c, words, replaced);
}

/// Tier auto chooses physics and grid by itself.
void take_auto(const Case& c, Missed& missed) {
  missed.outlook = kByAuto;
  missed.command = command_line(
      "run", c, "--tier auto" + (c.model.grid_given ? " " + set_words(kGrid, "auto") : ""),
      {kGrid, "model.tier"});
}

Missed missed_by_auto(const Case& c, const Result& r) {
  const auto& choice = *r.choice;
  if (choice.met) return {};
  Missed missed;
  missed.words = fmt::format("friction torque +-{}, smallest film +-{}",
                             percent(choice.bar_friction), percent(choice.bar_h_min));
  if (!fidelity::is_laminar(r.warnings)) {
    missed.words += std::string("; ") + kNotLaminar;
    return missed;
  }
  if (c.model.grid_given) {
    missed.outlook = "its grid is given; with a grid of its own choice";
    missed.command = command_line("run", c, set_words(kGrid, "auto"), {kGrid});
    return missed;
  }
  const double by_grid = std::fmax(fidelity::relative_bars(r, "friction_torque").grid,
                                   fidelity::relative_bars(r, "h_min").grid);
  if (by_grid > c.model.tolerance && c.model.tolerance >= fidelity::kFineTolerance) {
    missed.outlook =
        "below a tolerance of 0.5 % it goes on to 800 x 100 cells, at some seconds' cost";
    missed.command =
        command_line("run", c, set_words("model.tolerance", "0.4 %"), {"model.tolerance"});
    return missed;
  }
  const double largest = std::fmax(choice.bar_friction, choice.bar_h_min);
  if (!(largest <= kMostAsked)) return missed;
  missed.outlook = "what was reached";
  missed.command = command_line("run", c, set_words("model.tolerance", tolerance_above(largest)),
                                {"model.tolerance"});
  return missed;
}

/// A point of the sweep whose bars are the widest.
struct Widest {
  const study::SweepPoint* point = nullptr;
  Shortfall missed;
  int index = 0;
  int count = 0;  ///< points that miss their tolerance
};

double width(const Shortfall& s) { return std::fmax(s.friction.total(), s.h_min.total()); }

bool varied(const study::Sweep& sweep, const char* key) {
  return std::any_of(sweep.axes.begin(), sweep.axes.end(),
                     [&](const study::Axis& axis) { return axis.key == key; });
}

Widest widest(const study::Sweep& sweep, const Case& subject) {
  const bool nodes_stay = nodes_at_most(subject) || varied(sweep, kNodes) || varied(sweep, kGrid);
  Widest out;
  for (const int index : reading_order(sweep)) {
    const study::SweepPoint& point = sweep.points[index];
    if (!point.good()) continue;
    const Shortfall s = fidelity::shortfall(point.result, subject.model.tolerance, nodes_stay);
    if (s.met) continue;
    ++out.count;
    if (out.point != nullptr && width(s) <= width(out.missed)) continue;
    out.point = &point;
    out.missed = s;
    out.index = index;
  }
  return out;
}

/// --vary for all axes; a varied grid gets the one proposed as well.
std::string all_axes(const study::Sweep& sweep, const std::array<int, 2>& grid) {
  std::string words;
  for (study::Axis axis : sweep.axes) {
    const auto& known = axis.words;
    const bool there = std::find(known.begin(), known.end(), grid_words(grid)) != known.end();
    if (axis.key == kGrid && !there) axis.words.push_back(grid_words(grid));
    words += (words.empty() ? "" : " ") + vary_words(axis);
  }
  return words;
}

/// The same sweep in tier auto; none where tier or grid are what is varied.
void sweep_by_auto(const Case& subject, const study::Sweep& sweep, Missed& missed) {
  if (varied(sweep, kGrid) || varied(sweep, "model.tier")) return;
  missed.outlook = kByAuto;
  missed.command = command_line(
      "sweep", subject, all_axes(sweep, {0, 0}) + " --tier auto " + set_words(kGrid, "auto"),
      {kGrid, "model.tier"});
}

}  // namespace

Missed missed_tolerance(const Case& c, const Result& result) {
  if (!result.verdict.good()) return {};
  if (result.choice) return missed_by_auto(c, result);
  const Shortfall s = fidelity::shortfall(result, c.model.tolerance, nodes_at_most(c));
  if (s.met) return {};
  Missed missed;
  missed.words = missed_words(s);
  if (s.physics) {
    if (s.laminar) take_auto(c, missed);
  } else {
    take_grid(c, s, "run", "", result.grid, missed);
  }
  return missed;
}

Missed missed_tolerance(const Case& c, const Comparison& comparison) {
  if (comparison.results.size() == 1) return missed_tolerance(c, comparison.results.front());
  const auto names = column_names(comparison.results);
  Missed missed;
  std::string tiers;
  std::string by_physics;  // those that no grid can mend
  Shortfall worst;         // of those that one can
  bool more_nodes = false, laminar = true;
  const Result* mended = nullptr;
  const Result* within = nullptr;  // the richest that is as good as asked for
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Result& r = comparison.results[k];
    tiers += (k == 0 ? "" : ",") + std::string(to_string(r.tier));
    const Shortfall s = fidelity::shortfall(r, c.model.tolerance, nodes_at_most(c));
    if (r.verdict.good() && s.met && std::isfinite(s.friction.total())) within = &r;
    laminar = laminar && s.laminar;
    if (!r.verdict.good() || s.met) continue;
    missed.words += (missed.words.empty() ? "" : "; ") + names[k] + ": " + missed_words(s);
    if (s.physics && s.laminar) by_physics += (by_physics.empty() ? "" : ", ") + names[k];
    if (s.physics) continue;
    more_nodes = more_nodes || s.more_nodes;
    if (mended != nullptr && s.grid[0] <= worst.grid[0]) continue;
    worst = s;
    mended = &r;
  }
  if (!missed) return missed;
  if (mended != nullptr) {
    worst.more_nodes = more_nodes;
    take_grid(c, worst, "compare", "--tiers " + tiers, mended->grid, missed);
    if (!by_physics.empty()) missed.outlook += fmt::format(", but for {} (physics)", by_physics);
  } else if (within != nullptr) {
    const std::string tier = to_string(within->tier);
    missed.outlook = tier + " meets it";
    missed.command = command_line("run", c, "--tier " + tier, {"model.tier"});
  } else if (laminar) {
    take_auto(c, missed);
  }
  return missed;
}

Missed missed_tolerance(const Case& subject, const study::Sweep& sweep) {
  const Widest w = widest(sweep, subject);
  if (w.point == nullptr) return {};
  const std::vector<int> at = indices_of(sweep, w.index);
  Missed missed;
  missed.words = fmt::format(
      "{} of {} points, the widest bars at {}: {}", w.count, sweep.count_good(),
      position_words(sweep.axes, {static_cast<double>(at.front()), {at.begin() + 1, at.end()}}),
      missed_words(w.missed));
  if (w.missed.physics || w.point->result.choice) {
    if (w.missed.laminar && !w.point->result.choice) sweep_by_auto(subject, sweep, missed);
    return missed;
  }
  const std::string axes = all_axes(sweep, w.missed.grid);
  take_grid(subject, w.missed, "sweep", axes, w.point->result.grid, missed);
  if (varied(sweep, kGrid)) missed.command = command_line("sweep", subject, axes, {});
  return missed;
}

std::vector<std::string> tolerance_lines(const Case& c, const Missed& missed) {
  if (!missed) return {};
  std::vector<std::string> lines{fmt::format("model.tolerance ({:.3g} %) is not met: {}",
                                             100.0 * c.model.tolerance, missed.words)};
  if (!missed.command.empty()) {
    lines.push_back("  " + missed.outlook + ":");
    lines.push_back("  " + missed.command);
  }
  return lines;
}

std::string undetermined_words(const Result& result) {
  constexpr double kCounts = 0.01;  // of the whole torque: what summits take of it is worth a word
  if (result.tier == bearing::Tier::estimate) return "";
  const bearing::Quantity* torque = bearing::quantity_in(result.quantities, "friction_torque");
  const bearing::Quantity* p_max = bearing::quantity_in(result.quantities, "p_max");
  std::string words;
  for (const bearing::Quantity& q : result.quantities) {
    const bool positive = (q.unit == "Pa" || q.name == "h_min") && q.value > 0.0;
    const bool rubs = q.name == "friction_torque_asperity" && torque != nullptr &&
                      q.error() > kCounts * torque->size();
    const double size = std::abs(q.value);
    if (!(positive || (rubs && size > 0.0)) || !(q.error() > size)) continue;
    const bool unseen = q.name == "p_asperity_max" && p_max != nullptr &&
                        q.error() < kCounts * std::abs(p_max->value);
    if (unseen) continue;  // summits that carry nothing, whatever the grid
    const std::string label = rubs ? "torque of asperities" : quantity_label(q.name);
    words += fmt::format("{}{} (bars of {} times the value)", words.empty() ? "" : ", ", label,
                         figures(q.error() / size, 2));
  }
  return words.empty() ? "" : "not determined by these grids: " + words;
}

}  // namespace shellback::app
