#include "app/labels/identify_words.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "app/words/ending_words.hpp"

namespace shellback::app {

using study::FitDirection;
using study::FitStatus;

namespace {

constexpr double kShownPart = 0.1;  ///< parts of a direction below are not named [-]

/// The last part of a key: "b" of surfaces.contact.friction_law.b.
std::string short_name(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::string moved(const FittedKey& key, double distance) {
  const double span =
      fit_coordinate(key.value, key.value.high) - fit_coordinate(key.value, key.value.low);
  if (in_logarithms(key.value)) {
    return fmt::format("{} x {:.3g}", short_name(key.key), std::exp(distance * span));
  }
  return fmt::format("{} {:+.3g}{}{}", short_name(key.key), distance * span,
                     key.unit.empty() ? "" : " ", key.unit);
}

void add_undetermined(const IdentifyView& v, std::vector<std::string>& all) {
  for (const FitDirection& d : v.end.fit.directions) {
    if (d.determined) continue;
    const std::string wide =
        std::isfinite(d.deviation) && d.deviation < 1e3
            ? fmt::format(
                  "the deviation is {:.2g} of the bounds' distance (0.29 is that of the "
                  "bounds alone)",
                  d.deviation)
            : "nothing changes beyond the error of the differences";
    all.push_back(fmt::format(
        "the data do not determine {}: along it {}; {}", direction_words(v, d), wide,
        v.keys.size() == 1
            ? "look whether the key acts in this tier on what is measured (kappa of the equivalent "
              "temperature: in tier isothermal, with a column shell_back_temperature)"
            : "fix one of these keys with --set and leave it out of --fit, or measure where they "
              "act apart"));
  }
}

void add_status(const IdentifyView& v, std::vector<std::string>& all) {
  const study::Fit& fit = v.end.fit;
  const int values = v.end.values_used(v.table.points);
  const auto keys = static_cast<int>(v.keys.size());
  if (values < keys || (values == keys && !v.table.deviations_known)) {
    all.push_back(
        fmt::format("{} measured value{} cannot determine {} key{}{}; measure more points "
                    "or fit fewer keys",
                    values, values == 1 ? "" : "s", keys, keys == 1 ? "" : "s",
                    values == keys ? " and their own scatter (no deviations are given)" : ""));
  }
  if (fit.status == FitStatus::not_computed && std::isinf(fit.chi2_start)) {
    all.push_back(
        "the measured values are further from the computed ones than numbers go, in their "
        "deviations; check their units");
  } else if (fit.status == FitStatus::not_computed) {
    all.push_back(fit.computed()
                      ? "the points cannot be solved around the keys found, which are the best "
                        "until then; go on from other values with --set, or take narrower bounds"
                      : "the points cannot be solved with the keys of the start; begin at other "
                        "values with --set");
  }
  if (fit.status == FitStatus::unsettled && !fit.directions.empty()) {
    all.push_back(
        fmt::format("the search ended after {} steps and still wants to move by {:.2g} "
                    "deviations; go on from the values found, with --set",
                    fit.iterations, fit.remaining));
  }
}

}  // namespace

std::string direction_words(const IdentifyView& v, const FitDirection& d) {
  if (v.keys.size() == 1) return v.keys.front().key;
  double most = 0.0;
  for (const double part : d.part) most = std::abs(part) > std::abs(most) ? part : most;
  std::string words;
  for (std::size_t k = 0; k < d.part.size(); ++k) {
    if (std::abs(d.part[k] / most) < kShownPart) continue;
    words += (words.empty() ? "" : " with ") + moved(v.keys[k], 0.1 * d.part[k] / most);
  }
  return words;
}

double found_deviation(const IdentifyView& v) {
  if (v.table.deviations_known || v.end.fit.freedom <= 0) return NAN;
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const study::FittedPoint& p = v.end.points[i];
    for (std::size_t k = 0; k < p.fitted.size(); ++k) {
      squares += std::pow(p.fitted[k] - v.table.points[i].values[k].value, 2);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / v.end.fit.freedom) : NAN;
}

/// Without deviations: by how much of itself a measured value is missed (root mean square) [-].
double missed_part(const IdentifyView& v) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const study::FittedPoint& p = v.end.points[i];
    for (std::size_t k = 0; k < p.fitted.size(); ++k) {
      const double measured = v.table.points[i].values[k].value;
      if (measured == 0.0) continue;
      squares += std::pow(p.fitted[k] / measured - 1.0, 2);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

std::string misfit(const IdentifyView& v) {
  constexpr double kChance = 1e-3;
  constexpr double kMissed = 0.25;  // of the values; told only, a plain share [-]
  const study::Fit& fit = v.end.fit;
  if (fit.freedom <= 0 || fit.directions.empty()) return "";
  if (!v.table.deviations_known) {
    const double missed = missed_part(v);
    if (!(missed > kMissed)) return "";
    return fmt::format(
        "the fitted case misses the measured values by {:.0f} % of themselves (root mean square): "
        "the tier does not describe them, another key is wrong, or the table is of another bearing "
        "or in other units",
        100.0 * missed);
  }
  const double usual = gsl_cdf_chisq_Qinv(kChance, fit.freedom);
  if (fit.chi2 <= usual) return "";
  return fmt::format(
      "the fitted case misses the data by more than their deviations allow (chi2 {:.4g}; above "
      "{:.3g} by chance once in a thousand): the tier does not describe them, another key is "
      "wrong, "
      "or the deviations are too small; those of the keys are then too small as well",
      fit.chi2, usual);
}

std::string jumps(const IdentifyView& v) {
  if (v.moving.empty()) return "";
  std::string names;
  for (const std::string& key : v.moving) names += (names.empty() ? "" : ", ") + key;
  return fmt::format(
      "cells of the film move with {}: what is computed jumps where one comes or goes, by as much "
      "as the grid errs, and a search may settle on either side; begin at other values (--set), "
      "too, or take a finer grid (model.grid)",
      names);
}

const char* to_string(FitStatus status) {
  switch (status) {
    case FitStatus::settled:
      return "settled";
    case FitStatus::unsettled:
      return "not_settled";
    case FitStatus::not_computed:
      return "not_computed";
    case FitStatus::interrupted:
      return "interrupted";
  }
  return "";
}

std::vector<std::string> complaints(const IdentifyView& v) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const study::FittedPoint& p = v.end.points[i];
    if (p.used() || v.end.fit.status == FitStatus::interrupted) continue;
    const EndingWords why = words_of(p.verdict);
    all.push_back(fmt::format("{} is left out: {}{}{}", v.table.points[i].name, why.reason,
                              why.cure.empty() ? "" : "; ", why.cure));
  }
  add_status(v, all);
  add_undetermined(v, all);
  return all;
}

}  // namespace shellback::app
