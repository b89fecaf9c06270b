#include "fluid/active_set.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"
#include "fluid/empty_rings.hpp"
#include "fluid/film_matrix.hpp"
#include "fluid/film_numbers.hpp"
#include "fluid/fischer_burmeister.hpp"

namespace shellback::fluid {

ActiveSet::ActiveSet(const FilmScene& scene, const Gap& gap, const Field& profile,
                     const OilLaw& oil, const FilmState& guess, const ReynoldsOptions& options)
    : scene_(scene), gap_(gap), profile_(profile), oil_(oil), tolerance_(options.tolerance) {
  const bool slow = scene.storage.finite() && scene.speed == 0.0;
  most_ = options.max_iterations + (slow ? scene.grid.nt : 0);
  out.value.state = guess;
}

bool ActiveSet::factorize() {
  FilmSolution& v = out.value;
  if (steady_ring_is_empty(scene_, v.state)) return false;
  assemble_film(scene_, v.flow, active_set_unknowns(v.state), matrix_);
  if (!v.factor.factorize(matrix_)) return false;
  ++v.factorizations;
  return true;
}

/// A film that was right from the start still owes its factors.
ActiveSetEnd ActiveSet::converged() {
  const bool factorized = out.value.factorizations > 0 || factorize();
  return factorized ? ActiveSetEnd::converged : singular();
}

ActiveSetEnd ActiveSet::singular() {
  const std::vector<int> rings = empty_rings(scene_, out.value.state);
  out.verdict = rings.empty() ? Verdict{Status::iteration_limit, ending::Plain::singular_film}
                              : Verdict{Status::iteration_limit,
                                        ending::Plain::empty_ring,
                                        {NAN, scene_.grid.z[rings.front()]}};
  return ActiveSetEnd::singular;
}

/// Newton's step with the factors of the last matrix.
UpdateReport ActiveSet::newton_step(Field& r) {
  FilmSolution& v = out.value;
  for (double& x : r) x = -x;
  v.factor.solve(r.data());
  return advance(scene_, v.oil, r, 1.0, v.state);
}

Verdict ActiveSet::stopped() const {
  return {Status::iteration_limit, ending::Unsettled{ending::Iteration::cavitation,
                                                     std::min(it_, most_), out.history.back()}};
}

ActiveSetEnd ActiveSet::run() {
  FilmSolution& v = out.value;
  while (it_ <= most_) {
    oil_(v.state, v.oil);
    evaluate_flow(scene_, gap_, profile_, v.oil, v.state, v.flow);
    Field r = film_residual(scene_, v.flow);
    const double norm = largest_magnitude(r) / flow_scale(v.flow);
    out.history.push_back(norm);
    if (!std::isfinite(norm)) {
      out.verdict = ended_by(scene_.grid, first_not_a_number(gap_, v.state, v.oil, v.flow));
      return ActiveSetEnd::not_a_number;
    }
    if (norm <= tolerance_ && complementary(scene_, v.state)) return converged();
    if (it_++ == most_) break;
    if (cycling_) {
      ++v.factorizations;
      if (!fischer_burmeister_step(scene_, gap_, profile_, oil_, v)) break;
      continue;
    }
    if (!factorize()) return singular();
    const UpdateReport report = newton_step(r);
    if (report.beyond_barus > 0) return ActiveSetEnd::beyond_law;
    if (report.moved > 0) cycling_ = !seen_.insert(active_set_hash(v.state)).second;
  }
  return ActiveSetEnd::limit;
}

}  // namespace shellback::fluid
