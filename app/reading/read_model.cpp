#include "app/reading/did_you_mean.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/sections.hpp"
#include "bearing/case_limits.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

constexpr const ValueRanges& kCan = kValueRanges;

const std::vector<std::string> kTiers{"estimate", "isothermal", "lumped", "thd", "tehd", "auto"};

Switches read_switches(const Section& section) {
  Switches switches;
  switches.pressure_dependence = section.maybe_switch("pressure_dependence");
  switches.shear_thinning = section.maybe_switch("shear_thinning");
  switches.flow_factors = section.maybe_switch("flow_factors");
  switches.asperity_contact = section.maybe_switch("asperity_contact");
  switches.elastic_deformation = section.maybe_switch("elastic_deformation");
  switches.thermal_deformation = section.maybe_switch("thermal_deformation");
  return switches;
}

void read_grid(const Section& section, Model& model) {
  if (!section.has("grid") || section.is_text("grid")) {
    if (section.has("grid") && section.text("grid") != "auto") {
      section.fail("grid",
                   "write \"auto\" or two whole numbers: [200, 25], circumferential and "
                   "axial cells over the full width");
    }
    if (model.tier != Tier::automatic) {  // which chooses its own
      section.assume("the grid is 200 x 25 cells (model.grid is \"auto\" or not given)");
    }
    return;
  }
  model.grid_given = true;
  model.grid = section.pair_of_whole_numbers("grid", kCan.cells[0], kCan.cells[1]);
}

Methods read_methods(const Section& model) {
  Methods m;
  const auto section = model.maybe_section("methods");
  if (!section) return m;
  section->only({"cavitation", "across", "layers", "elastic", "transport", "relaxation"},
                "model.methods");
  if (section->has("cavitation")) {
    m.cavitation = section->choice<CavitationMethod>(
        "cavitation", {{"active-set", CavitationMethod::active_set},
                       {"fischer-burmeister", CavitationMethod::fischer_burmeister},
                       {"p-theta", CavitationMethod::p_theta},
                       {"swift-stieber", CavitationMethod::swift_stieber}});
  }
  if (section->has("across")) {
    m.across = section->choice<AcrossFilm>("across", {{"lobatto", AcrossFilm::lobatto},
                                                      {"layers", AcrossFilm::layers},
                                                      {"mean", AcrossFilm::mean}});
  }
  if (section->has("layers")) {
    m.layers = section->whole_number("layers", kCan.layers[0], kCan.layers[1]);
    if (m.across != AcrossFilm::layers) {
      section->fail("layers", "layers belong to across = \"layers\"");
    }
  }
  if (section->has("elastic")) {
    m.elastic = section->choice<ElasticMethod>(
        "elastic",
        {{"newton", ElasticMethod::newton}, {"fixed-point", ElasticMethod::fixed_point}});
  }
  if (section->has("transport")) {
    m.transport = section->choice<FillTransport>(
        "transport", {{"upwind", FillTransport::upwind}, {"van-leer", FillTransport::van_leer}});
  }
  if (section->has("relaxation")) {
    m.relaxation = section->quantity("relaxation", kNumber.such_as("0.5"), kCan.relaxation);
    if (m.elastic != ElasticMethod::fixed_point) {
      section->fail("relaxation", "relaxation belongs to elastic = \"fixed-point\"");
    }
  }
  return m;
}

void read_rules(const Section& section, Model& model) {
  if (section.has("axial_spacing")) {
    model.axial_spacing = section.choice<AxialSpacing>(
        "axial_spacing", {{"graded", AxialSpacing::graded}, {"even", AxialSpacing::even}});
  }
  if (section.has("cavitated_shear")) {
    model.cavitated_shear = section.choice<CavitatedShear>(
        "cavitated_shear", {{"filled", CavitatedShear::filled}, {"full", CavitatedShear::full}});
  }
  if (section.has("edges")) {
    model.edges =
        section.choice<Edges>("edges", {{"flooded", Edges::flooded}, {"dry", Edges::dry}});
  }
  const auto cavitation =
      section.maybe_gauge_pressure("cavitation_pressure", kPressure.such_as("0 bar"));
  if (cavitation) {
    model.cavitation_pressure = *cavitation;
  } else {
    section.assume(
        "the film is taken to cavitate at ambient pressure "
        "(model.cavitation_pressure = 0 bar)");
  }
  if (!section.has("edges") && model.cavitation_pressure < 0.0) {  // else nothing draws it in
    section.assume("the bearing's edges are taken as flooded with oil (model.edges)");
  }
  if (const auto equivalent = section.maybe_section("equivalent_temperature")) {
    equivalent->only({"kappa"}, "model.equivalent_temperature");
    model.kappa = equivalent->quantity("kappa", kNumber.such_as("1.0"), kCan.kappa);
  }
}

}  // namespace

Tier tier_named(const std::string& name, const std::string& place) {
  if (name == "estimate") return Tier::estimate;
  if (name == "auto") return Tier::automatic;
  if (name == "isothermal") return Tier::isothermal;
  if (name == "lumped") return Tier::lumped;
  if (name == "thd") return Tier::thd;
  if (name == "tehd") return Tier::tehd;
  throw InputError(place, "the tier " + in_quotes(name) + " is not known" +
                              choices_for(name, kTiers, "possible are"));
}

Model read_model(const Section& file) {
  static const toml::table kEmpty;  // a case without [model] relies on the defaults throughout
  const Section section =
      file.maybe_section("model").value_or(Section(file.reader(), kEmpty, "model"));
  section.only(
      {"tier", "tolerance", "grid", "film_nodes", "pressure_dependence", "shear_thinning",
       "flow_factors", "asperity_contact", "elastic_deformation", "thermal_deformation",
       "cavitated_shear", "edges", "axial_spacing", "cavitation_pressure",
       "cavitation_pressure_absolute", "equivalent_temperature", "methods", "coefficients"},
      "[model]");
  Model model;
  if (section.has("tier")) {
    model.tier = tier_named(section.text("tier"), file.reader().place("model.tier"));
  } else {
    section.assume("the tier is tehd (model.tier is not given)");
  }
  model.tolerance = section.quantity_or("tolerance", kNumber, model.tolerance, "", kCan.tolerance);
  read_grid(section, model);
  model.film_nodes_given = section.has("film_nodes");
  if (model.film_nodes_given)
    model.film_nodes = section.whole_number("film_nodes", kCan.film_nodes[0], kCan.film_nodes[1]);
  model.switches = read_switches(section);
  model.methods = read_methods(section);
  read_rules(section, model);
  model.coefficients = section.maybe_switch("coefficients").value_or(false);
  return model;
}

Measured read_measured(const Section& file, double omega) {
  Measured measured;
  const auto section = file.maybe_section("measured");
  if (!section) return measured;
  section->only({"shell_back_temperature", "friction_torque", "h_min", "p_max", "side_flow",
                 "eccentricity_ratio", "T_shell_max"},
                "[measured]");
  measured.shell_back_temperature = section->maybe_quantity("shell_back_temperature", kTemperature);
  measured.friction_torque = section->maybe_quantity("friction_torque", kTorque);
  if (measured.friction_torque && *measured.friction_torque < 0.0) {
    if (!(omega < 0.0)) {
      section->fail("friction_torque",
                    "a friction torque has the sign of the speed, which is not negative here; give "
                    "its magnitude");
    }
    *measured.friction_torque *= -1.0;  // kept as a magnitude
  }
  measured.h_min = section->maybe_quantity("h_min", kLength.such_as("2 um"), kNotNegative);
  measured.p_max = section->maybe_quantity("p_max", kPressure.such_as("50 MPa"));
  measured.side_flow = section->maybe_quantity("side_flow", kFlow, kNotNegative);
  measured.eccentricity_ratio =
      section->maybe_quantity("eccentricity_ratio", kNumber.such_as("0.6"), kNotNegative);
  measured.T_shell_max = section->maybe_quantity("T_shell_max", kTemperature);
  return measured;
}

}  // namespace shellback::app
