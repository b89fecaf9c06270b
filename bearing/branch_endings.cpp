#include "bearing/branch_endings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// "4.1e+03 N of 8e+03 N".
std::string reached(const Solution& s, bool speed, double part) {
  if (!speed) {
    return fmt::format("{:.4g} N of {:.4g} N", part * s.target.scale(), s.target.scale());
  }
  const double rpm = std::abs(s.model.input.operation.omega) * 30.0 / kPi;
  return fmt::format("{:.4g} rpm of {:.4g} rpm", part * rpm, rpm);
}

std::string followed(const Solution& s, const Branch& b) {
  const bool speed = b.raised == Raised::speed;
  return fmt::format("followed from {}, steady states are found up to {} (smallest gap {:.3g} um)",
                     speed ? "a low speed" : "a light load", reached(s, speed, b.carried),
                     b.h_min * 1e6);
}

}  // namespace

Verdict branch_ended(const Solution& s, const Branch& b) {
  const bool heat = s.model.physics.film_energy;
  switch (b.end) {
    case BranchEnd::turned:
      return {Status::no_steady_state,
              fmt::format("{}{}; there the branch turns back: beyond it only states of less load "
                          "follow",
                          heat ? "thermal runaway: " : "", followed(s, b)),
              fluid::place_of(s.film.least),
              heat ? "lower speed or load, feed more or cooler oil, or improve the cooling of the "
                     "shell"
                   : "lower the load or the tilt, feed more oil, or give contact data"};
    case BranchEnd::unbounded:
      return {Status::no_steady_state,
              fmt::format("the film cannot carry {:.4g} N: {}; closer the pressure grows without "
                          "bound (rigid surfaces and viscosity rising as exp(alpha p): the reduced "
                          "pressure q = (1 - exp(-alpha p))/alpha cannot exceed 1/alpha)",
                          s.target.scale(), followed(s, b)),
              fluid::place_of(s.film.least),
              "switch on elastic deformation, use the Roelands law, or lower the load"};
    case BranchEnd::molecule:
      return {
          Status::no_steady_state,
          fmt::format("no film carries the load: {}, less than a molecule of oil", followed(s, b)),
          fluid::place_of(s.film.least),
          "give roughness and contact data, switch on elastic deformation, or lower the load"};
    case BranchEnd::reached:
    case BranchEnd::lost:
    case BranchEnd::interrupted:
      break;
  }
  return {
      Status::iteration_limit,
      fmt::format("no steady state was found: {}, then none ({})", followed(s, b), b.last.reason),
      b.last.place, "lower the load or the tilt, or give roughness and contact data"};
}

Verdict ran_away_from(const Solution& s, const Branch& b, const MarchEnd& end) {
  return {Status::no_steady_state,
          fmt::format("thermal runaway: {}; with a tenth more, film and walls run away within "
                      "{:.3g} s ({})",
                      followed(s, b), end.t, end.verdict.reason),
          end.verdict.place,
          "lower speed or load, feed more or cooler oil, or improve the cooling of the shell"};
}

Verdict no_light_state(const Solution&) {
  return {Status::iteration_limit,
          "no light load and no low speed was found under which film and heat have a common state",
          "", "try a finer grid or a tighter range of operation"};
}

Verdict limit_not_resolved(const Solution& s) {
  std::string all;
  for (const Limit& l : s.limits) {
    all += fmt::format("{}{} on {} x {} cells", all.empty() ? "" : ", ",
                       reached(s, l.of_speed, l.part), l.grid[0], l.grid[1]);
  }
  return {
      Status::iteration_limit,
      fmt::format("not resolved: the limit moves with the grid ({}); {}", all, s.verdict.reason),
      s.verdict.place, "a finer grid, or a lower load"};
}

}  // namespace shellback::bearing
