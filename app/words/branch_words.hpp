#pragma once
/// Where branches of steady states over load or speed end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/words/film_words.hpp"
#include "app/words/temperature_words.hpp"
#include "app/words/told.hpp"
#include "bearing/film/follow.hpp"
#include "core/constants.hpp"

namespace shellback::app::told {

struct RaisedWords {
  const char* name;
  const char* unit;
  double factor;  ///< into that unit
};
inline RaisedWords raised_words(ending::Raised raised) {
  switch (raised) {
    case ending::Raised::speed:
      return {"speed", "rpm", 1.0 / kRpm};
    case ending::Raised::supply:
      return {"supply pressure", "bar", 1e-5};
    case ending::Raised::place:
      return {"eccentricity or tilt", "", 1.0};
    case ending::Raised::load:
      break;
  }
  return {"load", "N", 1.0};
}

/// "4.1e+03 N of 8e+03 N".
inline std::string reached(const ending::Carried& c) {
  if (c.raised == ending::Raised::place) {
    return fmt::format("{:.4g} of the eccentricity and tilt given", c.part);
  }
  const auto [name, unit, factor] = raised_words(c.raised);
  return fmt::format("{:.4g} {} of {:.4g} {}", c.part * factor * c.whole, unit, factor * c.whole,
                     unit);
}

inline std::string followed(const ending::Carried& c, double h_min) {
  if (c.raised == ending::Raised::place) {
    return fmt::format(
        "followed from a place nearer to the middle, states are found up to {} (smallest gap "
        "{:.3g} um)",
        reached(c), h_min * 1e6);
  }
  return fmt::format(
      "followed from a {} {}, steady states are found up to {} (smallest gap {:.3g} um)",
      c.raised == ending::Raised::load ? "light" : "low", raised_words(c.raised).name, reached(c),
      h_min * 1e6);
}

/// Of a branch whose end does not speak of states above it.
inline std::string not_beyond(const ending::Carried& c, const About& a) {
  if (a.verdict.status != Status::iteration_limit || c.raised == ending::Raised::load) return "";
  return fmt::format("; with a higher {} the film may carry again, which was not seen",
                     raised_words(c.raised).name);
}

inline Told told(const ending::BranchEnded& e, const About& a) {
  const std::string way = followed(e.carried, e.h_min);
  switch (e.end) {
    case ending::BranchEnd::turned:
      return {fmt::format("{}{}{}; there the branch turns back: beyond it only states of less load "
                          "follow{}{}",
                          e.with_heat ? "film and heat: " : "", way,
                          e.with_heat ? ", its oil at most at " + told_temperature(e.T_high) : "",
                          !e.with_heat ? ""
                          : a.within.reason.empty()
                              ? ", and under more the bearing is not seen to come to rest"
                              : "; whether the bearing comes to rest under more was not seen to "
                                "its end",
                          not_beyond(e.carried, a)),
              e.with_heat ? kLessHeat
                          : "lower the load or the tilt, feed more oil, or give contact data"};
    case ending::BranchEnd::unbounded:
      return {fmt::format("the film cannot carry {:.4g} N: {}; closer the pressure grows without "
                          "bound ({}){}",
                          e.carried.whole, way, kBoundOfPressure, not_beyond(e.carried, a)),
              kBeyondBarus};
    case ending::BranchEnd::molecule:
      return {fmt::format("{}: {}, less than a molecule of oil{}{}", no_film(e.by_cells), way,
                          kept_by_cells(e.by_cells), not_beyond(e.carried, a)),
              cure_of_no_film(e.by_cells)};
    case ending::BranchEnd::reached:
    case ending::BranchEnd::lost:
    case ending::BranchEnd::interrupted:
      break;
  }
  const bool given_up =
      !a.verdict.cause.empty() && a.verdict.cause.front().is(ending::Plain::given_up);
  const std::string cure =
      given_up      ? a.within.cure
      : e.with_heat ? fmt::format(
                          "another grid, finer or coarser, a lower {}, a larger clearance, better "
                          "cooling, or a support that lets the housing grow",
                          raised_words(e.carried.raised).name)
      : e.carried.raised == ending::Raised::place
          ? "another grid (model.grid, model.axial_spacing), or a smaller eccentricity or tilt"
          : fmt::format("another grid (model.grid, model.axial_spacing); or {}", kContactElseLoad);
  return {
      fmt::format("no steady state was found: {}; there the search was given up, which proves no "
                  "end ({})",
                  way, a.within.reason),
      cure};
}

inline Told told(const ending::RanAway& e, const About& a) {
  const std::string way = followed(e.carried, e.h_min);
  if (!e.thins) {
    return {fmt::format("too hot: {}; with a tenth more, heated within {:.3g} s, {} (the "
                        "viscosity does not fall with temperature: nothing runs away){}",
                        way, e.t, a.within.reason, not_beyond(e.carried, a)),
            kLessHeat};
  }
  return {fmt::format("thermal runaway: {}; with a tenth more, film and walls run away within "
                      "{:.3g} s ({}){}",
                      way, e.t, a.within.reason, not_beyond(e.carried, a)),
          kLessHeat};
}

/// True if all grids end at the same part of load or speed, within what two may differ by.
inline bool limits_agree(const std::vector<ending::LimitOnGrid>& limits) {
  double least = INFINITY;
  double most = 0.0;
  for (const ending::LimitOnGrid& l : limits) {
    least = std::min(least, l.carried.part);
    most = std::max(most, l.carried.part);
    if (l.carried.raised != limits.front().carried.raised) return false;
  }
  return limits.size() > 1 && most <= (1.0 + bearing::kAgree) * least;
}

inline Told told(const ending::LimitMoves& e, const About& a) {
  std::string all;
  for (const ending::LimitOnGrid& l : e.limits) {
    all += fmt::format("{}{} on {} x {} cells", all.empty() ? "" : ", ", reached(l.carried),
                       l.grid[0], l.grid[1]);
  }
  const auto any = [&](const auto& is) {
    return std::any_of(e.limits.begin(), e.limits.end(),
                       [&](const ending::LimitOnGrid& l) { return is(l.carried.part); });
  };
  const bool reached_by_one = any([](double part) { return part == 1.0; });
  const bool near = any([](double part) { return !bearing::is_apart_from_asked(part); });
  const auto* end =
      a.verdict.cause.empty() ? nullptr : a.verdict.cause.front().as<ending::BranchEnded>();
  const char* why =
      reached_by_one            ? "another grid comes to what is asked for"
      : end && end->by_cells    ? "where the branch ends is the cells' making, not the bearing's"
      : e.limits.size() == 1    ? "no second grid shows the limit"
      : !limits_agree(e.limits) ? "the limit moves with the grid"
      : near ? "the limit is no farther from what is asked for than the tenth by which grids differ"
             : "the grids end at the same place, but that none lies beyond is shown on one of them "
               "alone";
  return {fmt::format("not resolved: {} ({}); {}", why, all, a.within.reason),
          end && end->by_cells ? a.within.cure : "a finer grid, or a lower load"};
}

}  // namespace shellback::app::told
