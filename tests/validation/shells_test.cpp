/// The study of the shells: its parts on their own, and what an interrupted one shows.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/library.hpp"
#include "app/read_case.hpp"
#include "validation/shells/shells_page.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

bearing::Case shipped(const ShellKind& kind) {
  return app::read_case(app::case_path(kind.file).string());
}

}  // namespace

TEST_CASE("TheShippedShellsHaveThePartsOfTable4", "[shells]") {
  for (const ShellKind& kind : shell_kinds()) {
    INFO(kind.name);
    const solid::FrictionParts p = parts_at_the_papers_point(shipped(kind));
    // the modulus of the polymer pair is rounded to five digits
    CHECK(p.abrasive == Approx(kind.coefficients[0]).epsilon(1e-4));
    CHECK(p.adhesive == Approx(kind.coefficients[1]).epsilon(1e-4));
    CHECK(p.micro_hydrodynamic == Approx(kind.coefficients[2]).epsilon(1e-4));
  }
}

TEST_CASE("TheShellsDifferInNothingButSurfacesAndCoating", "[shells]") {
  const bearing::Case plain = shipped(shell_kinds()[0]);
  for (const ShellKind& kind : shell_kinds()) {
    const bearing::Case c = shipped(kind);
    REQUIRE(c.cycle);
    CHECK(c.cycle->y == plain.cycle->y);
    CHECK(c.bearing.radial_clearance == plain.bearing.radial_clearance);
    double thickness = 0.0;
    for (const auto& layer : c.shell->layers) thickness += layer.thickness;
    CHECK(thickness == Approx(2e-3).epsilon(1e-12));
    CHECK(least_film(c) > 0.3e-6);
  }
}

TEST_CASE("AStudyOfShellsThatIsStoppedSaysSo", "[shells]") {
  const std::atomic<bool> stop = true;
  StudyOptions options;
  options.stop = &stop;
  const ShellsStudy study = run_shells_study(shells_plan(true), options);
  CHECK(study.interrupted);
  CHECK(study.count_failed() == 0);
  const std::string page = shells_page(study);
  CHECK(page.find("Interrupted") != std::string::npos);
  CHECK(page.find("not run") != std::string::npos);
  CHECK(page.find(">nan") == std::string::npos);
  CHECK(shells_json(study).find("\"interrupted\"") != std::string::npos);
}
