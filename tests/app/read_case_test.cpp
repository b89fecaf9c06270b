/// A case file's words become SI numbers, and what was relied on goes on record.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/init.hpp"
#include "app/reading/library.hpp"
#include "bearing/judge/judge_case.hpp"
#include "core/constants.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

// One or two multiplications by a decimal factor: some units in the last place.
constexpr double kRounding = 1e-14;

Approx near(double value) { return Approx(value).epsilon(kRounding); }

bool holds(const std::vector<std::string>& list, const std::string& part) {
  return std::any_of(list.begin(), list.end(), [&](const std::string& entry) {
    return entry.find(part) != std::string::npos;
  });
}

const std::string kHole = "kind = \"hole\"\nangle = \"90 deg\"\ndiameter = \"5 mm\"";

}  // namespace

TEST_CASE("ValuesArriveInSI") {
  const auto c = read_case_text(kSampleCase, "case.toml");
  CHECK(c.title == "sample");
  CHECK(c.path == "case.toml");
  CHECK(c.verbatim == kSampleCase);
  CHECK(c.bearing.radius == near(0.025));
  CHECK(c.bearing.width == near(0.025));
  CHECK(c.bearing.radial_clearance == near(25e-6));
  CHECK(c.bearing.reference_temperature == near(293.15));
  CHECK(c.operation.omega == near(100.0 * kPi));
  const auto load = std::get<bearing::LoadGiven>(c.operation.position);
  CHECK(load.force == near(5000.0));
  CHECK(load.angle == near(1.5 * kPi));
  REQUIRE(c.supplies.size() == 1);
  CHECK(c.supplies[0].pressure == near(2e5));
  CHECK(c.supplies[0].temperature == near(353.15));
  CHECK(c.oil_temperature == near(363.15));
  const auto vogel = std::get<rheology::Vogel>(c.oil.temperature);
  CHECK(vogel.A == near(0.0952e-3));
  CHECK(vogel.B == near(896.4));
  CHECK(vogel.C == near(110.0));
  CHECK(std::get<rheology::Barus>(c.oil.pressure).alpha == near(9.5e-9));
  CHECK(std::get<rheology::Cross>(c.oil.shear).K == near(4.5e-8));
  CHECK(c.oil.range.T_min == near(293.15));
  CHECK(c.oil.range.p_max == near(2e8));
  CHECK(c.oil.range.rate_max == near(1e7));
  REQUIRE(c.shell);
  CHECK(c.shell->layers.at(0).thickness == near(0.002));
  CHECK(c.shell->layers[0].material.youngs_modulus == near(200e9));
  CHECK(std::get<bearing::ConvectiveBack>(c.shell->back).heat_transfer == near(500.0));
  CHECK(c.model.tier == bearing::Tier::tehd);
  CHECK(c.warnings.empty());
}

TEST_CASE("DefaultsGoOnRecord") {
  const auto c = read_case_text(kSampleCase, "case.toml");
  for (const char* part : {"200 x 25", "20 degC", "1 mm", "carry_over = 1", "smooth", "270 deg",
                           "cavitate at ambient", "50 W/(m2 K)"}) {
    INFO(part);
    CHECK(holds(c.assumptions, part));
  }
  CHECK(c.model.grid == std::array<int, 2>{200, 25});
  CHECK(c.supplies[0].depth == near(1e-3));
  // Nothing draws oil in at the edges of a film that cavitates at their pressure.
  CHECK_FALSE(holds(c.assumptions, "flooded"));
  const auto below = read_sample("[model]", "[model]\ncavitation_pressure = \"-0.5 bar\"");
  CHECK(holds(below.assumptions, "flooded"));
}

TEST_CASE("WhatIsGivenIsNoAssumption") {
  const auto c =
      read_sample("[model]", "[model]\ngrid = [100, 20]\nedges = \"dry\"\ntolerance = \"2 %\"");
  CHECK_FALSE(holds(c.assumptions, "200 x 25"));
  CHECK_FALSE(holds(c.assumptions, "flooded"));
  CHECK(c.model.grid == std::array<int, 2>{100, 20});
  CHECK(c.model.edges == bearing::Edges::dry);
  CHECK(c.model.tolerance == near(0.02));
}

TEST_CASE("SwitchesAreOnOffOrTheTiersOwnChoice") {
  const auto c = read_sample(
      "[model]",
      "[model]\nshear_thinning = false\npressure_dependence = true\nflow_factors = \"auto\"");
  CHECK(c.model.switches.shear_thinning == false);
  CHECK(c.model.switches.pressure_dependence == true);
  CHECK_FALSE(c.model.switches.flow_factors.has_value());
  check_refused("[model]", "[model]\nasperity_contact = true", {"case.toml:37:20", "without"});
  check_refused("[model]", "[model]\nflow_factors = true", {"case.toml:37:16", "smooth"});
}

TEST_CASE("AHoleIsEnclosedByItsArcAndLength") {
  const auto s = read_case_text(kSampleCase, "case.toml").supplies.at(0);
  CHECK(s.angle == near(0.5 * kPi));
  CHECK(s.diameter == near(0.005));
  CHECK(s.length == near(0.005));
  CHECK(s.arc * 0.025 == near(0.005));
}

TEST_CASE("ADrillingTurnsAndSoNeedsALoadCycle") {
  const std::string drilling = "kind = \"drilling\"\nangle = \"90 deg\"\ndiameter = \"5 mm\"";
  check_refused(kHole, drilling, {"case.toml:9:8", "belongs to a load cycle", "\"hole\""});
  check_refused(kHole, drilling + "\ndepth = \"1 mm\"", {"case.toml:12:1", "depth", "drilling"});
  check_refused(kHole, drilling + "\ncarry_over = 0.5", {"case.toml:12:1", "carry_over"});
}

TEST_CASE("OilOfSuppliesMeetsTheWallsIfItsDepthIsKnown") {
  const auto with = [](const std::string& keys) { return read_sample(kHole, kHole + keys); };
  const auto value = [](const bearing::Case& c) {
    return std::get<double>(c.supplies[0].heat_transfer);
  };
  const auto channel = [](const bearing::Case& c) {
    return std::holds_alternative<bearing::ChannelHeat>(c.supplies[0].heat_transfer);
  };
  const auto bare = with("");
  CHECK(value(bare) == 0.0);
  CHECK(holds(bare.assumptions, "exchanges none with the walls"));
  const auto deep = with("\ndepth = \"2 mm\"");
  CHECK(channel(deep));
  CHECK(holds(deep.assumptions, "heat_transfer = \"channel\""));
  CHECK(channel(with("\nheat_transfer = \"channel\"")));
  const auto given = with("\ndepth = \"2 mm\"\nheat_transfer = \"800 W/(m2 K)\"");
  CHECK(value(given) == near(800.0));
  CHECK_FALSE(holds(given.assumptions, "with the walls"));
  check_refused(kHole, kHole + "\nheat_transfer = \"-1 W/(m2 K)\"",
                {"case.toml:12:17", "heat_transfer", "negative"});
  check_refused(kHole,
                "kind = \"axial_groove\"\nangle = \"90 deg\"\nlength = \"15 mm\"\narc = \"0 "
                "deg\"\nheat_transfer = \"channel\"",
                {"case.toml:13:17", "no surface", "give arc or width"});
}

TEST_CASE("GroovesHaveArcOrWidth") {
  const std::string axial = "kind = \"axial_groove\"\nangle = \"-90 deg\"\nlength = \"15 mm\"\n";
  const auto by_arc = read_sample(kHole, axial + "arc = \"18 deg\"").supplies.at(0);
  CHECK(by_arc.arc == near(kPi / 10.0));
  CHECK(by_arc.angle == near(1.5 * kPi));  // angles count from 0 to 360 deg
  const auto by_width = read_sample(kHole, axial + "width = \"5 mm\"").supplies.at(0);
  CHECK(by_width.arc * 0.025 == near(0.005));
  check_refused(kHole, axial + "arc = \"18 deg\"\nwidth = \"5 mm\"",
                {"case.toml:13:9", "keep one"});
  check_refused(kHole, axial, {"case.toml:8:1", "arc = \"18 deg\" or width"});
  check_refused(kHole, axial + "arc = \"360 deg\"", {"case.toml:12:7", "circumferential_groove"});
}

TEST_CASE("ACircumferentialGrooveRunsAllRoundUnlessToldOtherwise") {
  const std::string groove = "kind = \"circumferential_groove\"\nwidth = \"3 mm\"\n";
  const auto full = read_sample(kHole, groove).supplies.at(0);
  CHECK(full.arc == near(2.0 * kPi));
  CHECK(full.length == near(0.003));
  const auto half =
      read_sample(kHole, groove + "extent = \"180 deg\"\nangle = \"90 deg\"").supplies.at(0);
  CHECK(half.arc == near(kPi));
  CHECK(half.angle == near(0.5 * kPi));
  check_refused(kHole, groove + "extent = \"180 deg\"", {"case.toml:8:1", "angle", "missing"});
}

TEST_CASE("AbsolutePressuresLoseOneAtmosphere") {
  const auto c =
      read_case_text(sample_with("pressure = \"2 bar\"", "pressure_absolute = \"2 bar\""),
                     "case.toml", {parse_override("model.cavitation_pressure_absolute=100 Pa")});
  CHECK(c.supplies[0].pressure == near(2e5 - 101325.0));
  CHECK(c.model.cavitation_pressure == near(100.0 - 101325.0));
}

TEST_CASE("ASupplyWithoutTemperatureTakesTheOils") {
  const auto c = read_sample("temperature = \"80 degC\"\n", "");
  CHECK(c.supplies[0].temperature == near(363.15));
  CHECK(holds(c.assumptions, "oil.temperature"));
}

TEST_CASE("TheTwoPointLawPassesThroughItsPoints") {
  // 0W20 of validation.md 1.1 and 1.6: 37.5 mPa s at 40 degC, 6.8 mPa s at 100 degC; for C = 95
  // the table there prints B = 749.1 K, A = 0.14591 mPa s, 10.55 mPa s at 80 degC.
  const std::string law =
      "{ law = \"vogel\", A = \"0.0952 mPa s\", B = \"896.4 K\", C = \"110 K\" }";
  const auto c = read_sample(law,
                             "{ law = \"two-point\", eta1 = \"37.5 mPa s\", T1 = \"40 degC\", "
                             "eta2 = \"6.8 mPa s\", T2 = \"100 degC\" }");
  const auto vogel = std::get<rheology::Vogel>(c.oil.temperature);
  const auto eta = [&](double celsius) {
    return vogel.A * std::exp(vogel.B / (celsius + vogel.C));
  };
  CHECK(eta(40.0) == Approx(37.5e-3).epsilon(1e-12));  // exp and log round a few times
  CHECK(eta(100.0) == Approx(6.8e-3).epsilon(1e-12));
  CHECK(vogel.B == Approx(749.1).epsilon(1e-4));       // printed with four figures
  CHECK(vogel.A == Approx(0.14591e-3).epsilon(1e-3));  // sensitive to the rounding of B
  CHECK(eta(80.0) == Approx(10.55e-3).epsilon(1e-3));
  CHECK(holds(c.assumptions, "C = 95 K"));
  check_refused(law,
                "{ law = \"two-point\", eta1 = \"6.8 mPa s\", T1 = \"40 degC\", eta2 = \"37 mPa "
                "s\", T2 = \"100 degC\" }",
                {"case.toml:23:", "does not fall"});
}

TEST_CASE("EveryLawOfTheOilIsRead") {
  const auto with = [](const char* from, const char* to) { return read_sample(from, to).oil; };
  const char* pressure = "{ law = \"barus\", alpha = \"9.5e-9 1/Pa\" }";
  CHECK(
      std::get<rheology::Roelands>(with(pressure, "{ law = \"roelands\", Z = 0.6 }").pressure).Z ==
      0.6);
  const auto houpert = std::get<rheology::Houpert>(
      with(pressure, "{ law = \"houpert\", Z = 0.6, beta = \"0.03 1/K\", at = \"40 degC\" }")
          .pressure);
  CHECK(houpert.at == near(313.15));
  CHECK(std::holds_alternative<rheology::NoPressureEffect>(
      with(pressure, "{ law = \"none\" }").pressure));
  const auto density = std::get<rheology::DowsonHigginson>(
      with("\"850 kg/m3\"",
           "{ law = \"dowson-higginson\", rho0 = \"850 kg/m3\", at = \"40 degC\", expansivity = "
           "\"6.5e-4 1/K\" }")
          .density);
  CHECK(density.expansivity == near(6.5e-4));
  CHECK(density.rise == 0.6e-9);  // seed 002 Eq. 27, where C1 and C2 are not given
  CHECK(density.limit == 1.7e-9);
  const auto own = std::get<rheology::DowsonHigginson>(
      with("\"850 kg/m3\"",
           "{ law = \"dowson-higginson\", rho0 = \"850 kg/m3\", at = \"40 degC\", expansivity = "
           "\"6.5e-4 1/K\", C1 = \"2.22 GPa\", C2 = 1.66 }")
          .density);
  CHECK(own.rise == near(0.66 / 2.22e9));  // rho0 (C1 + C2 p)/(C1 + p)
  CHECK(own.limit == near(1.0 / 2.22e9));
  const auto conductivity = std::get<rheology::PressureConductivity>(
      with("\"0.14 W/(m K)\"",
           "{ law = \"pressure\", a = \"0.14 W/(m K)\", b = \"1.72 1/GPa\", c = \"0.54 1/GPa\" }")
          .conductivity);
  CHECK(conductivity.b == near(1.72));  // the struct counts in 1/GPa
  const auto heat = std::get<rheology::TemperatureHeatCapacity>(
      with("\"2000 J/(kg K)\"",
           "{ law = \"temperature\", a = \"1800 J/(kg K)\", b = \"3.5 J/(kg K2)\", s = 0.88, n = "
           "0.5 }")
          .heat_capacity);
  CHECK(heat.b == near(3.5));
  const char* temperature =
      "{ law = \"vogel\", A = \"0.0952 mPa s\", B = \"896.4 K\", C = \"110 K\" }";
  const auto slope = std::get<rheology::ReynoldsSlope>(
      with(temperature,
           "{ law = \"reynolds\", eta = \"27.7 cP\", at = \"40 degC\", beta = \"0.0341 1/K\" }")
          .temperature);
  CHECK(slope.eta == near(0.0277));
  CHECK(std::get<rheology::ConstantViscosity>(
            with(temperature, "{ law = \"constant\", eta = \"8 mPa s\" }").temperature)
            .eta == near(8e-3));
}

TEST_CASE("AShippedOilTakesInlineChanges") {
  const std::string begin = "[oil]\n";
  const std::size_t at = kSampleCase.find(begin);
  const std::size_t end = kSampleCase.find("[shell]");
  const auto with_oil = [&](const std::string& oil) {
    return kSampleCase.substr(0, at) + begin + oil + "\n" + kSampleCase.substr(end);
  };
  const auto plain = read_case_text(with_oil("name = \"0W20\""), "case.toml").oil;
  const auto changed = read_case_text(
      with_oil("name = \"0W20\"\ndensity = \"900 kg/m3\"\nviscosity.shear = { law = \"none\" }\n"
               "viscosity.pressure.alpha = \"1e-8 1/Pa\""),
      "case.toml");
  CHECK(std::get<rheology::ConstantDensity>(changed.oil.density).rho == near(900.0));
  CHECK(std::holds_alternative<rheology::NoShearThinning>(changed.oil.shear));
  CHECK(std::get<rheology::Barus>(changed.oil.pressure).alpha == near(1e-8));
  CHECK(std::get<rheology::Vogel>(changed.oil.temperature).B ==
        std::get<rheology::Vogel>(plain.temperature).B);
  CHECK(holds(changed.assumptions, "oil 0W20"));
}

TEST_CASE("OfAShippedOilThatIsChangedOnlyTheRestIsTold") {
  const auto assumed = [](const std::string& change) {
    const bearing::Case c =
        read_case(case_path("ks-rig-test-bearing").string(), {parse_override(change)});
    std::string all;
    for (const std::string& a : c.assumptions) all += a + "\n";
    return all;
  };
  const std::string changed = assumed("oil.density=\"900 kg/m3\"");
  CHECK(changed.find("oil 0W20: density of this case instead of the shipped") != std::string::npos);
  CHECK(changed.find("oil 0W20, shipped values: ") != std::string::npos);
  CHECK(changed.find("oil 0W20: Vogel") == std::string::npos);
  const std::string given = assumed("operation.speed=\"2900 rpm\"");
  CHECK(given.find("instead of the shipped") == std::string::npos);
}

TEST_CASE("AMeasuredTorqueIsASizeOrHasTheSignOfTheSpeed") {
  const auto torque = [](const std::string& value, const std::string& speed) {
    const bearing::Case c =
        read_case_text(sample_with("speed = \"3000 rpm\"", "speed = \"" + speed + "\"") +
                           "[measured]\nfriction_torque = \"" + value + "\"\n",
                       "case.toml");
    return *c.measured.friction_torque;
  };
  CHECK(torque("2 N m", "3000 rpm") == 2.0);
  CHECK(torque("2 N m", "-3000 rpm") == 2.0);
  CHECK(torque("-2 N m", "-3000 rpm") == 2.0);
  CHECK_THROWS_AS(torque("-2 N m", "3000 rpm"), InputError);
}

TEST_CASE("AShaftWithoutOverhangMayKeepItsHeatTransfer") {
  const std::string end = "expansion = \"1.2e-5 1/K\" }\n";
  const std::string with =
      sample_with(end, end +
                           "overhang = \"0 mm\"\nheat_transfer = \"100 W/(m2 K)\"\nambient = "
                           "\"70 degC\"\n");
  CHECK(refusal(with) == "");
  CHECK(refusal(sample_with(end, end + "overhang = \"5 mm\"\n")) != "");
}

TEST_CASE("AListIsNumberedInOneWayAndNamedInFull") {
  CHECK(refusal(kSampleCase, {"supply.0.pressure=\"3 bar\""}) == "");
  CHECK(refusal(kSampleCase, {"supply.00.pressure=\"3 bar\""}) != "");
  CHECK(refusal(kSampleCase, {"shell.layers=5"}).find("[[shell.layers]]") != std::string::npos);
}

TEST_CASE("AnIdleKappaIsTold") {
  const auto told = [](const std::string& more) {
    std::string text = sample_with("tier = \"tehd\"", "tier = \"isothermal\"\n" + more);
    std::string all;
    for (const std::string& w : read_case_text(text, "case.toml").warnings) all += w + "\n";
    return all.find("kappa") != std::string::npos;
  };
  CHECK_FALSE(told(""));
  CHECK(told("equivalent_temperature = { kappa = 0.5 }"));
  CHECK_FALSE(
      told("equivalent_temperature = { kappa = 0.5 }\n[measured]\n"
           "shell_back_temperature = \"95 degC\""));
}

TEST_CASE("TheCommandLineChangesTheCase") {
  const auto c = read_case_text(
      kSampleCase, "case.toml",
      {parse_override("operation.speed=1500 rpm"), parse_override("supply.0.pressure=\"3 bar\""),
       parse_override("model.grid=[100, 20]"), parse_override("measured.h_min=2 um"),
       parse_override("operation.tilt={about_x = \"0.1 mrad\"}")});
  CHECK(c.operation.omega == near(50.0 * kPi));
  CHECK(c.supplies[0].pressure == near(3e5));
  CHECK(c.model.grid == std::array<int, 2>{100, 20});
  CHECK(c.measured.h_min == near(2e-6));
  CHECK(std::get<bearing::TiltGiven>(c.operation.alignment).about_x == near(1e-4));
  CHECK(c.verbatim.find("operation.speed = 1500 rpm") != std::string::npos);
}

TEST_CASE("SurfacesContactHousingMomentAndMeasuredAreRead") {
  const auto c = read_case_text(
      sample_with("[model]", R"([surfaces]
shaft = { roughness = "0.20 um" }
[surfaces.shell]
roughness = "0.34 um"
orientation = 12
summit_roughness = "0.28 um"
summit_height = "0.39 um"
[surfaces.contact]
elastic_factor = 0.001
composite_modulus = "53.3 GPa"
friction = 0.02
integral = "power-law"
[measured]
friction_torque = "1.06 N m"
side_flow = "0.6 l/min"
p_max = "30 MPa"
T_shell_max = "110 degC"
eccentricity_ratio = 0.8
[model])"),
      "case.toml",
      {parse_override("shell.housing={material={conductivity=\"150 W/(m K)\",density=\"2700 "
                      "kg/m3\",heat_capacity=\"900 J/(kg K)\",youngs_modulus=\"70 "
                      "GPa\",poisson_ratio=0.33,expansion=\"2.3e-5 1/K\"},outer_diameter=\"80 "
                      "mm\",support=\"free\"}"),
       parse_override("operation.moment={about_x=\"1 N m\"}")});
  CHECK(c.surfaces.shell.summit_height == near(0.39e-6));
  CHECK(c.surfaces.shaft.orientation == 1.0);
  REQUIRE(c.surfaces.contact);
  CHECK(c.surfaces.contact->integral == solid::ContactIntegral::power_law);
  REQUIRE(c.shell->housing);
  CHECK(c.shell->housing->outer_radius == near(0.04));
  CHECK(c.shell->housing->support == bearing::HousingSupport::free);
  CHECK(std::get<bearing::MomentGiven>(c.operation.alignment).about_x == near(1.0));
  CHECK(c.measured.side_flow == near(1e-5));
  CHECK(c.measured.T_shell_max == near(383.15));
}

TEST_CASE("ATableThatNamesAShippedMaterialChangesSingleValuesOfIt") {
  const auto with = [](const std::string& material) {
    return read_case_text(
        sample_with("[shaft]\nmaterial = {", "[shaft]\nmaterial = " + material + "\n#"),
        "case.toml");
  };
  const auto shipped = with("\"AlSn20\"");
  const auto c = with("{ name = \"AlSn20\", youngs_modulus = \"70 GPa\" }");
  CHECK(c.shaft->material.youngs_modulus == near(70e9));
  CHECK(c.shaft->material.density == shipped.shaft->material.density);
  CHECK(c.shaft->material.conductivity == shipped.shaft->material.conductivity);
  const std::string told = "material AlSn20: youngs_modulus of this case";
  CHECK(holds(c.assumptions, told));
  CHECK(holds(c.assumptions, "material AlSn20, shipped values: conductivity"));
  CHECK_FALSE(holds(shipped.assumptions, told));
}

TEST_CASE("AKeySetWithinANamedMaterialChangesThatValue") {
  const std::string text = sample_with("[shaft]\nmaterial = {", "[shaft]\nmaterial = \"steel\"\n#");
  const auto c =
      read_case_text(text, "case.toml", {parse_override("shaft.material.expansion=9e-6 1/K")});
  CHECK(c.shaft->material.expansion == near(9e-6));
  CHECK(c.shaft->material.youngs_modulus == near(210e9));
  check_parts(refusal(text, {"shaft.material.expansoin=9e-6 1/K"}),
              {"did you mean \"expansion\"?"});
}

TEST_CASE("AHousingMustEncloseTheShell") {
  check_parts(refusal(kSampleCase, {"shell.housing={material=\"steel\",outer_diameter=\"52 mm\"}"}),
              {"does not enclose the shell", "54 mm"});
}

TEST_CASE("BarusGoesAsFarAsItIsKnownToWhereTheCaseDoesNotTell") {
  const auto p_max = [](const std::string& from, const std::string& to) {
    return read_case_text(sample_with(from, to), "case.toml").oil.range.p_max;
  };
  const std::string valid =
      "valid = { temperature = [\"20 degC\", \"150 degC\"], pressure = "
      "\"200 MPa\", shear_rate = \"1e7 1/s\" }";
  CHECK(p_max(valid, "") == near(200e6));  // docs/models.md
  CHECK(p_max("\"200 MPa\"", "\"350 MPa\"") == near(350e6));
  CHECK(p_max(valid, "valid = { shear_rate = \"1e7 1/s\" }") == near(200e6));
  std::string none = sample_with(valid, "");
  const std::string law = "viscosity.pressure = { law = \"barus\", alpha = \"9.5e-9 1/Pa\" }";
  none.replace(none.find(law), law.size(), "");
  CHECK(read_case_text(none, "case.toml").oil.range.p_max > 1e11);
}

TEST_CASE("AProfileIsReadBesideTheCase") {
  const ScratchFolder scratch;
  scratch.write("profile.csv",
                "# bell mouth\nphi [deg], z [mm], height [um]\n0, -10, 2\n0, 10, 2\n"
                "180, -10, 1\n180, 10, 3\n360, 10, 2\n");
  const std::string text =
      sample_with("radial_clearance", "profile = \"profile.csv\"\nradial_clearance");
  const auto c = read_case_text(text, scratch.path("case.toml"));
  REQUIRE(c.bearing.profile);
  CHECK(c.bearing.profile->phi.size() == 2);
  CHECK(c.bearing.profile->z[1] == near(0.01));
  CHECK(c.bearing.profile->height[3] == near(3e-6));
}

TEST_CASE("ABadProfileIsRefusedAtItsPlace") {
  const ScratchFolder scratch;
  const std::string text =
      sample_with("radial_clearance", "profile = \"bad.csv\"\nradial_clearance");
  const auto against = [&](const std::string& table) {
    const std::string path = scratch.write("bad.csv", table);
    try {
      static_cast<void>(read_case_text(text, scratch.path("case.toml")));
    } catch (const InputError& error) {
      std::string what = error.what();
      if (what.find(path) == 0) what.replace(0, path.size(), "bad.csv");
      return what;
    }
    return std::string();
  };
  check_parts(against("phi [deg], z [mm], height\n0,0,0\n"), {"bad.csv:1:20", "names no unit"});
  check_parts(against("phi [deg], z [mm], height [bar]\n0,0,0\n"), {"bad.csv:1:20", "a pressure"});
  check_parts(against("phi [deg], z [mm]\n0,0\n"), {"bad.csv:1:1", "no column height"});
  check_parts(against("phi [deg], z [mm], height [um]\n0, x, 0\n"), {"bad.csv:2:4", "number"});
  check_parts(against("phi [deg], z [mm], height [um]\n0, 0\n"), {"bad.csv:2:", "3 columns"});
  check_parts(against("phi [deg];z [mm];height [um]\n0;0;4,9\n"), {"bad.csv:2:", "point"});
  check_parts(against("phi [deg], z [mm], height [um], height [mm]\n0,0,1,2\n"),
              {"bad.csv:1:", "two columns"});
  check_parts(against("phi [deg], z [mm], height [um]\n0, 0, 5 %\n"), {"bad.csv:2:7", "a share"});
  check_parts(against("phi [deg], z [mm], height [um]\n0,0,nan\n"), {"bad.csv:2:5", "finite"});
  check_parts(against("phi [deg], z [mm], height [um]\n"), {"no points"});
  check_parts(against("phi [deg], z [mm], height [um]\n0,0,1\n90,1,1\n"), {"rectangular grid"});
  check_parts(against("phi [deg], z [mm], height [um]\n0,0,1\n0,0,2\n"), {"bad.csv:3:5", "before"});
  check_parts(against("phi [deg], z [mm], height [mm]\n0,0,1\n90,0,9\n"), {"leave no gap"});
  check_parts(against("phi [rad], z [mm], height [um]\n0,0,1\n90,0,2\n180,0,1\n"),
              {"bad.csv:4:1", "more than once round", "check the unit"});
  std::filesystem::remove(scratch.path("bad.csv"));
  CHECK_THROWS_AS(read_case_text(text, scratch.path("case.toml")), FileError);
}

TEST_CASE("EveryShippedCaseReadsClean") {
  for (const std::string& name : shipped_cases()) {
    INFO(name);
    const auto c = read_case(case_path(name).string());
    CHECK_FALSE(c.title.empty());
    CHECK(c.warnings.empty());
    CHECK_FALSE(possible_tiers(c).empty());
  }
  CHECK(possible_tiers(read_case(case_path("ks-rig-test-bearing").string())).size() == 4);
}

TEST_CASE("TheRaimondiBoydCaseHasItsLineAtTheWidestGap") {
  const auto c = read_case(case_path("raimondi-boyd").string());
  const auto e = std::get<bearing::EccentricityGiven>(c.operation.position);
  const double widest = e.load_angle + e.attitude - kPi;  // opposite to the smallest gap
  CHECK(c.supplies.at(0).angle == Approx(widest).epsilon(1e-12));
  CHECK(c.supplies[0].arc == 0.0);
  CHECK(c.bearing.width == near(2.0 * c.bearing.radius));
}

TEST_CASE("EveryShippedOilAndMaterialCanBeUsed") {
  Reader reader;
  for (const std::string& name : shipped_materials(reader)) {
    INFO(name);
    const std::string text =
        sample_with("[shaft]\nmaterial = {", "[shaft]\nmaterial = \"" + name + "\"\n#");
    CHECK(refusal(text).empty());
  }
  const std::size_t at = kSampleCase.find("[oil]\n");
  const std::size_t end = kSampleCase.find("[shell]");
  for (const std::string& name : shipped_oils()) {
    const std::string text =
        kSampleCase.substr(0, at) + "[oil]\nname = \"" + name + "\"\n" + kSampleCase.substr(end);
    INFO(name);
    CHECK(refusal(text).empty());
  }
}

TEST_CASE("InitListsAndWritesShippedCases") {
  const ScratchFolder scratch;
  std::ostringstream list;
  list_cases(list);
  for (const std::string& name : shipped_cases()) {
    CHECK(list.str().find(name) != std::string::npos);
  }
  const std::string target = scratch.path("written.toml");
  std::ostringstream out;
  write_case("raimondi-boyd", target, out);
  CHECK(read_case(target).bearing.radius == near(0.05));
  CHECK_THROWS_AS(write_case("raimondi-boyd", target, out), FileError);
  CHECK_THROWS_AS(write_case("raimondi-boyt", target, out), InputError);
}

TEST_CASE("MethodsAreReadFromTheCaseAndFromTheCommandLine") {
  using namespace bearing;
  const Methods m =
      read_sample("tier = \"tehd\"",
                  "tier = \"tehd\"\nmethods = { cavitation = \"fischer-burmeister\", across = "
                  "\"layers\", layers = 12, elastic = \"fixed-point\", relaxation = 0.2 }")
          .model.methods;
  CHECK(m.cavitation == CavitationMethod::fischer_burmeister);
  CHECK(m.across == AcrossFilm::layers);
  CHECK(m.layers == 12);
  CHECK(m.elastic == ElasticMethod::fixed_point);
  CHECK(m.relaxation == 0.2);
  const auto c = read_case_text(kSampleCase, "case.toml",
                                {parse_override("model.methods.across=mean"),
                                 parse_override("model.methods.elastic=\"fixed-point\"")});
  CHECK(c.model.methods.across == AcrossFilm::mean);
  CHECK(c.model.methods.elastic == ElasticMethod::fixed_point);
}

TEST_CASE("TheTransportOfTheFillIsReadAndAnUnknownOneIsRefused") {
  using namespace bearing;
  const auto with = [](const std::string& transport) {
    return read_case_text(kSampleCase, "case.toml",
                          {parse_override("model.methods.transport=" + transport)});
  };
  CHECK(with("van-leer").model.methods.transport == FillTransport::van_leer);
  CHECK(with("upwind").model.methods.transport == FillTransport::upwind);
  CHECK_THROWS_AS(with("van-lear"), InputError);
  CHECK_THROWS_AS(with("2"), InputError);
  CHECK_THROWS_AS(with("[\"upwind\"]"), InputError);
}

TEST_CASE("AHousingThatIsNotGivenIsAnAssumption") {
  const auto says_held = [](const std::string& text) {
    const auto c = read_case_text(text, "case.toml");
    return std::any_of(c.assumptions.begin(), c.assumptions.end(), [](const std::string& line) {
      return line.find("shell.housing") != std::string::npos &&
             line.find("held") != std::string::npos;
    });
  };
  CHECK(says_held(kSampleCase));
  CHECK_FALSE(says_held(sample_with("[shell]\n",
                                    "[shell]\nhousing = { material = \"steel\", outer_diameter = "
                                    "\"80 mm\", support = \"free\" }\n")));
}

TEST_CASE("TheCaseKnowsWhatTheCommandLineChanged") {
  const auto c = read_case_text(
      kSampleCase, "case.toml",
      {parse_override("operation.speed=1500 rpm"), {"model.tier", "\"thd\"", "--tier"}});
  REQUIRE(c.changes.size() == 2);
  CHECK(c.changes[0].key == "operation.speed");
  CHECK(c.changes[0].value == "1500 rpm");
  CHECK(c.changes[0].option == "--set");
  CHECK(c.changes[1].option == "--tier");
}
