#include "bearing/over_time/worn_in_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fixed_point.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

// Towards (3), before a lost acceleration doubled the delay (since then some 130 and 370 shapes at
// 60 and 80 kN, and rigid bearings half in contact are found): shapes tried for the KS bearing worn
// in at 5 MPa under 40, 60, 80 kN are 34, 139, 325 with 15 vectors, 34, 170, 553 with 8; at 80 kN
// 278 with 30, and 403 at 1 MPa. A delay of 1 takes 338, of 0 or 10 meets a shape without a film.
// Out of any reach so do 100 kN, and 20 and 80 kN at 3000 rpm on 60 x 13 cells (2 MPa); within 3
// the latter two take 17 and 235, within 10 not.
constexpr int kEndDepth = 15;         ///< shapes kept by the acceleration [-]
constexpr int kEndDelay = 2;          ///< plain shapes before it [-]
constexpr int kEndIterations = 1000;  ///< three times what 80 kN needs

/// Wear at which every cell's contact pressure would be `limit` if the film stayed as it is.
Field asked_for(const WornBearing& b, const Field& w, double limit) {
  const BearingModel& m = b.model();
  const double open = m.contact->gap_of(limit);
  Field to = w;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double p = b.contact()[k];
    if (m.supply.cell[k] >= 0) continue;
    const double h = p > 0.0 ? m.contact->gap_of(p) : b.gap()[k];
    to[k] = std::max(0.0, w[k] + open - h);
  }
  return to;
}

/// Wears the shell to `next`: at once, or, where that shape has no film from the last one's, on the
/// straight way to it in steps half as long, down to a sixteenth. False: why not.
bool wear_on(WornBearing& b, const Field& next, double within, Verdict& why) {
  constexpr double kShortestPart = 1.0 / 16.0;
  const Field from = b.wear();
  double done = 0.0;
  for (double part = 1.0; done < 1.0;) {
    Field to = next;
    const double left = 1.0 - (done + part);
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += left * (from[k] - next[k]);
    if (b.wear_to(to, within, why)) {
      done += part;
      part = std::min(2.0 * part, 1.0 - done);
    } else if (part *= 0.5; part < kShortestPart || why.status == Status::interrupted) {
      return false;
    }
  }
  return true;
}

/// Why there is no shape of (3): the map ended by `why`, or (3) is still `lack` away [m].
Verdict not_worn_in(FixedPointEnd end, const Verdict& why, double lack) {
  if (why.status == Status::interrupted) return why;
  const ending::Unsettled unsettled{ending::Iteration::wear, 0, lack};
  if (end != FixedPointEnd::map_failed) return {Status::iteration_limit, unsettled};
  return {Status::iteration_limit, unsettled, why.place, {why}};
}

/// What the iteration for (3) was told, to be led through it once more.
struct ShapesTried {
  double unit = 0.0;         ///< summit roughness of the new surfaces [m]
  std::vector<Field> asked;  ///< for every shape tried [m]
};

}  // namespace

void find_worn_in(WornBearing& b, const SolveControl& control, double limit, RunningInRun& run) {
  ShapesTried tried{b.model().contact->sigma(), {}};
  take_up(control.kept, tried);
  const double unit = tried.unit;
  Verdict why;
  std::size_t given = 0;
  double lack = std::numeric_limits<double>::infinity();  // of the last shape [m]
  const auto map = [&](const std::vector<double>& x, std::vector<double>& g) {
    Field next = x;
    for (double& v : next) v = std::max(0.0, v * unit);
    if (given == tried.asked.size()) {
      if (stopped(control)) {
        why = {Status::interrupted};
        return false;
      }
      // heat no rougher than what the last shape lacked: noise is not accelerated
      if (!wear_on(b, next, lack, why)) return false;
      tried.asked.push_back(asked_for(b, next, limit));
      const double off = largest_difference(tried.asked.back(), next) / unit;
      const int shapes = static_cast<int>(tried.asked.size());
      if (control.progress) control.progress({"shape", shapes, off, NAN, NAN});
      keep(control.kept, false, b, run, tried);
    }
    g = tried.asked[given++];
    lack = largest_difference(g, next);
    for (double& v : g) v /= unit;
    return true;
  };
  std::vector<double> x(b.model().domain.grid.cells(), 0.0);
  FixedPointOptions options;
  options.depth = kEndDepth;
  options.delay = kEndDelay;
  options.max_iterations = kEndIterations;
  options.tolerance = kComplementarity;
  options.reach = kSummits;
  const FixedPointEnd end = fixed_point(map, options, x);
  double away = NAN;  // of the last shape that was found [m]
  if (end != FixedPointEnd::map_failed) {
    note_state(b, std::numeric_limits<double>::infinity(), 0.0, {}, b.wear(), run);
    away = largest_difference(asked_for(b, b.wear(), limit), b.wear());
    run.complementarity = away / unit;
  }
  if (why.status == Status::interrupted) {
    keep(control.kept, true, b, run, tried);
    if (!tried.asked.empty()) {  // told, not kept: the shape tried last
      note_state(b, std::numeric_limits<double>::infinity(), 0.0, {}, b.wear(), run);
    }
  }
  if (end != FixedPointEnd::converged) run.verdict = not_worn_in(end, why, away);
}

}  // namespace shellback::bearing
