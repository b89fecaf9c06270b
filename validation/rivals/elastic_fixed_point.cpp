#include "validation/rivals/elastic_fixed_point.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/pseudo_time.hpp"
#include "bearing/solids.hpp"
#include "core/largest.hpp"
#include "validation/rivals/film_then_position.hpp"

namespace shellback::validation {

using namespace bearing;

namespace {

constexpr int kMostRounds = 1000;
constexpr int kPatience = 100;  ///< rounds without a smaller mismatch that show that none will come
constexpr double kFirstRelaxation = 0.1;  ///< of Aitken's: small enough for an opening of ten films
constexpr double kLeast = 0.01;           ///< relaxation below which nothing moves any more [-]
constexpr double kGrown = 30.0;           ///< growth of the mismatch over its best, and
constexpr double kLost = 3.0;  ///< mismatch in smallest gaps, that together are divergence [-]

/// Aitken's factor from the mismatches of two rounds; see (1).
double aitken(double omega, const Field& before, const Field& now) {
  double along = 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double d = now[k] - before[k];
    along += before[k] * d;
    square += d * d;
  }
  return square > 0.0 ? std::clamp(-omega * along / square, kLeast, 1.0) : omega;
}

}  // namespace

Verdict elastic_fixed_point(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  const auto& [model, point, thermal_deformation, options, stop, memory] = task;
  BearingModel rigid = model;
  rigid.physics.elastic = false;
  const double fixed = model.input.model.methods.relaxation;
  double omega = fixed > 0.0 ? fixed : kFirstRelaxation;
  Field d = s.elastic;
  Field before;
  double best = INFINITY;
  double norm = INFINITY;
  int best_round = 0;
  int round = 0;
  for (; round < kMostRounds; ++round) {
    if (stop && stop->load()) {
      s.elastic = d;
      return {Status::interrupted};
    }
    ++cost.elastic_rounds;
    EquilibriumOptions film = options;  // no tighter than the displacement is known
    const double loose = std::isfinite(norm) ? std::min(1e-2 * norm, 1e-2) : 1e-2;
    film.film_tolerance = std::max(options.film_tolerance, 1e-1 * loose);
    film.load_tolerance = std::max(options.load_tolerance, loose);
    film.viscosity_tolerance = std::max(options.viscosity_tolerance, 1e-1 * loose);
    s.elastic.clear();
    const bool usual = model.input.model.methods.cavitation == CavitationMethod::active_set;
    const auto solve = usual ? newton_or_through_time : film_then_position;
    const Verdict v = solve({rigid, point, sum(thermal_deformation, d), film, stop}, s, cost);
    s.elastic = d;
    if (v.status == Status::interrupted) return v;
    if (!v.good()) {
      return {Status::iteration_limit,
              ending::FixedPointDiverged{round + 1, NAN, largest_magnitude(d), s.least.h},
              {},
              {v}};
    }
    Field total = s.film.p;
    for (std::size_t k = 0; k < total.size(); ++k) total[k] += s.p_contact[k];
    Field r = model.solids->compliance(total);
    for (std::size_t k = 0; k < r.size(); ++k) r[k] -= d[k];
    norm = largest_magnitude(r) / (std::max(s.least.h, 0.0) + model.domain.rough.sigma + 1e-9);
    const bool settled = norm <= options.elastic_tolerance;
    if (settled && loose <= options.load_tolerance) return {};
    if (!(norm < std::max(kGrown * best, kLost))) {
      return {Status::iteration_limit,
              ending::FixedPointDiverged{round + 1, norm, largest_magnitude(d), s.least.h}};
    }
    if (norm < best) {
      best = norm;
      best_round = round;
    }
    if (round - best_round > kPatience) break;
    if (fixed <= 0.0 && !before.empty()) omega = aitken(omega, before, r);
    for (std::size_t k = 0; k < d.size(); ++k) d[k] += omega * r[k];
    before = std::move(r);
  }
  s.elastic = d;
  return {Status::iteration_limit,
          ending::FixedPointUnsettled{std::min(round + 1, kMostRounds), norm, omega}};
}

}  // namespace shellback::validation
