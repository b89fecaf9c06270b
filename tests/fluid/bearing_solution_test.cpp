// Finite bearings against published tables (independently recomputed columns own_*).
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"
#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using shellback::test::CsvRow;
using shellback::test::read_csv;
using shellback::test::richardson;

namespace {

/// Raimondi and Boyd's scene: the film starts at the widest gap at p = 0, drained by the sides.
Characteristics on_grid(double width_over_diameter, double eps, int nt, int nz) {
  Setup s;
  s.width = 2.0 * s.radius * width_over_diameter;
  s.position = eccentric(eps * s.clearance, 0.0);
  s.patches = {line_supply(s, kPi)};
  s.half = true;
  s.nt = nt;
  s.nz = nz;
  const PosedFilm b = make_bearing(s);
  const auto film = solve(b);
  REQUIRE(film.good());
  return characteristics(s, b, film.value, CavitatedShear::full);
}

/// Two grids and Richardson: the error falls with the second order where the film is well loaded.
Characteristics extrapolated(double width_over_diameter, double eps) {
  const Characteristics a = on_grid(width_over_diameter, eps, 200, 25);
  const Characteristics b = on_grid(width_over_diameter, eps, 400, 50);
  return {richardson(a.sommerfeld, b.sommerfeld), richardson(a.attitude, b.attitude),
          richardson(a.friction, b.friction),     richardson(a.side_flow, b.side_flow),
          richardson(a.inlet_flow, b.inlet_flow), richardson(a.p_ratio, b.p_ratio)};
}

double off(double value, double expected) { return std::abs(value / expected - 1.0); }

}  // namespace

TEST_CASE("FiniteBearingsFollowRaimondiAndBoyd") {
  int rows = 0;
  for (const CsvRow& row : read_csv("validation/data/raimondi_boyd_1958.csv")) {
    const double eps = row.at("eps");
    const Characteristics own = extrapolated(row.at("L_over_D"), eps);
    CAPTURE(row.at("L_over_D"), eps);
    // design 6 asks for 0.5 % and 0.3 deg. Ours is extrapolated, the reference was solved on 720 x
    // 40 to 1440 x 40 half grids without extrapolation: second order leaves it 4e-4 at most, the
    // peak pressure (one cell's value) 1e-3; angles 0.01 deg.
    CHECK(off(own.sommerfeld, row.at("own_S")) < 1e-3);
    CHECK(std::abs(own.attitude - row.at("own_phi_deg")) < 0.02);
    CHECK(off(own.friction, row.at("own_f")) < 1e-3);
    CHECK(off(own.inlet_flow, row.at("own_Q")) < 1e-3);
    CHECK(off(own.side_flow, row.at("own_Q") * row.at("own_QsQ")) < 1e-3);
    CHECK(off(own.p_ratio, row.at("own_PP")) < 2e-3);
    ++rows;
  }
  CHECK(rows == 21);
}

TEST_CASE("PublishedSommerfeldNumbersAreMetWithinTheirOwnAccuracy") {
  // validation 3.1: the 1958 table lies within 1 % in S and 1.1 % in attitude of converged
  // solutions up to eps = 0.9; L/D = 1, eps = 0.4 is a misprint there.
  for (const CsvRow& row : read_csv("validation/data/raimondi_boyd_1958.csv")) {
    const double eps = row.at("eps"), ratio = row.at("L_over_D");
    if (eps > 0.9 || (eps == 0.4 && ratio == 1.0)) continue;
    const Characteristics own = on_grid(ratio, eps, 400, 50);
    CAPTURE(ratio, eps);
    CHECK(off(own.sommerfeld, row.at("pub_S")) < 1.5e-2);
    CHECK(off(own.attitude, row.at("pub_phi_deg")) < 1.5e-2);
    CHECK(off(own.friction, row.at("pub_f")) < 1.5e-2);
  }
}

TEST_CASE("FiniteBearingsFollowButenschoen") {
  int rows = 0;
  for (const CsvRow& row : read_csv("validation/data/butenschoen_1976_rotation.csv")) {
    const double eps = row.at("eps"), ratio = row.at("B_over_D");
    if (eps != 0.3 && eps != 0.5 && eps != 0.7 && eps != 0.95) continue;
    const Characteristics own = extrapolated(ratio, eps);
    CAPTURE(ratio, eps);
    CHECK(off(1.0 / (2.0 * kPi * own.sommerfeld), row.at("own_So")) < 5e-3);  // design 6
    CHECK(off(1.0 / (2.0 * kPi * own.sommerfeld), row.at("So")) < 1e-2);      // validation 3.4
    CHECK(std::abs(own.attitude - row.at("own_beta_deg")) < 0.3);
    // Q/(R^3 psi omega) from Q/(R c N L): times N L/(R omega) = L/(2 pi R).
    const double side = own.side_flow * 2.0 * ratio / (2.0 * kPi);
    CHECK(off(side, row.at("own_Q")) < 5e-3);
    ++rows;
  }
  CHECK(rows >= 8);
}
