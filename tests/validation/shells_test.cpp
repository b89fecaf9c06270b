/// The study of the shells: its parts on their own, and what an interrupted one shows.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle.hpp"
#include "core/constants.hpp"
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

TEST_CASE("WhatThePaperLeavesOpenIsACaseOfItsOwn", "[shells]") {
  // The mouth turns with the pin through the dead centre, in the rod by theta + beta; 8 deg after
  // it the film presses hardest, and the mouth must stand where the variant says.
  const bearing::Case usual = shipped(shell_kinds()[0]);
  for (const ShellVariant& v : shell_variants()) {
    INFO(v.name);
    const bearing::Case c = varied(usual, v);
    CHECK(bearing::judge(c).empty());
    CHECK(*c.oil_temperature == Approx(*usual.oil_temperature + v.warmer));
    CHECK(c.supplies.at(0).temperature == Approx(usual.supplies.at(0).temperature + v.warmer));
    CHECK(!c.shell->layers.front().elasto_plastic);  // AlSn has no law of flow
    const bearing::Case coated = varied(shipped(shell_kinds()[2]), v);
    CHECK(bearing::judge(coated).empty());
    CHECK(coated.shell->layers.front().elasto_plastic == v.flows);
    if (std::isnan(v.mouth)) {
      CHECK(c.supplies[0].kind == usual.supplies[0].kind);
      continue;
    }
    CHECK(c.supplies[0].kind == bearing::SupplyKind::drilling);
    const double theta = 8.0 * kPi / 180.0;
    const double beta = std::asin(0.5 * 137.0 / 207.0 * std::sin(theta));
    // 0.1 deg: the angle is given to that
    CHECK(c.supplies[0].angle + theta + beta - 0.5 * kPi == Approx(v.mouth).margin(0.0018));
  }
}

TEST_CASE("PowersOfFilmAsperitiesAndLoadAreThePowerLossOfTheCycle", "[shells]") {
  // Whatever the course: the mean of torque times speed; what is left of the power loss is the work
  // of the load on the moving pin, which the sum of the table leaves out.
  ShellCycle c;
  double turning = 0.0;
  for (int k = 0; k <= 20; ++k) {
    bearing::CycleInstant i;
    i.t = 1e-3 * (k + 0.3 * std::sin(k));
    i.omega = 200.0 + 5.0 * std::cos(k);
    i.torque_asperity = 0.01 * (1.0 + std::sin(k));
    i.torque = 0.5 + 0.1 * std::cos(2.0 * k);
    if (k > 0) {
      const bearing::CycleInstant& last = c.result.instants.back();
      turning += 0.5 * (i.t - last.t) * (i.torque * i.omega + last.torque * last.omega);
    }
    c.result.instants.push_back(i);
  }
  turning /= c.result.instants.back().t - c.result.instants.front().t;
  c.result.quantities.push_back({{"power_loss", 123.0, "W"}});
  add_powers(c);
  CHECK(c.film_power + c.asperity_power == Approx(turning).epsilon(1e-12));
  CHECK(c.load_power == Approx(123.0 - turning).epsilon(1e-12));
  CHECK(c.asperity_power > 0.0);
  CHECK(c.asperity_power < 0.02 * 205.0);  // never more than its largest torque and speed
}

TEST_CASE("TheLoadThatMeetsALimitIsOnTheLineThroughTwo", "[shells]") {
  // h = 0.8 um - 0.4 um ln f and T = 400 K + 20 K ln f
  const auto at = [](double f) {
    return LoadTried{f, 0.8e-6 - 0.4e-6 * std::log(f), 400.0 + 20.0 * std::log(f)};
  };
  const double film = std::exp(0.3 / 0.4);
  CHECK(load_met(ShellLimit::film, at(1.0), at(2.0), 0.5e-6, 443.15) ==
        Approx(film).epsilon(1e-12));
  CHECK(load_met(ShellLimit::film, at(0.25), at(0.5), 0.5e-6, 443.15) ==
        Approx(film).epsilon(1e-12));  // carried on beyond the two
  CHECK(load_met(ShellLimit::lining, at(1.0), at(2.0), 0.5e-6, 410.0) ==
        Approx(std::exp(0.5)).epsilon(1e-12));
  CHECK(std::isnan(load_met(ShellLimit::state, at(1.0), at(2.0), 0.5e-6, 410.0)));
  CHECK(std::isnan(load_met(ShellLimit::film, at(1.0), LoadTried{2.0, NAN, NAN}, 0.5e-6, 410.0)));
  CHECK(std::isnan(load_met(ShellLimit::film, {}, at(2.0), 0.5e-6, 410.0)));
}

TEST_CASE("TheSearchForACapabilityEndsAtTheLimitOfAnyCurve", "[shells]") {
  // h over the load as a power, a line in its logarithm, with a sudden end; limits over the whole
  // range. A bisection of the range to 9 % takes seven loads.
  const ShellsPlan plan = shells_plan(false);
  constexpr double kLeast = 0.5e-6;
  const auto search = [&](const std::function<double(double)>& h, double end) {
    Capability c;
    int loads = 0;
    const auto met = [&] { return load_met(c.limit, c.good, c.bad, kLeast, 1e3); };
    for (double f = 1.0; f > 0.0; f = next_load(plan, c, met())) {
      REQUIRE(++loads < 20);
      CHECK(f >= plan.factors[0]);
      CHECK(f <= plan.factors[1]);
      const bool found = f < end;
      (found && h(f) >= kLeast ? c.good : c.bad) = {f, found ? h(f) : NAN, 300.0};
      if (!found || h(f) < kLeast) c.limit = found ? ShellLimit::film : ShellLimit::state;
    }
    return std::pair(c, loads);
  };
  for (const double limit : {0.26, 0.5, 0.9, 0.999, 1.001, 1.1, 1.9, 3.9}) {
    for (const double power : {0.1, 0.7, 3.0}) {
      INFO("limit " << limit << ", power " << power);
      const auto [c, loads] =
          search([&](double f) { return kLeast * std::pow(limit / f, power); }, 1e9);
      CHECK(c.good.factor <= limit);
      CHECK(c.bad.factor >= limit);
      CHECK(c.bad.factor / c.good.factor <= plan.width * (1.0 + 1e-12));
      CHECK(loads <= 7);
      // Linear between the last two: the curve's second derivative over their distance, with a
      // power of 3 and 9 %: 3/8 (ln 1.09)^2 = 0.3 %.
      CHECK(load_met(c.limit, c.good, c.bad, kLeast, 1e3) == Approx(limit).epsilon(3e-3));
    }
    const auto [c, loads] = search([](double) { return 1e-6; }, limit);
    CHECK(c.good.factor < limit);
    CHECK(c.bad.factor >= limit);
    CHECK(c.bad.factor / c.good.factor <= plan.width);
    CHECK(loads <= 8);
  }
  const auto [always, few] = search([](double) { return 1e-6; }, 1e9);
  CHECK(always.good.factor == plan.factors[1]);
  CHECK(always.bad.factor == 0.0);
  CHECK(few == 4);
  const auto [never, also] = search([](double) { return 0.1e-6; }, 1e9);
  CHECK(never.bad.factor == plan.factors[0]);
  CHECK(never.good.factor == 0.0);
  CHECK(also == 4);
}

TEST_CASE("AtTheHardestInstantShearTimesSpeedIsTheFrictionOfTheBore", "[shells]") {
  ShellCycle c;
  c.input = shipped(shell_kinds()[0]);
  for (const double p : {40e6, 90e6, 60e6}) {
    bearing::CycleInstant i;
    i.t = 1e-9 * p;
    i.p_max = p;
    i.p_asperity_max = 1e6;
    i.omega = 200.0;
    i.torque = 1.5e-8 * p;
    i.torque_asperity = 0.1 * i.torque;
    c.result.instants.push_back(i);
  }
  const HardestInstant at = hardest_instant(c);
  CHECK(at.pressure == Approx(91e6));
  const double R = c.input.bearing.radius;
  CHECK((at.tau_film + at.tau_asperity) * 200.0 * R == Approx(at.friction).epsilon(1e-12));
  const double area = 2.0 * kPi * R * c.input.bearing.width;
  CHECK(at.friction * area == Approx(1.35 * 200.0).epsilon(1e-12));
}

TEST_CASE("TheRunInShellIsTheOneWhoseCapabilityIsSought", "[shells]") {
  // The table of its wear, read as a shape by a bearing that is solved from nothing, has the film
  // that running-in ended with. 0.2 %: a fifth of the error of the steps in time, which are others.
  ShellsPlan plan = shells_plan(true);
  plan.coarse = {32, 5};
  const StudyOptions options;
  StudyCrew crew(options);
  const RunInShell shell = run_shell_in(plan, crew, 0, 0, bearing::Tier::isothermal);
  REQUIRE(shell.good());
  CHECK(shell.end.t == Approx(*shipped(shell_kinds()[0]).running_in->duration));
  CHECK(shell.end.depth > 0.0);
  CHECK(shell.end.p_asperity_max < shell.begin.p_asperity_max);
  bearing::Case c = shell_case(0, bearing::Tier::isothermal, {plan.coarse});
  c.bearing.shape = shell.wear;
  const bearing::CycleResult worn = bearing::solve_cycle(c, bearing::Tier::isothermal);
  REQUIRE(worn.verdict.good());
  CHECK(bearing::value_of(worn, "h_min") == Approx(shell.end.h_min).epsilon(0.002));
  CHECK(std::abs(shell.end.h_min - shell.begin.h_min) > 0.01 * shell.begin.h_min);
}

TEST_CASE("ThePageSaysOfEachRatioWhatItsBarsAllow", "[shells]") {
  // Plain 100 W, grooved 94, polymer 100; the paper has 0.94 and 0.70.
  ShellsStudy study;
  study.plan = shells_plan(true);
  const auto page_with = [&](double bar) {
    for (int k = 0; k < kShells; ++k) {
      ShellCycle& c = study.cycles[k][0];
      c.input = shipped(shell_kinds()[k]);
      c.tried = true;
      c.film_power = k == 1 ? 94.0 : 100.0;
      bearing::CycleQuantity torque{{"friction_torque", 0.5, "N m"}};
      torque.quantity.error_grid = 0.5 * bar;
      torque.quantity.error_time = 0.0;
      c.result.quantities = {torque};
    }
    return shells_page(study);
  };
  const auto has = [](const std::string& page, const char* words) {
    return page.find(words) != std::string::npos;
  };
  // Bars of 10 %: the worst of both is (1 + 0.1)/(1 - 0.1) - 1 = 0.22 of a ratio.
  const std::string wide = page_with(0.1);
  CHECK(has(wide, "polymer: 1.00 &plusmn;0.22 of the plain shell, from which these cells cannot"));
  CHECK(has(wide, "the paper's 0.94 is within the bar"));
  CHECK(has(wide, "the paper's 0.70 is <strong>not reproduced"));
  // Of 1 %: 0.0202; the grooved shell is told apart.
  const std::string narrow = page_with(0.01);
  CHECK(has(narrow, "AlSn, grooved: 0.94 &plusmn;0.019 of the plain shell; the paper's 0.94 is"));
  CHECK(has(page_with(NAN), "no bar is known"));
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
  // What was not run is not told as not found: the words stand over the list of failures alone.
  CHECK(page.find("not found") == std::string::npos);
  CHECK(page.find("Quick study") != std::string::npos);
  CHECK(page.find(">nan") == std::string::npos);
  CHECK(shells_json(study).find("\"interrupted\"") != std::string::npos);
}
