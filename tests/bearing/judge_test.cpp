/// A case filled by hand is refused for the same reasons as one from a file.
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "bearing/judge/judge_case.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Key of the first refusal after `change`; empty if there is none.
template <class Change>
Finding refusal(Case c, Change change) {
  change(c);
  for (const Finding& f : judge(c)) {
    if (f.refused()) return f;
  }
  return {Gravity::unusual, "", "", ""};
}

}  // namespace

TEST_CASE("TheCasesOfTheTestsAreSolvable") {
  for (const Case& c : {plain_case(), warm_case(), rig_case(), grooved_case()}) {
    INFO(c.title);
    CHECK_NOTHROW(expect_solvable(c));
  }
}

TEST_CASE("AnEmptyCaseIsRefusedAtEachValueThatItLacks") {
  std::set<std::string> keys;
  for (const Finding& f : judge(Case{})) keys.insert(f.key);
  for (const char* key : {"bearing.diameter", "bearing.width", "bearing.radial_clearance",
                          "operation.load", "supply"}) {
    INFO(key);
    CHECK(keys.count(key) == 1);
  }
}

TEST_CASE("AWallOfAnotherUnitIsTold") {
  const auto told = [](auto change) {
    Case c = rig_case();
    c.shell->back = ConvectiveBack{500.0, 363.15};
    const std::size_t before = judge(c).size();
    change(c);
    const auto after = judge(c);
    REQUIRE(after.size() == before + 1);
    CHECK_FALSE(after.back().refused());
  };
  told([](Case& c) { c.shell->back = ConvectiveBack{5e5, 363.15}; });  // kW
  told([](Case& c) { c.shell->end_heat_transfer = 5e5; });
  told([](Case& c) { c.shaft->material.conductivity = 0.05; });  // per millimetre
  told([](Case& c) { c.shaft->material.expansion = 1.1e-8; });   // 1e-9 for 1e-6
  told([](Case& c) { c.shell->housing->joint_conductance = 1e-3; });
  told([](Case& c) { c.shell->housing->outer_radius = 17.0 * c.bearing.radius; });
  Case still = rig_case();  // what does not expand is no unit's slip
  const std::size_t before = judge(still).size();
  still.shaft->material.expansion = 0.0;
  CHECK(judge(still).size() == before);
}

TEST_CASE("AValueThatCannotBeComputedWithIsRefusedByItsKey") {
  const Case c = rig_case();
  const auto key = [&](auto change) { return refusal(c, change).key; };
  CHECK(key([](Case& x) { x.bearing.radius = -x.bearing.radius; }) == "bearing.diameter");
  CHECK(key([](Case& x) { x.bearing.width = kNan; }) == "bearing.width");
  CHECK(key([](Case& x) { x.operation.omega = INFINITY; }) == "operation.speed");
  CHECK(key([](Case& x) { set_load(x, 0.0); }) == "operation.load");
  CHECK(key([](Case& x) { place_journal(x, 101.0, 0.5); }) == "operation.eccentricity_ratio");
  CHECK(key([](Case& x) {
          place_journal(x, 1.0, 0.5);
          x.model.switches.elastic_deformation = false;
        }) == "operation.eccentricity_ratio");
  CHECK(key([](Case& x) { x.supplies[0].temperature = 95.0; }) == "supply.0.temperature");
  CHECK(key([](Case& x) { x.supplies[0].pressure = -2e5; }) == "supply.0.pressure");
  CHECK(key([](Case& x) { x.supplies[0].diameter = 0.0; }) == "supply.0.diameter");
  CHECK(key([](Case& x) { std::get<rheology::Cross>(x.oil.shear).r = 2.0; }) ==
        "oil.viscosity.shear.r");
  CHECK(key([](Case& x) { x.shell->layers.clear(); }) == "shell.layers");
  CHECK(key([](Case& x) { x.shell->layers[1].material.poisson_ratio = 0.5; }) ==
        "shell.layers.1.material.poisson_ratio");
  CHECK(key([](Case& x) { x.surfaces.contact->friction = -0.1; }) == "surfaces.contact.friction");
  CHECK(key([](Case& x) { x.model.grid = {100, 0}; }) == "model.grid");
  CHECK(key([](Case& x) { x.model.film_nodes = 99; }) == "model.film_nodes");
  CHECK(key([](Case& x) {
          x.bearing.profile = Profile{{0.0, 1.0}, {0.0}, {1e-6}};
        }) == "bearing.profile");
  CHECK(key([](Case& x) {
          x.bearing.profile = Profile{{1.0, 0.0}, {0.0}, {0.0, 0.0}};
        }) == "bearing.profile");
}

TEST_CASE("SurfacesThatGiveWayLetTheJournalPassItsClearance") {
  Case c = rig_case();
  place_journal(c, 1.0, 0.5);
  CHECK_NOTHROW(expect_solvable(c));
  CHECK_FALSE(lack_for(c, Tier::tehd));
  CHECK(lack_for(c, Tier::thd)->key == "operation.eccentricity_ratio");
  CHECK(lack_for(c, Tier::estimate)->key == "operation.eccentricity_ratio");
  // A bore that is wider by its shape is the same as one of that clearance.
  Profile wider;
  wider.phi = {0.0};
  wider.z = {0.0};
  wider.height = {c.bearing.radial_clearance};
  c.bearing.shape = wider;
  place_journal(c, 1.9, 0.5);
  CHECK_FALSE(lack_for(c, Tier::isothermal));
  place_journal(c, 2.1, 0.5);
  CHECK(lack_for(c, Tier::isothermal)->key == "operation.eccentricity_ratio");
}

TEST_CASE("ALayerThatItsLoadCompressesBeyondSmallStrainsIsToldOrRefused") {
  // Strain under the load over its projected area, 9.73 MPa: p (1 + nu)(1 - 2 nu)/(E (1 - nu)).
  Case c = rig_case();
  solid::Material& lining = c.shell->layers[0].material;
  lining.poisson_ratio = 0.4;
  c.surfaces.contact.reset();
  const double p = 8e3 / (2.0 * c.bearing.radius * c.bearing.width);
  const double per_modulus = p * 1.4 * 0.2 / 0.6;
  const auto said = [&](double strain) {
    lining.youngs_modulus = per_modulus / strain;
    for (const Finding& f : judge(c)) {
      if (f.key == "shell.layers.0.material") return f.refused() ? 2 : 1;
    }
    return 0;
  };
  CHECK(said(0.099) == 0);
  CHECK(said(0.101) == 1);
  CHECK(said(0.501) == 2);
  c.model.switches.elastic_deformation = false;  // rigid surfaces have no strain
  CHECK(said(0.501) == 0);
}

TEST_CASE("ACompositeModulusOfOtherMaterialsIsTold") {
  Case c = rig_case();
  const auto told = [&] {
    for (const Finding& f : judge(c)) {
      if (f.key == "surfaces.contact.composite_modulus") return !f.refused();
    }
    return false;
  };
  CHECK_FALSE(told());
  const solid::Material& a = c.shell->layers[0].material;
  const solid::Material& b = c.shaft->material;
  const double of_materials = 1.0 / ((1.0 - a.poisson_ratio * a.poisson_ratio) / a.youngs_modulus +
                                     (1.0 - b.poisson_ratio * b.poisson_ratio) / b.youngs_modulus);
  for (const double apart : {1.49, 1.0 / 1.49}) {
    c.surfaces.contact->composite_modulus = apart * of_materials;
    CHECK_FALSE(told());
  }
  for (const double apart : {1.51, 1.0 / 1.51}) {
    c.surfaces.contact->composite_modulus = apart * of_materials;
    CHECK(told());
  }
}

TEST_CASE("GeometryThatCannotExistIsRefusedWithNumbersAndCure") {
  const Finding f = refusal(plain_case(), [](Case& c) { c.bearing.radial_clearance = 0.03; });
  CHECK(f.key == "bearing.radial_clearance");
  CHECK(f.problem.find("1.2 of the radius (30 mm of 25 mm)") != std::string::npos);
  CHECK(f.cure.find("diametral") != std::string::npos);
  CHECK(refusal(rig_case(), [](Case& c) { c.supplies[0].diameter = 0.02; }).problem ==
        "20 mm is more than the bearing's width of 17.2 mm");
}

TEST_CASE("WhatATierLacksIsRefusedInThatTierOnly") {
  Case c = plain_case();
  CHECK(judge(c, {Tier::isothermal}).empty());
  const auto lack = lack_for(c, Tier::tehd);
  REQUIRE(lack);
  CHECK(lack->key == "shell");
  CHECK(possible_tiers(c) == std::vector{Tier::isothermal, Tier::lumped});
  CHECK(possible_tiers(rig_case()).size() == 4);
  c.model.tier = Tier::thd;
  CHECK_THROWS_WITH(expect_solvable(c), Catch::Contains("shell: the tier thd") &&
                                            Catch::Contains("give its layers and back"));
}

TEST_CASE("AMomentAtAGivenPlaceIsRefused") {
  Case c = plain_case();
  c.operation.alignment = MomentGiven{1.0, 0.0};
  CHECK(judge(c).empty());
  place_journal(c, 0.5, 0.5);
  const auto found = judge(c);
  REQUIRE(found.size() == 1);
  CHECK(found[0].key == "operation.moment");
  CHECK(found[0].cure.find("operation.tilt") != std::string::npos);
}

TEST_CASE("WhatContradictsTheRestOfTheCaseIsTold") {
  const auto keys = [](const Case& c) {
    std::vector<std::string> all;
    for (const Finding& f : judge(c)) {
      CHECK_FALSE(f.refused());
      all.push_back(f.key);
    }
    return all;
  };
  Case c = rig_case();
  REQUIRE(keys(c).empty());
  c.measured.shell_back_temperature = c.supplies[0].temperature - 5.0;
  CHECK(keys(c) == std::vector<std::string>{"measured.shell_back_temperature"});
  c.model.kappa = 0.0;
  CHECK(keys(c).empty());
  Case sharp = rig_case();
  sharp.surfaces.shell.summit_roughness = 2.0 * sharp.surfaces.shell.roughness;
  CHECK(keys(sharp) == std::vector<std::string>{"surfaces.shell.summit_roughness"});
  sharp.surfaces.shell.summit_roughness = 6.0 * sharp.surfaces.shell.roughness;
  CHECK(refusal(sharp, [](Case&) {}).key == "surfaces.shell.summit_roughness");
  Case bent = rig_case();
  bent.shaft->span = 0.1;
  bent.model.tier = Tier::isothermal;  // of rigid surfaces
  CHECK(keys(bent) == std::vector<std::string>{"shaft.span"});
  bent.model.switches.elastic_deformation = true;
  CHECK(keys(bent).empty());
}

TEST_CASE("OnlyABearingWithShellAndShaftIsElastic") {
  Case c = rig_case();
  CHECK(can_be_elastic(c));
  c.model.switches.elastic_deformation = true;
  CHECK_FALSE(lack_for(c, Tier::isothermal));
  c.shaft.reset();
  CHECK_FALSE(can_be_elastic(c));
  const auto lack = lack_for(c, Tier::isothermal);
  REQUIRE(lack);
  CHECK_THAT(lack->problem, Catch::Contains("no [shaft] to deform"));
}

TEST_CASE("TheEstimateIsRefusedSuppliesThatItDoesNotSee") {
  Case c = plain_case();
  CHECK_FALSE(lack_for(c, Tier::estimate));
  const auto why = [](const Case& changed) {
    const auto lack = lack_for(changed, Tier::estimate);
    return lack ? lack->problem : std::string();
  };
  Case warm = c;
  warm.supplies.push_back(c.supplies[0]);
  warm.supplies[1].angle = 180.0 * kDegree;
  CHECK(why(warm).empty());
  warm.supplies[1].temperature += 1.0;
  CHECK_THAT(why(warm), Catch::Contains("different temperature"));
  Case ring = c;
  ring.supplies[0].kind = SupplyKind::circumferential_groove;
  ring.supplies[0].arc = 2.0 * kPi;
  ring.supplies[0].length = 2e-3;
  CHECK(why(ring).empty());
  ring.supplies[0].z = 5e-3;
  CHECK_THAT(why(ring), Catch::Contains("at mid-width"));
  Case placed = hole_case();
  place_journal(placed, 0.6, 40.0 * kDegree);
  placed.supplies[0].angle = 270.0 * kDegree;  // the load line, if one were given
  CHECK_THAT(why(placed), Catch::Contains("in the film that carries it"));
  placed.supplies[0].angle = 90.0 * kDegree;
  CHECK(why(placed).empty());
  // A hole that the oil passes 65 degrees ahead of the load, one that it passes after it.
  for (const auto& [away, taken] :
       {std::pair{-65.0, false}, {-75.0, true}, {75.0, false}, {155.0, true}}) {
    for (const double turn : {1.0, -1.0}) {
      Case near = hole_case();
      near.operation.omega *= turn;
      near.supplies[0].angle = (270.0 + turn * away) * kDegree;
      near.supplies[0].diameter = 1e-4;
      INFO(away << " deg behind the load, turning by " << turn);
      CHECK(why(near).empty() == taken);
    }
  }
}

TEST_CASE("TheEstimateIsRefusedJournalsThatAreNotAlignedInACylinder") {
  // A hundredth of the clearance is within its bars; the load's own arm for a moment.
  const auto refused = [](const auto& change) {
    Case c = plain_case();
    change(c);
    return lack_for(c, Tier::estimate).has_value();
  };
  const Case plain = plain_case();
  const double clearance = plain.bearing.radial_clearance;
  const double force = std::get<LoadGiven>(plain.operation.position).force;
  const Profile bump{{0.0, kPi}, {0.0}, {0.0, 1.0}};
  for (const auto& [part, taken] : {std::pair{0.009, true}, {0.011, false}}) {
    INFO(part << " of the clearance");
    const double off = part * clearance;
    for (const auto where : {&Bearing::profile, &Bearing::shape, &Bearing::wear}) {
      Profile p = bump;
      for (double& h : p.height) h = -off * h;
      CHECK(refused([&](Case& c) { c.bearing.*where = p; }) == !taken);
    }
    for (const auto where : {&Bearing::edge_relief, &Bearing::chamfer}) {
      CHECK(refused([&](Case& c) { c.bearing.*where = EdgeOpening{off, 1e-3}; }) == !taken);
    }
    const double tilt = off / (0.5 * plain.bearing.width);
    CHECK(refused([&](Case& c) {
            c.operation.alignment = TiltGiven{0.6 * tilt, -0.8 * tilt};
          }) == !taken);
    const double moment = part * force * plain.bearing.width;
    CHECK(refused([&](Case& c) { c.operation.alignment = MomentGiven{0.0, moment}; }) == !taken);
  }
}

TEST_CASE("OverACycleTheEstimateIsRefusedWhatLastsForATurn") {
  // A hole 20 degrees behind a load that stands for a turn and a half and for three quarters of
  // one, wherever the table begins.
  const auto why = [](double turns, int first) {
    Case c = hole_case();
    c.supplies[0].angle = 290.0 * kDegree;
    LoadCycle cycle;
    cycle.period = 4.0 * kPi / c.operation.omega;  // two turns
    constexpr int kRows = 80;
    for (int k = 0; k < kRows; ++k) {
      const int row = (k + first) % kRows;
      const bool stands = row < 40 * turns;
      const double angle = stands ? 270.0 : 90.0;
      cycle.t.push_back(cycle.period * k / kRows);
      cycle.x.push_back(2e3 * std::cos(angle * kDegree));
      cycle.y.push_back(2e3 * std::sin(angle * kDegree));
    }
    c.cycle = cycle;
    const auto lack = lack_for(c, Tier::estimate);
    return lack ? lack->problem : std::string();
  };
  for (const int first : {0, 30, 70}) {
    CHECK_THAT(why(1.5, first), Catch::Contains("in the film that carries it"));
    CHECK(why(0.5, first).empty());
  }
}

TEST_CASE("AGridThatDoesNotHoldTheSuppliesIsRefusedWithOneThatDoes") {
  Case c = grooved_case();
  Supply longer = c.supplies[0];
  longer.angle = 180.0 * kDegree;
  longer.length = 0.06;
  c.supplies[0].length = 0.03;
  c.supplies.push_back(longer);
  expect_solvable(c);
  c.model.grid = {40, 3};
  CHECK_THROWS_WITH(expect_solvable(c), Catch::Contains("model.grid: 40 x 3 cells cannot have") &&
                                            Catch::Contains("take "));
  c.model.grid = {100, 7};  // 50 x 4, the coarser one, does not
  expect_solvable(c);
  CHECK(solve_tier(c, Tier::isothermal).verdict.good());
}

TEST_CASE("PossibleButUnusualInputIsToldAndNotRefused") {
  Case c = plain_case();
  c.bearing.radial_clearance = 3e-6;
  const auto findings = judge(c);
  REQUIRE(findings.size() == 1);
  CHECK_FALSE(findings[0].refused());
  CHECK(findings[0].key == "bearing.radial_clearance");
  CHECK_NOTHROW(expect_solvable(c));
}

TEST_CASE("AShapeMuchDeeperThanTheClearanceIsTold") {
  Case c = plain_case();
  const double clearance = c.bearing.radial_clearance;
  const auto told = [&] {
    std::string keys;
    for (const Finding& f : judge(c)) keys += (f.refused() ? "!" : "") + f.key + " ";
    return keys;
  };
  for (const double times : {9.9, 10.1}) {
    c.bearing.shape = Profile{{0.0}, {0.0}, {times * clearance}};
    CHECK(told() == (times > 10.0 ? "bearing.shape " : ""));
    c.bearing.shape.reset();
    c.bearing.profile = Profile{{0.0, 1.0}, {0.0}, {0.0, times * clearance}};
    CHECK(told() == (times > 10.0 ? "bearing.profile " : ""));
    c.bearing.profile.reset();
    c.bearing.edge_relief = EdgeOpening{times * clearance, 1e-3};
    CHECK(told() == (times > 10.0 ? "bearing.edge_relief.depth " : ""));
    c.bearing.edge_relief.reset();
    c.bearing.chamfer = EdgeOpening{times * clearance, 1e-3};
    CHECK(told().empty());
    c.bearing.chamfer.reset();
  }
}

TEST_CASE("ABoreMeasuredOverAPartOfItsTurnOrAtAFewAnglesIsTold") {
  Case c = plain_case();
  // A lemon at `count` angles from 0 on, `step` degrees apart, with one edge opened.
  const auto lemon = [&](int count, double step) {
    Profile p{{}, {-0.5 * c.bearing.width, 0.5 * c.bearing.width}, {}};
    for (int i = 0; i < count; ++i) {
      p.phi.push_back(i * step * kPi / 180.0);
      const double h = 10e-6 * (1.0 - std::cos(2.0 * p.phi.back()));
      p.height.insert(p.height.end(), {h, 0.5 * h});
    }
    return p;
  };
  const auto told = [&](Profile p) {
    c.bearing.shape = std::move(p);
    std::string words;
    for (const Finding& f : judge(c)) {
      if (f.key == "bearing.shape") words += (f.refused() ? "!" : "") + f.problem + " ";
    }
    return words;
  };
  CHECK(told(lemon(72, 5.0)).empty());
  CHECK(told(lemon(12, 30.0)).empty());
  // the part from 145 deg on is a line of 215 deg, 43 times as long as the others
  CHECK(told(lemon(30, 5.0)).starts_with("!from 145 deg on no height is given for 215 deg, 43 "));
  CHECK(told(lemon(66, 5.0)).starts_with("from 325 deg on no height is given for 35 deg, 7 times"));
  CHECK(told(lemon(68, 5.0)).empty());  // 25 deg: a line misses no lobe, however fine the rest
  CHECK(told(lemon(3589, 0.1)).empty());
  CHECK(told(lemon(20, 2.0)).starts_with("from 38 deg on"));  // few angles: lines may be meant
  CHECK(told(lemon(4, 90.0)).starts_with("heights are given at 4 angles"));
  // ends that are alike beside heights that are not: told, a half bore may be meant so
  CHECK(told(lemon(37, 5.0)).starts_with("from 180 deg on no height is given for 180 deg"));
  Profile radians = lemon(72, 5.0);
  for (double& phi : radians.phi) phi *= kPi / 180.0;
  CHECK(told(radians).starts_with("!all 72 angles lie within 6.196 deg"));
  // nothing where the heights at both ends say that they stay, nor where they never vary
  Profile flat = lemon(30, 5.0);
  flat.height.assign(flat.height.size(), 3e-6);
  flat.height[20] = 4e-6;
  flat.height[0] = 3.02e-6;  // within what is measured
  CHECK(told(flat).empty());
  CHECK(told({{0.0, 1.0}, {0.0}, {2e-6, 2e-6}}).empty());
}

TEST_CASE("ATableOfTheBoreCountsItsWidthFromTheMiddle") {
  Case c = plain_case();
  const double edge = 0.5 * c.bearing.width;
  const auto told = [&](std::vector<double> z) {
    const std::vector<double> heights(2 * z.size(), 1e-6);
    std::string keys;
    for (auto* table : {&c.bearing.shape, &c.bearing.profile}) {
      *table = Profile{{0.0, 1.0}, z, heights};
      for (const Finding& f : judge(c)) keys += (f.refused() ? "!" : "") + f.key + " ";
      table->reset();
    }
    return keys;
  };
  CHECK(told({-edge, 0.0, edge}).empty());
  CHECK(told({-edge * (1.0 + 1e-6), edge}).empty());  // printed with six digits
  CHECK(told({0.0}).empty());                         // the same over the width
  CHECK(told({0.0, edge, 2.0 * edge}) == "!bearing.shape !bearing.profile ");  // from one edge
  CHECK(told({-edge * 1e3, 0.0, edge * 1e3}) == "!bearing.shape !bearing.profile ");  // m for mm
  CHECK(told({-edge, -0.5 * edge}) == "bearing.shape bearing.profile ");  // it goes on for long
  CHECK(told({-0.9 * edge, 0.0, 0.9 * edge}).empty());                    // cells' middles
}

TEST_CASE("SummitsThatNoSurfaceHasAreToldOrRefused") {
  const auto key = [](auto change) { return refusal(rig_case(), change).key; };
  CHECK(key([](Case& c) { c.surfaces.shell.summit_height = 25e-6; }) ==
        "surfaces.shell.summit_height");
  CHECK(key([](Case& c) { c.surfaces.contact->elastic_factor = 10.0; }) ==
        "surfaces.contact.elastic_factor");
  Case c = rig_case();
  CHECK(judge(c).empty());
  c.surfaces.shaft.summit_roughness = 0.0;
  const auto findings = judge(c);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].key == "surfaces.shaft.summit_roughness");
  CHECK_FALSE(findings[0].refused());
}

TEST_CASE("AWornInShapeIsNotHarderThanTheShell") {
  Case c = rig_case();
  c.running_in = RunningIn{1e-8, 350e6, {}, 5e6, {}, 0.0};
  CHECK(refusal(c, [](Case&) {}).key.empty());
  CHECK(refusal(c, [](Case& x) { x.running_in->limit_pressure = 351e6; }).key ==
        "running_in.limit_pressure");
  // Contact pressure ends at the hardness given to the contact: a limit above it is never met.
  c.surfaces.contact->hardness = 10e6;
  CHECK(refusal(c, [](Case&) {}).key.empty());
  CHECK(refusal(c, [](Case& x) { x.running_in->limit_pressure = 11e6; }).key ==
        "running_in.limit_pressure");
  c.running_in->duration = 200.0;
  CHECK(refusal(c, [](Case& x) { x.running_in->limit_pressure = 11e6; }).key ==
        "running_in.limit_pressure");
}

TEST_CASE("ConstantsThatMakeNoOilAreSeenByTheirViscosity") {
  Case c = plain_case();
  const auto with = [&](double A) {
    Case x = c;
    x.oil.temperature = rheology::Vogel{A, 900.0, 100.0};
    for (const Finding& f : judge(x, {Tier::isothermal})) {
      if (f.key == "oil.viscosity.temperature") return f.refused() ? 2 : 1;
    }
    return 0;
  };
  const double T = c.supplies[0].temperature - 273.15;
  const double A = 0.03 / std::exp(900.0 / (100.0 + T));  // 30 mPa s as it comes
  CHECK(with(A) == 0);
  CHECK(with(1e3 * A) == 1);  // mPa s for Pa s: told
  CHECK(with(1e6 * A) == 2);  // stiffer than pitch
}

TEST_CASE("ConstantsOfPressureAndShearThatMakeNoOilAreSeen") {
  using rheology::Barus, rheology::Cross, rheology::Houpert, rheology::Oil, rheology::Roelands;
  const auto seen = [](const std::string& key, const auto& change) {
    Case c = warm_case();
    change(c.oil);
    for (const Finding& f : judge(c)) {
      if (f.key == key) return f.refused() ? 2 : 1;
    }
    return 0;
  };
  const std::string pressure = "oil.viscosity.pressure", shear = "oil.viscosity.shear.K";
  CHECK(seen(pressure, [](Oil& o) { o.pressure = Barus{2e-8}; }) == 0);
  CHECK(seen(pressure, [](Oil& o) { o.pressure = Barus{9.5}; }) == 2);  // 1/GPa, as 1/Pa
  CHECK(seen(pressure, [](Oil& o) { o.pressure = Barus{9.5e-15}; }) == 1);
  CHECK(seen(pressure, [](Oil& o) { o.pressure = Roelands{0.6}; }) == 0);
  CHECK(seen(pressure, [](Oil& o) { o.pressure = Roelands{60.0}; }) == 2);
  CHECK(seen(pressure + ".beta", [](Oil& o) { o.pressure = Houpert{0.6, 34.0, 313.15}; }) == 2);
  CHECK(seen(shear, [](Oil& o) { o.shear = Cross{0.5, 4.5e-8, 0.5}; }) == 0);
  CHECK(seen(shear, [](Oil& o) { o.shear = Cross{0.5, 1e-2, 0.5}; }) == 1);
  CHECK(seen(shear, [](Oil& o) { o.shear = Cross{0.5, 4.5e8, 0.5}; }) == 2);  // a sign forgotten
}

TEST_CASE("ALayerThinnerThanCoatingsAreIsToldAndThinnerThanAtomsRefused") {
  Case c = rig_case();
  const auto told = [&](double thickness) {
    c.shell->layers[0].thickness = thickness;
    std::string keys;
    for (const Finding& f : judge(c)) keys += (f.refused() ? "!" : "") + f.key;
    return keys;
  };
  CHECK(told(1e-6).empty());
  CHECK(told(5e-8) == "shell.layers.0.thickness");
  CHECK(told(5e-10) == "!shell.layers.0.thickness");
}

TEST_CASE("AHoleIsJudgedByItsDiameterAlone") {
  // Arc and length, which a reader fills in, are not asked of who fills a case by hand.
  Case c = rig_case();
  c.supplies.push_back(c.supplies[0]);
  c.supplies[1].angle = c.supplies[0].angle - 2.0 * kPi;
  const auto findings = judge(c);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].problem == "it overlaps supply.0");
  CHECK(findings[0].refused());
  // circles that pass each other do not overlap, though the squares round them do
  const double reach = c.supplies[0].diameter / c.bearing.radius;
  c.supplies[0].z = 0.4 * c.supplies[0].diameter;
  c.supplies[1].z = -c.supplies[0].z;
  c.supplies[1].angle = c.supplies[0].angle + 0.7 * reach;
  CHECK(judge(c).empty());
  c.supplies[1].angle = c.supplies[0].angle + 0.5 * reach;
  CHECK(judge(c).size() == 1);
}

TEST_CASE("CellsAlongTheAxisAreCountedAsTheyAreSolved") {
  Case c = rig_case();
  c.model.grid = {48, 256};  // half of them: the bearing is symmetric
  CHECK(judge(c).empty());
  c.model.grid[1] = 257;
  CHECK(refusal(c, [](Case&) {}).key == "model.grid");
  c.model.grid[1] = 128;
  c.operation.alignment = TiltGiven{1e-5, 0.0};
  CHECK(judge(c).empty());
  c.model.grid[1] = 129;
  CHECK(refusal(c, [](Case&) {}).key == "model.grid");
}

TEST_CASE("ALineThatEndsInTheFilmIsTold") {
  const auto keys = [](double part, double arc) {
    Case c = plain_case();
    c.supplies[0].length = part * c.bearing.width;
    c.supplies[0].arc = arc;
    std::vector<std::string> all;
    for (const Finding& f : judge(c)) all.push_back(f.key);
    return all;
  };
  CHECK(keys(1.0, 0.0).empty());  // from edge to edge there is nothing to flow round
  CHECK(keys(0.8, 0.0) == std::vector<std::string>{"supply.0.arc"});
  CHECK(keys(0.8, 20.0 * kDegree).empty());
}

TEST_CASE("AGrooveWhereTheLoadPressesIsTold") {
  Case c = plain_case();
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.02;
  c.supplies[0].pressure = 1e5;
  const double specific = 2e3 / (2.0 * c.bearing.radius * c.bearing.width);
  const auto told = [&](double angle, double pressure) {
    c.supplies[0].angle = angle;
    c.supplies[0].pressure = pressure;
    int n = 0;
    for (const Finding& f : judge(c)) n += f.key == "supply.0.angle" ? 1 : 0;
    return n;
  };
  CHECK(told(90.0 * kDegree, 1e5) == 0);
  CHECK(told(270.0 * kDegree, 1e5) == 1);
  CHECK(told(-81.0 * kDegree, 1e5) == 1);              // within half its arc
  CHECK(told(281.0 * kDegree, 1e5) == 0);              // beside the line
  CHECK(told(270.0 * kDegree, 1.01 * specific) == 0);  // it carries the load itself
  c.supplies[0].length = 0.4 * c.bearing.width;        // film is left on both sides
  CHECK(told(270.0 * kDegree, 1e5) == 0);
}

TEST_CASE("AGrooveAsWideAsTheBearingHasThePressureOfItsSides") {
  Case c = plain_case();
  Supply& groove = c.supplies[0];
  groove.arc = 30.0 * kDegree;
  groove.angle = 180.0 * kDegree;
  groove.length = c.bearing.width;
  groove.pressure = 2e5;
  CHECK_THROWS_AS(expect_solvable(c), InputError);  // it cannot hold that
  groove.pressure = 0.0;
  CHECK_NOTHROW(expect_solvable(c));
  // The limit of one that leaves ever narrower lands.
  c.model.grid = {96, 25};
  const auto flow = [&](double part) {
    c.supplies[0].length = part * c.bearing.width;
    const Solution s = solve_tier(c, Tier::isothermal);
    REQUIRE(s.verdict.good());
    return summarize(s, Tier::isothermal).value("side_flow");
  };
  const double open = flow(1.0), near = flow(0.99), far = flow(0.96);
  CHECK(near == Approx(open).epsilon(0.02));
  CHECK(std::abs(open - near) < 0.6 * std::abs(open - far));
}
