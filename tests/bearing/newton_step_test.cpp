/// The Newton steps of film, journal and elastic shell; the linear algebra under them.
#include <catch2/catch.hpp>

#include "bearing/film/bordered_film.hpp"
#include "bearing/solids.hpp"
#include "core/gmres.hpp"
#include "tests/bearing/sample_bearing.hpp"
#include "tests/observed_order.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;
using shellback::test::order_of_errors;

namespace {

/// The solved state with its unknowns moved by `size` (relative), evaluated.
FilmEquilibrium disturbed(const Solution& s, double size) {
  FilmEquilibrium f = s.film;
  f.position.q[0] += size * f.least.h;
  f.position.q[1] -= 0.4 * size * f.least.h;
  const Field r = random_field(f.film.p.size(), 7, 0.0, 1.0);
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (s.point.scene.supply.cell[k] >= 0) continue;
    if (f.film.full[k]) f.film.p[k] *= 1.0 + size * r[k];
    if (!f.film.full[k]) f.film.theta[k] *= 1.0 - size * r[k];
    if (!f.elastic.empty()) f.elastic[k] *= 1.0 + size * r[k];
  }
  REQUIRE(evaluate(s.model, s.point, {}, 1e-13, f));
  return f;
}

void take(const Solution& s, const NewtonStep& step, FilmEquilibrium& f) {
  REQUIRE(step.good);
  for (int k = 0; k < 4; ++k) f.position.q[k] += step.q[k];
  const auto report = fluid::advance(s.point.scene, f.oil, step.film, 1.0, f.film);
  REQUIRE(report.moved == 0);  // near the solution: the film's region is settled
  for (std::size_t k = 0; k < f.elastic.size(); ++k) f.elastic[k] += step.elastic[k];
  REQUIRE(evaluate(s.model, s.point, {}, 1e-13, f));
}

Case barus_case() {
  Case c = plain_case();
  c.oil.pressure = rheology::Barus{1.5e-8};
  set_load(c, 5e3);
  return c;
}

}  // namespace

TEST_CASE("RigidStepSquaresTheError", "[newton_step]") {
  for (const bool rough : {false, true}) {
    Case c = rough ? rig_case() : barus_case();
    c.model.switches.shear_thinning = false;  // its slope is left out of the matrix on purpose
    if (rough) set_load(c, 15e3);             // well into contact
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    double before = 0.0;
    for (const double size : {2e-4, 1e-4, 5e-5}) {
      FilmEquilibrium f = disturbed(s, size);
      EquilibriumCost cost;
      take(s,
           newton_step(s.model, s.point.scene, s.point.load, f, residuals_of(s.model, s.point, f),
                       {}, cost),
           f);
      const Residuals n = residuals_of(s.model, s.point, f);
      const double error = n.film_norm + n.load_norm;
      INFO("size " << size << ": film " << n.film_norm << ", load " << n.load_norm);
      if (before > 0.0) CHECK(order_of_errors(before, error) == Approx(2.0).margin(0.15));
      before = error;
    }
  }
}

TEST_CASE("ElasticStepSquaresTheError", "[newton_step]") {
  for (const double load : {8e3, 20e3}) {  // without and with contact
    Case c = rig_case();
    soften_edges(c);
    c.model.switches.shear_thinning = false;
    c.model.switches.pressure_dependence = false;
    c.model.switches.elastic_deformation = true;
    set_load(c, load);
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    double before = 0.0;
    for (const double size : {4e-3, 2e-3, 1e-3}) {
      FilmEquilibrium f = disturbed(s, size);
      const Residuals start = residuals_of(s.model, s.point, f);
      EquilibriumCost cost;
      take(s, newton_step(s.model, s.point.scene, s.point.load, f, start, {}, cost), f);
      const Residuals n = residuals_of(s.model, s.point, f);
      INFO("size " << size << ": film " << n.film_norm << ", load " << n.load_norm << ", elastic "
                   << n.elastic_norm << " from " << start.elastic_norm);
      const double error =
          n.film_norm + n.load_norm;  // (1) and (3) are linear in the step, exactly
      if (before > 0.0) CHECK(order_of_errors(before, error) > 1.85);
      before = error;
      CHECK(n.elastic_norm < 2e-3 * start.elastic_norm);  // (2): 1e-4 of GMRES in the mean square
    }
  }
}

TEST_CASE("WantedChangeLeadsToTheTarget", "[newton_step]") {
  LoadTarget target;
  target.force = {300.0, -4000.0, 0.0, 0.0};
  for (const double size : {1e-2, 5e-3}) {  // ln(1 + x) = x - x^2/2: near the target the difference
    const fluid::Wrench now{300.0 - 4000.0 * size, -4000.0 + 2000.0 * size, 0.3, 0.0};
    const fluid::Wrench d = wanted_change(now, target.force);
    CHECK(std::abs(d[0] - 4000.0 * size) < 1.5 * size * size * 4000.0);
    CHECK(std::abs(d[1] + 2000.0 * size) < 1.5 * size * size * 4000.0);
    CHECK(d[2] == Approx(-0.3));
  }
  const fluid::Wrench d = wanted_change({30.0, -400.0, 0.0, 0.0}, target.force);  // a tenth of it
  CHECK(d[1] == Approx(-400.0 * std::log(10.0)).epsilon(1e-12));
  CHECK(d[0] == Approx(30.0 * std::log(10.0)).epsilon(1e-12));
}

TEST_CASE("LimitedStepNeverClosesTheGap", "[newton_step]") {
  const double c = 30e-6;
  for (const double e : {0.1, 0.5, 0.9, 0.999}) {
    const fluid::JournalPosition q{{e * c, 0.0, 0.0, 0.0}};
    const double gap = (1.0 - e) * c;
    for (const double push : {0.01, 1.0, 100.0}) {
      const auto d = limited(q, {push * c, 0.3 * push * c, 0.0, 0.0}, gap, c, 0.0125, 1.0);
      CHECK(std::hypot(q.ex() + d[0], q.ey() + d[1]) < c);
    }
    const double tiny = 1e-6 * gap;  // short steps pass unchanged, to second order
    const auto d = limited(q, {tiny, tiny, 0.0, 0.0}, gap, c, 0.0125, 1.0);
    CHECK(std::abs(d[0] - tiny) < 1e-5 * tiny);
    CHECK(std::abs(d[1] - tiny) < 1e-5 * tiny);
    const double round = 1e-14 * e * c;  // and those of the place's round-off to their own
    const auto r = limited(q, {round, -round, 0.0, 0.0}, gap, c, 0.0125, 1.0);
    CHECK(std::abs(r[0] - round) < 1e-9 * round);
    CHECK(std::abs(r[1] + round) < 1e-9 * round);
  }
}

TEST_CASE("GmresEndsInAsManyStepsAsThereAreEigenvalues", "[newton_step]") {
  const std::vector<double> b{1.0, -2.0, 3.0, 4.0, -5.0, 6.0};
  const auto diagonal = [](const std::vector<double>& x) {
    std::vector<double> y = x;
    for (std::size_t k = 0; k < y.size(); ++k) y[k] *= 1.0 + static_cast<double>(k % 3);
    return y;
  };
  const KrylovResult r = gmres(diagonal, b, 1e-12, 20);
  CHECK(r.iterations == 3);
  CHECK(r.reduction < 1e-12);
  for (std::size_t k = 0; k < b.size(); ++k) {
    CHECK(r.x[k] == Approx(b[k] / (1.0 + static_cast<double>(k % 3))).epsilon(1e-12));
  }
  const auto swap = [](const std::vector<double>& x) {  // not symmetric, no progress at first
    return std::vector<double>{x[1], x[2], 2.0 * x[0]};
  };
  const KrylovResult s = gmres(swap, {1.0, 2.0, 3.0}, 1e-12, 20);
  CHECK(s.x[0] == Approx(1.5).epsilon(1e-12));
  CHECK(s.x[1] == Approx(1.0).epsilon(1e-12));
  CHECK(s.x[2] == Approx(2.0).epsilon(1e-12));
  const KrylovResult stopped = gmres(swap, {1.0, 2.0, 3.0}, 1e-12, 1);
  CHECK(stopped.iterations == 1);
  CHECK(stopped.reduction > 0.1);
  const KrylovResult loose = gmres(diagonal, b, 0.3, 20);
  CHECK(loose.iterations < 3);
  const std::vector<double> y = diagonal(loose.x);
  double off = 0.0;
  double size = 0.0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    off += (b[k] - y[k]) * (b[k] - y[k]);
    size += b[k] * b[k];
  }
  CHECK(loose.reduction <= 0.3);
  CHECK(loose.reduction == Approx(std::sqrt(off / size)).epsilon(1e-12));  // as it says
  const KrylovResult zero = gmres(swap, {0.0, 0.0, 0.0}, 1e-6, 5);
  CHECK(zero.x == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("GmresAsksOnlyForWhatItHasNotBeenTold", "[newton_step]") {
  // Three large eigenvalues, apart; in 1 + 1e-3 k the operators of two solves differ.
  constexpr std::size_t kNumbers = 40;
  const auto stretched = [](double more) {
    return [more](const std::vector<double>& x) {
      std::vector<double> y = x;
      for (std::size_t k = 0; k < 3; ++k) y[k] *= (2.0 + 5.0 * static_cast<double>(k)) * more;
      return y;
    };
  };
  std::vector<double> b(kNumbers, 1.0), other(kNumbers);
  for (std::size_t k = 0; k < kNumbers; ++k) other[k] = std::sin(1.0 + static_cast<double>(k));
  KrylovMemory memory;
  CHECK(gmres(stretched(1.0), b, 1e-9, 20, &memory).iterations == 4);
  const KrylovResult same = gmres(stretched(1.0), b, 1e-9, 20, &memory);
  CHECK(same.iterations == 1);  // it lies among the answers
  CHECK(same.x[2] == Approx(1.0 / 12.0).epsilon(1e-9));
  const KrylovResult near = gmres(stretched(1.01), b, 1e-2, 20, &memory);
  CHECK(near.iterations == 1);  // wrong by a hundredth of them
  CHECK(gmres(stretched(1.01), b, 1e-2, 20).iterations > 1);
  const KrylovResult exact = gmres(stretched(1.01), other, 1e-9, 20, &memory);
  for (std::size_t k = 0; k < 3; ++k) {  // however good the memory, the answer is this operator's
    const double by = (2.0 + 5.0 * static_cast<double>(k)) * 1.01;
    CHECK(exact.x[k] == Approx(other[k] / by).epsilon(1e-8));
  }
  std::vector<double> broken(kNumbers, NAN);
  memory.learn(broken, broken);  // and no number that is none is learnt
  CHECK(gmres(stretched(1.0), b, 1e-9, 20, &memory).iterations == 1);
}
