#include "app/reading/surface_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace surface;

/// Part of the map that may be filled: what is filled has neither summits nor roughness, so that
/// Rq^2 loses as large a part [-].
constexpr double kMostHoles = 0.1;
constexpr double kFewPitches = 4.0;       ///< to a correlation length: below, the pitch is seen [-]
constexpr std::size_t kFewSummits = 100;  ///< their roughness is known to 7 % with so many
constexpr double kAligned = 10.0 * kPi / 180.0;  ///< lay off the axes: gamma is off by few % [rad]
/// Rq over the largest height: less is what double precision leaves of a form [-].
constexpr double kNothingLeft = 1e-12;
constexpr double kSteepest = 1.0;  ///< rms slope: 45 degrees, which no instrument of heights sees
constexpr double kSteep = 0.3;     ///< rms slope: thin films' equation errs by its square, 9 %
constexpr double kEndless = 0.99;  ///< R over half the patch: turned grooves, not an honed lay [-]
/// A point out of its neighbours by as many Rq is of the instrument: beside the highest of a
/// million Gaussian heights (4.9) stand others.
constexpr double kSpike = 6.0;
/// Pitch over pitch: a scan's lines may stand apart, but most maps have one pitch, and a map that
/// was cut keeps the size in its header [-].
constexpr double kOblong = 1.01;

/// Where a point stands in the file; of a matrix from its lower left corner.
std::string place_words(const HeightMap& map, int i, int j) {
  const auto [x, y] = map.place(i, j);
  return fmt::format("x = {:.4g} um, y = {:.4g} um", 1e6 * x, 1e6 * y);
}

void judge_holes(const HeightMap& map, const Holes& holes, const SurfaceOptions& options) {
  if (holes.count == 0) return;
  const double share = holes.share(map);
  const std::string what =
      fmt::format("{} of {} heights ({:.3g} %) were not measured, the first at {}", holes.count,
                  map.z.size(), 100.0 * share, place_words(map, holes.i, holes.j));
  if (share > kMostHoles) {
    throw InputError(options.path,
                     fmt::format("{}: more than the {:.0f} % that may be filled; measure again, or "
                                 "export a part of the map with fewer holes",
                                 what, 100.0 * kMostHoles));
  }
  if (options.fill) return;
  throw InputError(options.path,
                   fmt::format("{}; give --fill laplace to fill them by harmonic interpolation, or "
                               "a map without holes",
                               what));
}

std::string length_words(const CorrelationLength& l) {
  return fmt::format("{}{:.3g} um", l.at_least ? "at least " : "", 1e6 * l.length);
}

/// Form alone is no roughness: what is left of it is round-off.
void judge_roughness(const HeightMap& measured, const SurfaceReport& r) {
  double highest = 0.0;
  for (const double z : measured.z) {
    if (std::isfinite(z)) highest = std::max(highest, std::abs(z));
  }
  double squares = 0.0;
  for (const double z : r.map.z) squares += z * z / static_cast<double>(r.map.z.size());
  if (std::sqrt(squares) > kNothingLeft * highest) return;
  throw InputError(r.options.path,
                   fmt::format("the heights are nothing but a form of degree {}: no roughness is "
                               "left; check that the file holds measured heights, or remove less "
                               "form (--form)",
                               r.form.degree));
}

/// Of the gradient [-].
double rms_slope(const SpectralMoments& m) { return std::sqrt(m.m2x + m.m2y); }

/// How far a point lies above the highest, or below the lowest, of its eight neighbours [m]; 0
/// between them.
double out_of_neighbours(const surface::HeightMap& map, int i, int j) {
  double low = INFINITY, high = -INFINITY;
  for (int b = -1; b <= 1; ++b) {
    for (int a = -1; a <= 1; ++a) {
      if (a == 0 && b == 0) continue;
      low = std::min(low, map.at(i + a, j + b));
      high = std::max(high, map.at(i + a, j + b));
    }
  }
  const double z = map.at(i, j);
  return std::max(z - high, 0.0) + std::min(z - low, 0.0);
}

/// Single points that stand out of all their neighbours, each of which is a summit and counts in
/// Rq; empty if there are none.
std::string spike_words(const SurfaceReport& r) {
  const surface::HeightMap& map = r.map;
  std::size_t count = 0;
  double most = 0.0;
  int at_i = 0, at_j = 0;
  for (int j = 1; j + 1 < map.ny; ++j) {
    for (int i = 1; i + 1 < map.nx; ++i) {
      const double out = out_of_neighbours(map, i, j) / r.heights.Rq;
      if (std::abs(out) < kSpike) continue;
      ++count;
      if (std::abs(out) <= std::abs(most)) continue;
      most = out;
      at_i = i;
      at_j = j;
    }
  }
  if (count == 0) return "";
  return fmt::format(
      "{} by more than {:g} Rq, the farthest by {:.3g} um at {}: if the "
      "instrument made {}, empty the field and fill it (--fill laplace); Rq, summits and contact "
      "have {} in them",
      count == 1 ? "a point stands out of all its neighbours"
                 : fmt::format("{} points stand out of all their neighbours", count),
      kSpike, 1e6 * most * r.heights.Rq, place_words(map, at_i, at_j), count == 1 ? "it" : "them",
      count == 1 ? "it" : "them");
}

void judge_slopes(const SurfaceReport& r) {
  const double slope = rms_slope(r.moments);
  if (slope <= kSteepest) return;
  const std::string spikes = spike_words(r);
  throw InputError(
      r.options.path,
      fmt::format("the surface is steeper than any that can be measured or lubricated: slopes of "
                  "{:.3g} (root mean square; 1 is 45 degrees) over pitches of {:.3g} and {:.3g} um "
                  "with Rq = {:.3g} um; {}",
                  slope, 1e6 * r.map.dx, 1e6 * r.map.dy, 1e6 * r.heights.Rq,
                  spikes.empty() ? "check the units of heights and sizes" : spikes));
}

/// The patch's side that lies rather across the lay [m].
double across_lay(const SurfaceReport& r) {
  return std::abs(r.correlation.lay) > 0.25 * kPi ? r.map.length() : r.map.width();
}

/// Says how large the patch would have to be.
void judge_size(const SurfaceReport& r) {
  const Correlation& c = r.correlation;
  const double kurtosis = r.heights.kurtosis;
  const double error = c.error_of_Rq(kurtosis), allowed = r.options.error;
  const bool unknown = c.longest.at_least && c.shortest.at_least;
  if (error <= allowed && !unknown) return;
  constexpr double kGaussian = 3.0;  // Rku: with it alone, is the patch large enough?
  const std::string spikes = spike_words(r);
  if (!spikes.empty() && !unknown && c.error_of_Rq(kGaussian) <= allowed) {
    throw InputError(r.options.path,
                     fmt::format("Rq has a standard error of {:.0f} %, and {:.3g} % is allowed; {}",
                                 100.0 * error, 100.0 * allowed, spikes));
  }
  if (c.longest.at_least && c.longest.R > kEndless) {
    throw InputError(
        r.options.path,
        fmt::format("the lay has no end: over half the patch along it ({}) heights stay the same, "
                    "so that only the width across it counts ({}; correlated over {}) and Rq has a "
                    "standard error of {:.0f} %, where {:.3g} % is allowed; measure a wider patch, "
                    "or allow more (--error)",
                    length_words(c.longest), fmt::format("{:.4g} um", 1e6 * across_lay(r)),
                    length_words(c.shortest), 100.0 * error, 100.0 * allowed));
  }
  const double sides = lengths_for(independent_areas_for(allowed, kurtosis));
  throw InputError(
      r.options.path,
      fmt::format("the patch of {:.4g} x {:.4g} um is too small for statistics: heights are "
                  "correlated over {} (along the lay) and {} (across it), so that Rq has a "
                  "standard error of {:.0f} %, and {:.3g} % is allowed; measure {:.1f} correlation "
                  "lengths each way, {:.3g} um along the lay and {:.3g} um across{}, or allow "
                  "more (--error); more form (--form) takes waviness away, but roughness with it",
                  1e6 * r.map.length(), 1e6 * r.map.width(), length_words(c.longest),
                  length_words(c.shortest), 100.0 * error, 100.0 * allowed, sides,
                  1e6 * sides * c.longest.length, 1e6 * sides * c.shortest.length,
                  c.longest.at_least ? " or more" : ""));
}

void note_lay(SurfaceReport& r) {
  const Correlation& c = r.correlation;
  if (c.bounded()) {
    r.notes.push_back(
        fmt::format("heights stay correlated {} over more than half the patch: gamma is {} {:.3g}",
                    c.along.at_least ? "along the motion" : "across the motion",
                    c.along.at_least ? "at least" : "at most", c.gamma));
  }
  const double off = std::min(std::abs(c.lay), 0.5 * kPi - std::abs(c.lay));
  if (has_lay(c) && off > kAligned) {
    r.notes.push_back(
        fmt::format("the lay runs at {:.0f} deg to the motion: gamma and the moments are those of "
                    "the two axes, and the cross flow that such a lay drives is left out",
                    c.lay * 180.0 / kPi));
  }
}

/// Finest wave along the shortest correlation, as a pitch: a grid of dx, dy resolves a wave at an
/// angle if it resolves both of its parts.
double pitch_across_lay(const SurfaceReport& r) {
  return std::max(r.map.dx * std::abs(std::sin(r.correlation.lay)),
                  r.map.dy * std::abs(std::cos(r.correlation.lay)));
}

void note_grid(SurfaceReport& r) {
  const double pitches = r.correlation.shortest.length / pitch_across_lay(r);
  if (pitches < kFewPitches) {
    r.notes.push_back(fmt::format(
        "the shorter correlation length is {:.2g} pitches: summits and the factors of small gaps "
        "depend on the map's pitch",
        pitches));
  }
  const double ratio = r.map.dx / r.map.dy;
  if (ratio > kOblong || ratio * kOblong < 1.0) {
    r.notes.push_back(
        fmt::format("the pitch is {:.4g} um along the motion and {:.4g} um across it: check that "
                    "both sizes are meant and that no rows are missing",
                    1e6 * r.map.dx, 1e6 * r.map.dy));
  }
  const double slope = rms_slope(r.moments);
  if (slope > kSteep) {
    r.notes.push_back(
        fmt::format("slopes of {:.2g} (root mean square) are steep: the thin-film equation errs by "
                    "about {:.0f} %; check the units of heights and sizes",
                    slope, 100.0 * slope * slope));
  }
}

void note_summits(SurfaceReport& r) {
  if (r.summits == 0) {
    r.notes.push_back(
        "no summit was counted (a point higher than its eight neighbours): contact pressures are "
        "not known; grooves without end have none, noise and a finer pitch make some");
    return;
  }
  if (!scattered(r.counted, r.heights.Rq)) {
    r.notes.push_back(fmt::format(
        "{}: Greenwood-Tripp's formula, its factor K and its r_c, which "
        "are of summits that scatter, are not given; the sums over summits are",
        r.summits == 1 ? "there is one summit"
                       : fmt::format("the summits are equal (their heights scatter by less than "
                                     "{:g} of Rq)",
                                     kAlikeSummits)));
  }
  if (r.summits < kFewSummits) {
    r.notes.push_back(
        fmt::format("only {} summits were counted: their roughness is uncertain by {:.0f} %",
                    r.summits, 100.0 / std::sqrt(2.0 * static_cast<double>(r.summits))));
  }
}

/// The formula against the sum over the map's own summits where two such surfaces bear most: within
/// a standard deviation of where their summits meet (docs/surfaces.md has what Gaussian maps
/// leave). Few summits tell neither.
void note_formula(const std::vector<Summit>& summits, SurfaceReport& r) {
  if (r.summits < kFewSummits) return;
  constexpr double kApart = 2.0;  // of the two pressures: maps of Gaussian surfaces are within 1.3
  double most = 1.0;
  std::vector<double> where;
  for (const double apart : {-1.0, 0.0, 1.0}) {
    where.push_back(2.0 * r.counted.height + apart * std::numbers::sqrt2 * r.counted.roughness);
  }
  for (const surface::ContactRow& row : contact_curve(r.map, summits, r.counted, where)) {
    const double formula = row.pair_formula, sum = row.pair_summits;
    if (!(formula > 0.0) || !(sum > 0.0)) continue;
    most = std::max({most, sum / formula, formula / sum});
  }
  if (most < kApart) return;
  r.notes.push_back(fmt::format(
      "the heights are not those of a Gaussian surface (skewness {:.2f}, kurtosis {:.2f}): "
      "Greenwood-Tripp's formula and the sum over this map's own summits are apart by a factor of "
      "up to {:.2g}; its "
      "elastic_factor stands for the formula, not for this surface",
      r.heights.skewness, r.heights.kurtosis, most));
}

void note_table(SurfaceReport& r) {
  const std::size_t closed = r.factors.rows.size() - r.table.H.size();
  if (closed > 0 && !r.factors.rows.empty()) {
    r.notes.push_back(
        fmt::format("at the {} no oil passes the patch along the motion, or none across it: a "
                    "case's table (--csv) begins above",
                    closed == 1 ? "smallest gap" : fmt::format("{} smallest gaps", closed)));
  }
  if (!r.factors.rows.empty() && !r.fault.problem.empty()) {
    r.notes.push_back(
        fmt::format("no case can take these factors (--csv is refused): {}", r.fault.problem));
  }
}

/// Heights in a unit that is too small by a thousand look like a mirror.
void note_mirror(SurfaceReport& r) {
  constexpr double kMirror = 5e-9;  // superfinished rings have some 10 nm, lenses 1 nm [m]
  if (r.heights.Rq >= kMirror) return;
  r.notes.push_back(
      fmt::format("an Rq of {:.3g} nm is that of a mirror: check the unit of the "
                  "heights",
                  1e9 * r.heights.Rq));
}

/// Each term of the form takes away no more of the roughness's variance than one that is constant
/// over a correlation area does, 2/N; maps of 12 lengths lost two thirds of that.
void note_form(SurfaceReport& r) {
  constexpr double kSeen = 0.02;  // of Rq
  const int n = r.options.form;
  const double lost = 0.5 * (n + 1) * (n + 2) / r.correlation.independent;
  if (n == 0 || lost < kSeen) return;
  r.notes.push_back(
      fmt::format("form of degree {} takes roughness away with it: beside their standard error Rq "
                  "and summits may come out up to {:.0f} % low; a lower one (--form), or a larger "
                  "patch, takes less",
                  n, 100.0 * std::min(lost, 1.0)));
}

void note_limits(const std::vector<Summit>& summits, SurfaceReport& r) {
  note_mirror(r);
  note_form(r);
  if (const std::string spikes = spike_words(r); !spikes.empty()) r.notes.push_back(spikes);
  note_lay(r);
  note_grid(r);
  note_summits(r);
  note_formula(summits, r);
  if (r.holes.count > 0) {
    r.notes.push_back(fmt::format("{} holes ({:.3g} %) were filled by harmonic interpolation",
                                  r.holes.count, 100.0 * r.holes.share(r.map)));
  }
  note_table(r);
}

/// Separations of the contact's table: none of a Gaussian surface's summits reaches farther.
std::vector<double> separations(double Rq) {
  constexpr double kFarthest = 6.0, kStep = 0.5;  // in Rq
  std::vector<double> h;
  for (double x = 0.0; x <= kFarthest; x += kStep) h.push_back(x * Rq);
  return h;
}

}  // namespace

SurfaceReport describe_surface(const SurfaceOptions& options) {
  SurfaceReport r;
  r.options = options;
  const HeightMap measured = read_height_map(options.path, options.motion);
  r.holes = holes_of(measured);
  judge_holes(measured, r.holes, options);
  Levelled levelled = remove_form(measured, options.form);
  r.form = levelled.form;
  r.map = fill_laplace(std::move(levelled.map));
  double mean = 0.0;
  for (const double z : r.map.z) mean += z / static_cast<double>(r.map.z.size());
  for (double& z : r.map.z) z -= mean;
  judge_roughness(measured, r);
  r.heights = height_statistics(r.map);
  r.moments = spectral_moments(r.map);
  judge_slopes(r);
  r.correlation = correlation_of(r.map);
  judge_size(r);
  r.by_moments = summits_of(r.moments);
  const std::vector<Summit> summits = count_summits(r.map);
  r.summits = summits.size();
  r.counted = statistics_of(summits, r.map);
  r.contact = contact_curve(r.map, summits, r.counted, separations(r.heights.Rq));
  r.factors = map_factors(r.map, r.heights.Rq, options.gaps,
                          {options.periodic ? PatchEnds::periodic : PatchEnds::patch,
                           options.threads, options.progress, options.stop});
  r.table = factor_table(r.factors.rows, r.heights.Rq);
  r.fault = fluid::fault_of(r.table);
  note_limits(summits, r);
  return r;
}

}  // namespace shellback::app
