/// Every class of bad input: file, line and column, what, why and cure.
#include <algorithm>

#include "app/reading/case_text.hpp"
#include "app/reading/library.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

TEST_CASE("TheSampleIsTaken") { CHECK(refusal(kSampleCase).empty()); }

TEST_CASE("AMisspeltKeyIsRefusedWithTheRightOne") {
  check_refused("diameter = \"50 mm\"", "diametre = \"50 mm\"",
                {"case.toml:4:1", "unknown key \"diametre\"", "did you mean \"diameter\"?"});
  check_refused("[operation]", "[operations]",
                {"case.toml:15:2", "unknown key \"operations\"", "\"operation\""});
  check_refused("pressure = \"2 bar\"", "presure = \"2 bar\"",
                {"case.toml:12:1", "did you mean \"pressure\"?"});
  check_refused("radial_clearance =", "diametral_clearance =",
                {"case.toml:6:1", "did you mean \"radial_clearance\"?"});
  check_refused("back = {", "back = { alpha = 3,", {"case.toml:31:10", "unknown key \"alpha\""});
  check_refused("r = 0.5", "R = 0.5", {"case.toml:25:36", "unknown key \"R\""});
}

TEST_CASE("AMissingKeyIsNamedWithAnExample") {
  check_refused("diameter = \"50 mm\"\n", "",
                {"case.toml:3:1", "bearing.diameter", "missing", "diameter = \"50 mm\""});
  check_refused("speed = \"3000 rpm\"\n", "", {"case.toml:15:1", "operation.speed", "rpm"});
  check_refused("[operation]\nspeed = \"3000 rpm\"\nload = \"5 kN\"\n", "",
                {"case.toml: operation", "missing"});
}

TEST_CASE("ABareNumberIsRefusedWithUnitsThatWouldDo") {
  check_refused("\"50 mm\"", "50", {"case.toml:4:12", "50 has no unit", "um, mm, cm, m, in"});
  check_refused("\"50 mm\"", "50.5", {"case.toml:4:12", "50.5 has no unit"});
  check_refused("\"50 mm\"", "\"50\"", {"case.toml:4:12", "no unit", "um, mm"});
  check_refused("\"3000 rpm\"", "314.16", {"case.toml:16:9", "rpm, rad/s, Hz"});
}

namespace {

/// Dotted names of all single values below the node.
void add_names(const toml::node& node, const std::string& name, std::vector<std::string>& names) {
  const std::string stem = name.empty() ? "" : name + ".";
  if (const auto* table = node.as_table()) {
    for (auto&& [key, value] : *table) add_names(value, stem + std::string(key.str()), names);
  } else if (const auto* list = node.as_array()) {
    for (std::size_t k = 0; k < list->size(); ++k) {
      add_names(*list->get(k), stem + std::to_string(k), names);
    }
  } else {
    names.push_back(name);
  }
}

/// What is said of the case at its key: the refusal, or the warnings; empty if nothing is.
std::string said_at(const std::string& key, const std::string& name,
                    const std::vector<Override>& set) {
  const std::string place = "--set " + key + ":";
  std::string said;
  try {
    for (const std::string& warning : read_case(case_path(name).string(), set).warnings) {
      if (warning.starts_with(place)) said += warning;
    }
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.starts_with(place)) said = what;
  }
  return said;
}

/// The example of a refusal "... for example KEY = VALUE"; empty if it has none.
std::string example_in(const std::string& refusal) {
  const std::string words = "for example ";
  const std::size_t at = refusal.rfind(words);
  const std::size_t equal = refusal.find(" = ", at);
  return at == refusal.npos || equal == refusal.npos ? "" : refusal.substr(equal + 3);
}

}  // namespace

TEST_CASE("EveryExampleThatARefusalGivesIsTaken") {
  using Changes = std::vector<std::string>;
  std::vector<std::pair<std::string, Changes>> cases;
  for (const std::string& name : shipped_cases()) cases.emplace_back(name, Changes{});
  cases.emplace_back("rotating-load", Changes{"supply.0.vessel_volume=20 cm3", "supply.0.open=[]",
                                              "supply.0.vessel_bulk_modulus=1.5 GPa"});
  cases.emplace_back("running-in", Changes{"running_in.limit_pressure=5 MPa"});
  cases.emplace_back("raimondi-boyd",
                     Changes{"bearing.edge_relief.depth=5 um", "bearing.edge_relief.length=9 mm",
                             "bearing.chamfer.depth=5 um", "bearing.chamfer.length=1 mm",
                             "operation.tilt.about_x=0.1 mrad", "measured.h_min=2 um",
                             "measured.p_max=50 MPa", "model.cavitation_pressure=0 bar"});
  int tried = 0;
  for (const auto& [name, changes] : cases) {
    std::vector<Override> set;
    std::vector<std::string> keys;
    const std::string path = case_path(name).string();
    if (changes.empty()) add_names(parse_toml(read_text_file(path), path), "", keys);
    for (const std::string& change : changes) {
      set.push_back(parse_override(change));
      keys.push_back(set.back().key);
    }
    for (const std::string& key : keys) {
      set.push_back(parse_override(key + "=true"));  // no quantity
      const std::string example = example_in(said_at(key, name, set));
      set.pop_back();
      if (example.empty()) continue;
      // The example is that of metals, and a polymer is told its own.
      if (name == "shell-polymer" && key == "surfaces.contact.composite_modulus") continue;
      set.push_back(parse_override(key + "=" + example));
      INFO(name << ": " << key << " = " << example);
      CHECK(said_at(key, name, set).empty());
      set.pop_back();
      ++tried;
    }
  }
  CHECK(tried > 300);
}

TEST_CASE("AWrongUnitIsRefused") {
  check_refused("\"50 mm\"", "\"50 degC\"",
                {"case.toml:4:12", "bearing.diameter", "a temperature", "a length"});
  check_refused("\"80 degC\"", "\"80 mm\"", {"case.toml:13:15", "supply.0.temperature"});
  check_refused("C = \"110 K\"", "C = \"110 degC\"", {"case.toml:23:", "difference", "write K"});
}

TEST_CASE("ZeroNegativeAndNotANumberAreRefused") {
  check_refused("\"50 mm\"", "\"0 mm\"", {"case.toml:4:12", "must be positive"});
  check_refused("\"25 um\"", "\"-25 um\"", {"case.toml:6:20", "must be positive"});
  check_refused("\"25 um\"", "\"nan um\"", {"case.toml:6:20", "not a finite number"});
  check_refused("r = 0.5", "r = nan", {"case.toml:25:", "not a finite number"});
  check_refused("r = 0.5", "r = inf", {"case.toml:25:", "not a finite number"});
  check_refused("poisson_ratio = 0.3", "poisson_ratio = 0.5",
                {"case.toml:30:", "between 0 and 0.4999"});
  check_refused("\"5 kN\"", "\"-5 kN\"", {"case.toml:17:8", "must be positive"});
}

TEST_CASE("AbsurdGeometryIsRefusedWithTheReason") {
  check_refused("\"25 um\"", "\"25 mm\"",
                {"case.toml:6:20", "1 of the radius", "diametral clearance"});
  check_refused("\"25 um\"", "\"25 nm\"", {"case.toml:6:20", "1e-06 of the radius"});
  check_refused("\"25 mm\"", "\"25 m\"", {"case.toml:5:9", "width is 500 of the diameter"});
  check_refused("\"50 mm\"", "\"50 m\"", {"case.toml:4:12", "diameter is 5e+04 mm"});
  check_refused("\"5 kN\"", "\"5e6 kN\"", {"case.toml:17:8", "4e+06 MPa"});
  check_refused("temperature = \"80 degC\"", "temperature = \"80 degC\"\ndepth = \"5 um\"",
                {"case.toml:14:9", "supply.0.depth", "radial clearance", "check the unit"});
  check_refused("temperature = \"80 degC\"",
                "temperature = \"80 degC\"\nheat_transfer = \"2e6 W/(m2 K)\"",
                {"case.toml:14:17", "heat_transfer", "1e6 W/(m2 K)"});
  check_refused("\"3000 rpm\"", "\"3e6 rpm\"", {"case.toml:16:9", "surface speed"});
  check_refused("thickness = \"2 mm\"", "thickness = \"2 m\"", {"case.toml:30:", "2000 mm thick"});
  check_refused("[model]", "[model]\ngrid = [4, 3]", {"case.toml:37:8", "4 cells"});
  check_refused("load = ", "tilt = { about_x = \"5 mrad\" }\nload = ",
                {"case.toml:17:8", "2.5 radial clearances"});
}

TEST_CASE("SuspiciousGeometryIsAWarningOnly") {
  const auto read = read_sample("\"25 um\"", "\"4 um\"");
  REQUIRE(read.warnings.size() == 1);
  check_parts(read.warnings[0], {"case.toml:6:20", "unusual"});
}

TEST_CASE("LoadAndEccentricityTogetherAreRefused") {
  check_refused("load = ", "eccentricity_ratio = 0.5\nload = ",
                {"case.toml:17:22", "load is given too", "keep one"});
  check_refused("load = \"5 kN\"\n", "", {"case.toml:15:1", "neither load nor"});
  check_refused("load = \"5 kN\"", "eccentricity_ratio = 101.0\nattitude_angle = \"0 deg\"",
                {"case.toml:17:22", "between 0 and 100"});
  check_refused("load = \"5 kN\"", "eccentricity_ratio = -0.1\nattitude_angle = \"0 deg\"",
                {"case.toml:17:22", "between 0 and 100"});
  check_refused("load = \"5 kN\"", "eccentricity_ratio = 0.5",
                {"case.toml:15:1", "attitude_angle", "missing"});
}

TEST_CASE("ZeroSpeedUnderLoadIsRefusedWithTheReason") {
  check_refused("\"3000 rpm\"", "\"0 rpm\"",
                {"case.toml:16:9", "zero speed", "rests on the shell", "give a speed"});
}

TEST_CASE("NoSupplyIsRefusedWithTheReason") {
  const std::string supply =
      kSampleCase.substr(kSampleCase.find("[[supply]]"),
                         kSampleCase.find("[operation]") - kSampleCase.find("[[supply]]"));
  check_refused(supply, "",
                {"case.toml: supply", "sides", "conserves mass", "runs dry", "[[supply]]"});
  check_refused("[[supply]]", "[supply]", {"case.toml:8:1", "[[supply]], with two brackets"});
}

TEST_CASE("ASupplyMustLieOnTheBearing") {
  check_refused("diameter = \"5 mm\"", "diameter = \"30 mm\"",
                {"case.toml:11:12", "30 mm is more than the bearing's width of 25 mm"});
  check_refused("diameter = \"5 mm\"", "diameter = \"5 mm\"\nz = \"11 mm\"",
                {"case.toml:12:5", "13.5 mm from mid-width", "edge at 12.5 mm"});
  check_refused("kind = \"hole\"\nangle = \"90 deg\"\ndiameter = \"5 mm\"",
                "kind = \"axial_groove\"\nangle = \"90 deg\"\narc = \"20 deg\"\nlength = \"25 mm\"",
                {"case.toml:12:10", "open to the sides", "shorter"});
  check_refused("kind = \"hole\"\nangle = \"90 deg\"\ndiameter = \"5 mm\"",
                "kind = \"circumferential_groove\"\nwidth = \"24 mm\"",
                {"case.toml:8:1", "96 % of the bearing"});
}

TEST_CASE("ALineSupplyMaySpanTheWidth") {
  const auto read = read_sample(
      "kind = \"hole\"\nangle = \"90 deg\"\ndiameter = \"5 mm\"",
      "kind = \"axial_groove\"\nangle = \"90 deg\"\narc = \"0 deg\"\nlength = \"25 mm\"");
  CHECK(read.supplies[0].arc == 0.0);
  CHECK(read.supplies[0].length == 0.025);
}

TEST_CASE("SuppliesMustNotContradictEachOther") {
  check_refused("[operation]",
                "[[supply]]\nkind = \"hole\"\nangle = \"92 deg\"\ndiameter = \"5 mm\"\n"
                "pressure = \"3 bar\"\ntemperature = \"80 degC\"\n[operation]",
                {"case.toml:15:1", "supply.1", "overlaps supply.0", "another pressure"});
}

TEST_CASE("ValuesInAnotherUnitAreRefused") {
  check_refused("pressure = \"2 bar\"", "pressure = \"1e5 bar\"",
                {"case.toml:12:12", "supply pressure", "check the unit"});
  check_refused("diameter = \"5 mm\"", "diameter = \"5 nm\"",
                {"case.toml:11:12", "mouth", "check the unit"});
}

TEST_CASE("ASupplyBelowTheCavitationPressureIsRefused") {
  check_refused("\"2 bar\"", "\"-0.5 bar\"",
                {"case.toml:12:12", "below the cavitation pressure", "raise it"});
  check_refused("\"2 bar\"", "\"-2 bar\"", {"case.toml:12:12", "below vacuum"});
  check_refused("[model]", "[model]\ncavitation_pressure = \"1 bar\"",
                {"case.toml:37:23", "above ambient pressure"});
}

TEST_CASE("UnknownMaterialsAndOilsAreRefusedWithTheList") {
  check_refused("[shaft]\nmaterial = {", "[shaft]\nmaterial = \"stel\"\n#",
                {"case.toml:34:12", "no shipped material \"stel\"", "did you mean \"steel\"?",
                 "shipped are:"});
  check_refused("[shaft]\nmaterial = {",
                "[shaft]\nmaterial = { name = \"AlSn2O\", expansion = \"2e-5 1/K\" }\n#",
                {"case.toml:34:21", "no shipped material \"AlSn2O\"", "did you mean \"AlSn20\"?"});
  const std::string oil =
      kSampleCase.substr(kSampleCase.find("viscosity.temp"),
                         kSampleCase.find("[shell]") - kSampleCase.find("viscosity.temp"));
  check_refused(
      oil, "name = \"0w20\"\n",
      {"case.toml:23:8", "no shipped oil \"0w20\"", "did you mean \"0W20\"?", "shipped are:"});
  check_refused(oil, "", {"case.toml:19:1", "neither name nor viscosity", "0W20"});
}

TEST_CASE("AMisspeltChoiceIsRefusedWithTheList") {
  check_refused("\"hole\"", "\"hoel\"",
                {"case.toml:9:8", "did you mean \"hole\"?", "axial_groove"});
  check_refused("\"vogel\"", "\"fogel\"", {"case.toml:23:", "did you mean \"vogel\"?", "reynolds"});
  check_refused("\"tehd\"", "\"thed\"", {"case.toml:37:8", "did you mean", "isothermal, lumped"});
  check_refused("[model]", "[model]\nedges = \"floded\"",
                {"case.toml:37:9", "did you mean \"flooded\"?", "dry"});
  check_refused("[model]", "[model]\nflow_factors = \"on\"",
                {"case.toml:37:16", "true, false, \"auto\""});
}

TEST_CASE("AWrongTypeIsRefused") {
  check_refused("diameter = \"50 mm\"", "diameter = [1]", {"case.toml:4:12", "a list", "a length"});
  check_refused("diameter = \"50 mm\"", "diameter = true", {"case.toml:4:12", "true/false"});
  check_refused("diameter = \"50 mm\"", "diameter = 1979-05-27", {"case.toml:4:12", "date"});
  check_refused("[shaft]\nmaterial = {", "[shaft]\nmaterial = 3\n#",
                {"case.toml:34:12", "a number"});
  check_refused("back = {", "back = \"cold\"\n#", {"case.toml:31:8", "a table is wanted"});
  check_refused("title = \"sample\"", "title = 3", {"case.toml:1:9", "a text is wanted"});
  check_refused("[model]", "[model]\ngrid = [200]", {"case.toml:37:8", "[200, 25]"});
  check_refused("[model]", "[model]\ngrid = [200, 2.5]", {"case.toml:37:8", "whole number"});
}

TEST_CASE("KeysThatContradictAreRefused") {
  check_refused("load = ", "attitude_angle = \"40 deg\"\nload = ",
                {"case.toml:17:1", "attitude_angle", "no effect"});
  check_refused("back = {", "back = { temperature = \"90 degC\",",
                {"case.toml:31:", "keep one of them"});
  check_refused("pressure = \"2 bar\"", "pressure = \"2 bar\"\npressure_absolute = \"3 bar\"",
                {"case.toml:13:21", "keep one of them"});
  check_refused(
      "load = ", "tilt = { about_x = \"0.1 mrad\" }\nmoment = { about_x = \"1 N m\" }\nload = ",
      {"case.toml:18:10", "tilt is given too"});
}

TEST_CASE("ConstantsOfADensityThatNoOilHasAreRefused") {
  const auto refused = [](const std::string& constants, const std::vector<std::string>& parts) {
    check_refused("density = \"850 kg/m3\"",
                  "density = { law = \"dowson-higginson\", rho0 = \"850 kg/m3\", at = \"40 "
                  "degC\", " +
                      constants + " }",
                  parts);
  };
  const std::string at = "expansivity = \"7e-4 1/K\", ";
  refused(at + "c1 = \"2.22 GPa\", C2 = 1.66", {"case.toml:20:", "did you mean \"C1\"?"});
  refused(at + "C1 = 2.22, C2 = 1.66", {"case.toml:20:", "C1", "no unit", "GPa"});
  refused(at + "C1 = \"2.22 GPa\"", {"case.toml:20:", "C2", "missing", "go with C1"});
  refused(at + "C2 = 1.66", {"case.toml:20:", "C1", "missing", "go with C2"});
  refused(at + "C1 = \"2.22 GPa\", C2 = 0.66", {"case.toml:20:", "C2", "exceed 1"});
  refused(at + "C1 = \"0 Pa\", C2 = 1.66", {"case.toml:20:", "C1", "positive"});
  refused(at + "C1 = \"2.22 MPa\", C2 = 1.66",
          {"case.toml:20:", "C1", "bulk modulus", "check the unit"});
  refused("expansivity = \"7e-2 1/K\"", {"case.toml:20:", "expansivity", "6.4e-4 to 7.3e-4"});
  const auto read = read_sample("density = \"850 kg/m3\"",
                                "density = { law = \"dowson-higginson\", rho0 = \"850 kg/m3\", at "
                                "= \"40 degC\", expansivity = \"7e-4 1/K\" }");
  CHECK(std::count_if(read.assumptions.begin(), read.assumptions.end(), [](const auto& words) {
          return words.find("C1 = 588.2 MPa, C2 = 1.353") != std::string::npos;
        }) == 1);
}

TEST_CASE("TiersNeedTheirData") {
  const std::string shell = kSampleCase.substr(
      kSampleCase.find("[shell]"), kSampleCase.find("[shaft]") - kSampleCase.find("[shell]"));
  const std::string shaft = kSampleCase.substr(
      kSampleCase.find("[shaft]"), kSampleCase.find("[model]") - kSampleCase.find("[shaft]"));
  check_refused(shell, "", {"case.toml: shell", "no [shell]", "lumped or isothermal"});
  check_refused(shaft, "", {"case.toml: shaft", "no [shaft]", "lumped or isothermal"});
  check_refused("back = { heat_transfer = \"500 W/(m2 K)\", ambient = \"70 degC\" }", "",
                {"case.toml:29:1", "how heat leaves", "back = {"});
  CHECK(refusal(sample_with(shell, ""), {"model.tier=lumped"}).empty());
  CHECK(refusal(sample_with(shaft, ""), {"model.tier=isothermal"}).empty());
  check_parts(refusal(sample_with("temperature = \"90 degC\"\n", ""), {"model.tier=isothermal"}),
              {"oil.temperature", "needs the film's temperature", "constant viscosity"});
  CHECK(refusal(sample_with("temperature = \"90 degC\"\n", ""),
                {"model.tier=isothermal", "measured.shell_back_temperature=88 degC"})
            .empty());
}

TEST_CASE("ATemperatureOutsideTheOilsRangeIsAWarning") {
  const auto read = read_sample("temperature = \"90 degC\"", "temperature = \"160 degC\"");
  REQUIRE(read.warnings.size() == 1);
  check_parts(read.warnings[0], {"case.toml:26:15", "160 degC", "20 degC to 150 degC"});
  check_refused("\"90 degC\"", "\"90 K\"", {"case.toml:26:15", "degC or K"});
}

TEST_CASE("TheCommandLineIsNamedAsThePlace") {
  const auto what = [](const char* words) { return refusal(kSampleCase, {words}); };
  check_parts(what("bearing.diameter=50"), {"--set bearing.diameter: 50 has no unit"});
  check_parts(what("bearing.diametre=50 mm"), {"--set bearing.diametre: unknown key", "diameter"});
  check_parts(what("supply.1.pressure=3 bar"), {"--set supply.1.pressure", "no entry 1"});
  check_parts(what("supply.x.pressure=3 bar"), {"does not number an entry"});
  check_parts(what("bearing.diameter.x=3"), {"holds no keys"});
  check_parts(what("bearing..x=3"), {"no key"});
  check_parts(what("bearing"), {"--set", "KEY=VALUE"});
  check_parts(what("=3"), {"--set", "KEY=VALUE"});
  check_parts(what("supply.0=3"), {"cannot be replaced"});
  check_parts(what("operation.speed=\"0 rpm\""), {"--set operation.speed: at zero speed"});
}

TEST_CASE("AMethodThatIsNotKnownOrCannotServeIsRefused") {
  const std::string model = "tier = \"tehd\"\n";
  const auto refused = [&](const std::string& methods, const std::vector<std::string>& parts) {
    check_refused(model, model + "methods = { " + methods + " }\n", parts);
  };
  refused("cavitation = \"p-teta\"", {"case.toml:38:", "did you mean \"p-theta\"?"});
  refused("cavitatoin = \"p-theta\"", {"case.toml:38:", "did you mean \"cavitation\"?"});
  refused("across = \"layers\", layers = 100", {"case.toml:38:", "layers"});
  refused("layers = 10", {"case.toml:38:", "layers belong to across"});
  refused("relaxation = 0.5", {"case.toml:38:", "relaxation belongs to elastic"});
  refused("elastic = \"fixed-point\", relaxation = 1.5", {"case.toml:38:", "at most 1"});
  refused("cavitation = \"swift-stieber\"", {"case.toml:38:", "does not conserve oil"});
  refused("cavitation = \"p-theta\"", {"case.toml:38:", "elastic = \"fixed-point\""});
}

TEST_CASE("AHoleIsNotCalledAGroove") {
  const std::string wide = refusal(sample_with("diameter = \"5 mm\"", "diameter = \"25 mm\""));
  check_parts(wide, {"the hole is as wide as the bearing"});
  CHECK(wide.find("groove") == std::string::npos);
}

TEST_CASE("EdgesAndSupportsThatCannotBeAreRefused") {
  const auto bearing = [](const std::string& key, const std::vector<std::string>& parts) {
    check_refused("width = \"25 mm\"", "width = \"25 mm\"\n" + key, parts);
  };
  bearing("edge_relief = { depth = \"3 um\" }", {"case.toml:6:", "edge_relief.length", "missing"});
  bearing("edge_relief = { depth = \"3 um\", length = \"20 mm\" }",
          {"case.toml:6:", "20 mm from either edge", "at most half the width"});
  bearing("edge_relief = { depth = \"-3 um\", length = \"2 mm\" }", {"case.toml:6:", "negative"});
  bearing("chamfer = { depth = \"8 mm\", length = \"2 mm\" }", {"case.toml:6:", "check the unit"});
}

TEST_CASE("RunningInThatCannotBeIsRefused") {
  const auto refused = [](const std::string& keys, const std::vector<std::string>& parts) {
    check_refused("[operation]", "[running_in]\n" + keys + "\n\n[operation]", parts);
  };
  refused("until = \"200 s\"", {"case.toml:", "running_in.wear_coefficient", "missing"});
  refused("wear_coefficient = 1e-8", {"case.toml:", "running_in.until", "worn_in"});
  refused("wear_coefficient = 1e-8\nuntil = 5",
          {"case.toml:17:", "running_in.until", "until = \"200 s\""});
  refused("wear_coefficient = 1e-8\nuntil = \"worn_in\"",
          {"case.toml:", "limit_pressure", "missing"});
  refused("wear_coefficient = 1e-8\nuntil = \"Worn_in\"",
          {"case.toml:17:", "running_in.until", "did you mean \"worn_in\""});
  refused("wear_coefficient = -1e-8\nuntil = \"200 s\"", {"case.toml:16:", "positive"});
  refused("wear_coefficient = 1e-8\nuntil = \"200 s\"\nworn_after = \"1 um\"",
          {"case.toml:18:", "running_in.worn"});
  refused("wear_coefficient = 1e-8\nuntil = \"200 s\"", {"case.toml:", "running_in.", "hardness"});
}
