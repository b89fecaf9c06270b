// Reading a law of boundary friction, and tables of measured points.
#include "app/reading/identify_case.hpp"
#include "app/reading/measured_table.hpp"
#include "solid/boundary_friction.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

const std::string kLaw = R"([surfaces.contact.friction_law]
abrasive = 0.01
adhesive = 0.05
a = 10.0
b = 300.0
c = 2000.0
summit_radius = "10 um"
)";

std::string rough_with(const std::string& law) {
  return sample_with("[model]", kRoughSurfaces + law + "[model]");
}

std::string rough_changed(const std::string& from, const std::string& to) {
  std::string law = kLaw;
  law.replace(law.find(from), from.size(), to);
  return refusal(rough_with(law));
}

/// What the table's reader says; the path is cut off.
std::string table_refusal(const std::string& text, bool isothermal = true) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("data.csv", text);
  try {
    static_cast<void>(read_measured_table(path, 1, isothermal));
  } catch (const InputError& error) {
    std::string what = error.what();
    if (what.starts_with(path)) what.replace(0, path.size(), "data.csv");
    return what;
  }
  return "";
}

}  // namespace

TEST_CASE("ALawOfBoundaryFrictionIsRead", "[friction_law]") {
  const auto c = read_case_text(rough_with(kLaw), "case.toml");
  REQUIRE(c.surfaces.contact);
  REQUIRE(c.surfaces.contact->friction_law);
  CHECK(c.surfaces.contact->friction_law->b == 300.0);
  CHECK(c.surfaces.contact->friction_law->summit_radius == Approx(1e-5));
  CHECK(c.surfaces.contact->friction_law->orientation == 1.0);
  const bool told = std::any_of(c.assumptions.begin(), c.assumptions.end(), [](const auto& a) {
    return a.find("orientation is taken as 1") != std::string::npos;
  });
  CHECK(told);
  const auto set = read_case_text(rough_with(kLaw), "case.toml",
                                  {parse_override("surfaces.contact.friction_law.b=12")});
  CHECK(set.surfaces.contact->friction_law->b == 12.0);
}

TEST_CASE("AWrongLawOfBoundaryFrictionIsRefusedAtItsLine", "[friction_law]") {
  check_parts(rough_changed("a = 10.0", "a = 1.0"),
              {"friction_law.a", "greater than 1", "a = 10.0"});
  check_parts(rough_changed("b = 300.0", "b = -1"),
              {"friction_law.b", "not be negative", "b = 300"});
  check_parts(rough_changed("abrasive = 0.01", "abrasive = 1.5"), {"abrasive", "between 0 and 1"});
  check_parts(rough_changed("\"10 um\"", "10"), {"summit_radius", "unit", "\"10 um\""});
  check_parts(rough_changed("summit_radius = \"10 um\"\n", ""), {"summit_radius"});
  check_parts(rough_changed("adhesive", "adhesiv"), {"did you mean \"adhesive\""});
  check_parts(rough_changed("b =", "orientation = 2\nreference_length = \"3 um\"\nb ="),
              {"orientation", "keep one"});
  check_parts(refusal(rough_with("friction = 0.02\n" + kLaw)), {"friction", "keep one of them"});
  check_parts(refusal(rough_with("")), {"friction"});  // neither: the constant is asked for
  // with K = 0.001 a radius of 10 m makes summits denser than any surface
  check_parts(rough_changed("\"10 um\"", "\"10 m\""), {"summit_radius", "summit density"});
}

TEST_CASE("MeasuredPointsAreReadInCurvesAlongTheSpeed", "[measured_table]") {
  const ScratchFolder scratch;
  const auto path = scratch.write(
      "data.csv",
      "# rig\nspeed [rpm]; load [kN]; supply_temperature [degC]; friction_torque [N m]; "
      "friction_torque_sd [N mm]\n200; 4; 80; 0.3; 5\n100; 8; 80; 0.5; 5\n100; 4; 80; "
      "0.4; 5\n");
  const MeasuredTable table = read_measured_table(path, 2, false);
  REQUIRE(table.points.size() == 3);
  CHECK(table.deviations_known);
  CHECK(table.points[0].values[0].value == 0.4);  // 4 kN, slowest first
  CHECK(table.points[1].values[0].value == 0.3);
  CHECK(table.points[1].values[0].deviation == Approx(0.005));
  CHECK(table.points[0].curve == table.points[1].curve);
  CHECK(table.points[0].curve != table.points[2].curve);
  const auto at = table.overrides_at(0.5);  // a place between the first two
  REQUIRE(at.size() == 4);
  CHECK(at[0].key == "operation.speed");
  CHECK(at[1].value == "4 kN");
  CHECK(at[3].key == "supply.1.temperature");
  CHECK(at[3].value == "80 degC");
  CHECK(at[0].place.find("data.csv:5") != std::string::npos);
}

TEST_CASE("ABackTemperatureIsGivenToTierIsothermalAndMeasuredOtherwise", "[measured_table]") {
  const ScratchFolder scratch;
  const auto path =
      scratch.write("data.csv",
                    "speed [rpm], shell_back_temperature [degC], friction_torque [N m]\n"
                    "1000, 95, 0.4\n");
  const MeasuredTable isothermal = read_measured_table(path, 1, true);
  CHECK(isothermal.quantities == std::vector<std::string>{"friction_torque"});
  CHECK(isothermal.overrides_at(0.0)[1].key == "measured.shell_back_temperature");
  check_parts(table_refusal("speed [rpm], shell_back_temperature [degC], friction_torque [N m]\n"
                            "1000, 95, 0.4\n",
                            false),
              {"data.csv:1:1", "NAME_sd"});  // two measured quantities weigh by deviations only
}

TEST_CASE("AWrongTableOfMeasurementsIsRefusedAtItsPlace", "[measured_table]") {
  check_parts(table_refusal("speed [rpm], torque [N m]\n1, 2\n"), {"data.csv:1:14", "torque"});
  check_parts(table_refusal("speed [rpm], friction_torque\n1, 2\n"), {"names no unit"});
  check_parts(table_refusal("speed [mm], friction_torque [N m]\n1, 2\n"),
              {"data.csv:1:1", "speed"});
  check_parts(table_refusal("speed [rpm]\n1\n"), {"no column is measured"});
  check_parts(table_refusal("friction_torque [N m]\n1\n"), {"no column says where"});
  check_parts(table_refusal("speed [rpm], friction_torque [N m]\n"), {"no row"});
  check_parts(
      table_refusal("speed [rpm], friction_torque [N m], friction_torque_sd [N m]\n1,2,0\n"),
      {"data.csv:2:5", "must be positive"});
  check_parts(table_refusal("speed [rpm], friction_torque [N m]\n1000, -0.4\n"),
              {"data.csv:2:7", "sign of the speed"});
  // what scatters about zero may lie on its other side
  CHECK(table_refusal("speed [rpm], friction_torque [N m], friction_torque_sd [N m]\n"
                      "1000, -0.01, 0.02\n-1000, -0.4, 0.02\n")
            .empty());
  check_parts(table_refusal("speed [rpm], friction_torque [N m], h_min_sd [um]\n1,2,3\n"),
              {"h_min_sd", "leave it out"});
}

TEST_CASE("KeysAndBoundsThatCannotBeFittedAreRefused", "[identify]") {
  const ScratchFolder scratch;
  const MeasuredTable table = read_measured_table(
      scratch.write("data.csv", "speed [rpm], friction_torque [N m]\n1000, 0.4\n"), 1, false);
  const std::string text = rough_with(kLaw);
  const auto keys = [&](const std::vector<std::string>& fit,
                        const std::vector<std::string>& bounds) {
    return fitted_keys(text, "case.toml", {}, fit, bounds, table);
  };
  const auto against = [&](const std::vector<std::string>& fit,
                           const std::vector<std::string>& bounds) {
    try {
      static_cast<void>(keys(fit, bounds));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string b = "surfaces.contact.friction_law.b";
  const auto good =
      keys({b + ",bearing.radial_clearance"}, {b + "=1:1e4", "bearing.radial_clearance=10 um:50"});
  CHECK(good[0].value.start == 300.0);
  CHECK(good[1].unit == "um");
  CHECK(good[1].words(12.5) == "12.5 um");
  const auto within = keys({b + "=1..1e4,bearing.radial_clearance=10 um..50"}, {});
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(within[k].value.low == good[k].value.low);
    CHECK(within[k].value.high == good[k].value.high);
    CHECK_FALSE(within[k].usual_bounds);
  }
  const auto usual = keys({b}, {});
  CHECK(usual[0].usual_bounds);
  CHECK(usual[0].value.low == 30.0);
  CHECK(usual[0].value.high == 3000.0);
  check_parts(against({b + "=1..1e4"}, {b + "=1:1e4"}), {"--fit " + b, "keep one of them"});
  check_parts(against({b + "=1-1e4"}, {}), {"--fit " + b, "no range", "KEY=FROM..TO"});
  check_parts(against({b}, {b + "=5:1"}), {"not below"});
  check_parts(against({b}, {b + "=1:100"}), {"300", "not between"});
  check_parts(against({b}, {b + "=x:100"}), {"no number"});
  check_parts(against({b}, {b}), {"not KEY=LOW:HIGH"});
  check_parts(against({b, b}, {b + "=1:1e4"}), {"named twice"});
  check_parts(against({b}, {b + "=1:1e4", "x=1:2"}), {"not fitted"});
  check_parts(against({"title"}, {"title=1:2"}), {"no number"});
  check_parts(against({"model.kapa"}, {"model.kapa=1:2"}), {"the case has no model.kapa"});
  check_parts(against({"operation.speed"}, {"operation.speed=1:9000"}), {"column speed"});
  check_parts(against({"bearing.width"}, {"bearing.width=1 cm:9"}), {"in cm", "in mm"});
}
