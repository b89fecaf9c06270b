// A film that reforms in a shallow pocket, against an exact solution: what the density law does.
#include "tests/analytic/compressible_pocket.hpp"

#include <catch2/catch.hpp>

#include "tests/app/sample_case.hpp"
#include "validation/evaluators/barotropic_oil.hpp"
#include "validation/evaluators/slider.hpp"

using namespace shellback;
using analytic::CompressiblePocket;

namespace {

/// The exact slider with the constants of Dowson and Higginson, seed 002 Eq. 27.
CompressiblePocket with_printed_constants() {
  CompressiblePocket exact;
  exact.C1 = 1.0 / 1.7e-9;
  exact.C2 = 1.0 + 0.6 / 1.7;
  return exact;
}

/// Ours, endlessly wide, on `cells` over the length; density as the case file has it.
validation::SliderFilm solved(const std::string& constants, int cells) {
  const CompressiblePocket exact;
  rheology::Oil oil = app::read_sample("density = \"850 kg/m3\"",
                                       "density = { law = \"dowson-higginson\", rho0 = \"850 "
                                       "kg/m3\", at = \"40 degC\", expansivity = \"0 1/K\"" +
                                           constants + " }")
                          .oil;
  oil.temperature = rheology::ConstantViscosity{exact.eta0};
  oil.pressure = rheology::Barus{exact.alpha};
  oil.shear = rheology::NoShearThinning{};
  validation::Slider s;
  s.length = exact.length;
  s.h_in = exact.h_in;
  s.h_out = exact.h_out;
  s.pocket_from = exact.pocket_from;
  s.pocket_to = exact.pocket_to;
  s.depth = exact.depth;
  s.speed = exact.speed;
  s.p_ambient = exact.p_ambient;
  s.cells = cells;
  return validation::solve_slider(s, validation::barotropic_oil(oil, 313.15), 850.0);
}

}  // namespace

TEST_CASE("TheExactPeakBehindThePocketIsTheOneComputedElsewhere") {
  // Four digits each, from another program's integration of the same equation.
  CHECK(CompressiblePocket{}.peak() == Approx(41.90e6).epsilon(2e-4));
  CHECK(with_printed_constants().peak() == Approx(36.78e6).epsilon(2e-4));
}

TEST_CASE("ThePeakBehindAPocketFollowsTheConstantsOfTheDensityLaw") {
  // The front lies anywhere in its cell and the peak half a cell before the pocket's end: 1.5 of
  // the 320 to 360 cells over which the pressure rises.
  constexpr int kCells = 1600;
  const struct {
    const char* keys;
    CompressiblePocket exact;
  } laws[] = {{", C1 = \"2.22 GPa\", C2 = 1.66", {}}, {"", with_printed_constants()}};
  for (const auto& law : laws) {
    CAPTURE(law.keys);
    const validation::SliderFilm film = solved(law.keys, kCells);
    REQUIRE(film.verdict.good());
    CHECK(film.p_max == Approx(law.exact.peak()).epsilon(5e-3));
    CHECK(film.flow_per_width == Approx(law.exact.flow()).epsilon(1e-3));  // design 6
    CHECK(std::abs(film.reformation - law.exact.reformation()) <= 1.01 * law.exact.length / kCells);
  }
}
