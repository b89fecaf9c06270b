#include <fmt/format.h>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/library.hpp"
#include "app/reading/sections.hpp"
#include "bearing/case_limits.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

/// `in_part`: some of the values are the case's own, and the shipped statements are of the others.
solid::Material read_properties(const Section& section, const std::string& name,
                                bool in_part = false) {
  section.only({"name", "title", "source", "note", "assumed", "conductivity", "density",
                "heat_capacity", "youngs_modulus", "poisson_ratio", "expansion", "hardness",
                "limit_temperature", "progression_rate", "damping_ratio"},
               "a material");
  for (const char* label : {"title", "source", "note"}) {  // words for the reader of the file
    if (section.has(label)) static_cast<void>(section.text(label));
  }
  solid::Material material;
  material.name = section.has("name") ? section.text("name") : name;
  material.conductivity =
      section.quantity("conductivity", kConductivity.such_as("50 W/(m K)"), kPositive);
  material.density = section.quantity("density", kDensity.such_as("7800 kg/m3"), kPositive);
  material.heat_capacity =
      section.quantity("heat_capacity", kHeatCapacity.such_as("460 J/(kg K)"), kPositive);
  material.youngs_modulus =
      section.quantity("youngs_modulus", kPressure.such_as("200 GPa"), kPositive);
  material.poisson_ratio =
      section.quantity("poisson_ratio", kNumber.such_as("0.3"), kValueRanges.poisson_ratio);
  material.expansion =
      section.quantity("expansion", kPerKelvin.such_as("1.2e-5 1/K"), kNotNegative);
  material.hardness =
      section.quantity_or("hardness", kPressure.such_as("600 MPa"), 0.0, "", kPositive);
  material.limit_temperature = section.quantity_or(
      "limit_temperature", kTemperature.such_as("170 degC"), 0.0, "", kValueRanges.temperature);
  material.progression =
      section.quantity_or("progression_rate", kNumber.such_as("1.0"), 0.0, "", kNotNegative);
  material.damping_ratio =
      section.quantity_or("damping_ratio", kTime.such_as("1e-4 s"), 0.0, "", kPositive);
  for (const std::string& statement : section.texts("assumed")) {
    const std::string sentence = fmt::format("material {}{}: {}", material.name,
                                             in_part ? ", shipped values" : "", statement);
    auto& known = section.reader().assumptions;
    bool said = false;
    for (const std::string& s : known) said = said || s == sentence;
    if (!said) known.push_back(sentence);
  }
  return material;
}

Housing read_housing(const Section& section) {
  section.only({"material", "outer_diameter", "support", "joint_conductance"}, "shell.housing");
  Housing housing;
  housing.material = read_material(section, "material");
  housing.outer_radius =
      0.5 * section.quantity("outer_diameter", kLength.such_as("100 mm"), kPositive);
  housing.joint_conductance =
      section.quantity_or("joint_conductance", kHeatTransfer, 0.0, "", kValueRanges.joint);
  if (section.has("support")) {
    housing.support =
        section.choice<HousingSupport>("support", {{"held", HousingSupport::held},
                                                   {"free", HousingSupport::free},
                                                   {"clamped", HousingSupport::clamped}});
  } else {
    section.assume(
        "shell.housing: its outside is taken as held under load and free to grow with "
        "temperature (support = \"held\")");
  }
  return housing;
}

std::variant<ConvectiveBack, PrescribedBack> read_back(const Section& section) {
  section.only({"heat_transfer", "ambient", "temperature"}, "shell.back");
  if (section.has("temperature") && section.has("heat_transfer")) {
    section.fail("heat_transfer", "the temperature of the back is given too; keep one of them");
  }
  if (section.has("temperature")) {
    return PrescribedBack{section.quantity("temperature", kTemperature)};
  }
  if (!section.has("heat_transfer")) {
    section.fail("heat_transfer",
                 "it is not said how heat leaves the back; give heat_transfer = "
                 "\"500 W/(m2 K)\" with ambient, or temperature");
  }
  return ConvectiveBack{section.quantity("heat_transfer", kHeatTransfer, kPositive),
                        section.quantity("ambient", kTemperature)};
}

[[noreturn]] void fail_unknown(const Section& section, const std::string& key,
                               const std::string& name, const std::string& cure) {
  section.fail(
      key,
      fmt::format("there is no shipped material {}{}; or {}", in_quotes(name),
                  choices_for(name, shipped_materials(section.reader()), "shipped are"), cure));
}

/// A table whose name is that of a shipped material changes single values of it.
solid::Material read_own_material(const Section& own) {
  const std::string name = own.has("name") ? own.text("name") : "inline";
  const toml::table* shipped = find_material(own.reader(), name);
  if (shipped == nullptr) {
    if (own.has("name") && !own.has("conductivity"))
      fail_unknown(own, "name", name, "give all of its values");
    return read_properties(own, name);
  }
  std::vector<std::string> changed;
  for (auto&& [key, node] : *own.table()) {
    if (shipped->contains(key)) changed.emplace_back(key.str());
  }
  if (!changed.empty()) {
    own.assume(fmt::format("material {}: {} of this case instead of the shipped", name,
                           comma_list(changed)));
  }
  return read_properties(Section(own.reader(), *own.table(), own.name(""), shipped), name,
                         !changed.empty());
}

}  // namespace

solid::Material read_material(const Section& section, const std::string& key) {
  if (section.is_table(key)) return read_own_material(section.section(key));
  if (!section.has(key)) section.fail_missing(key, "\"steel\"");
  const std::string name = section.text(key);
  const toml::table* shipped = find_material(section.reader(), name);
  if (shipped == nullptr) fail_unknown(section, key, name, "write its values as a table");
  return read_properties(Section(section.reader(), *shipped, section.name(key)), name);
}

std::optional<Shell> read_shell(const Section& file) {
  const auto section = file.maybe_section("shell");
  if (!section) return std::nullopt;
  section->only({"layers", "housing", "back", "end_heat_transfer"}, "[shell]");
  Shell shell;
  for (const Section& layer : section->sections("layers")) {
    layer.only({"material", "thickness", "elasto_plastic"}, "a layer of the shell");
    if (layer.is_text("elasto_plastic")) layer.fail("elasto_plastic", "it is either true or false");
    shell.layers.push_back({read_material(layer, "material"),
                            layer.quantity("thickness", kLength.such_as("1 mm"), kPositive),
                            layer.maybe_switch("elasto_plastic").value_or(false)});
  }
  if (const auto housing = section->maybe_section("housing")) {
    shell.housing = read_housing(*housing);
  } else {
    section->assume(
        "shell.housing is not given: the shell's back is taken as held under load and free to grow "
        "with temperature");
  }
  if (const auto back = section->maybe_section("back")) shell.back = read_back(*back);
  if (shell.housing && std::holds_alternative<PrescribedBack>(shell.back)) {
    section->assume(
        "shell.back.temperature is that of the shell's back, in the housing: no heat is followed "
        "through the housing");
  }
  shell.end_heat_transfer = section->quantity_or(
      "end_heat_transfer", kHeatTransfer, shell.end_heat_transfer,
      "the end faces of shell and housing are taken to give off heat at 50 W/(m2 K)", kNotNegative);
  return shell;
}

std::optional<Shaft> read_shaft(const Section& file) {
  const auto section = file.maybe_section("shaft");
  if (!section) return std::nullopt;
  section->only({"material", "overhang", "elastic_overhang", "span", "heat_transfer", "ambient"},
                "[shaft]");
  Shaft shaft;
  shaft.material = read_material(*section, "material");
  shaft.overhang = section->quantity_or(
      "overhang", kLength, 0.0,
      "the shaft is taken to end at the bearing's edges: no heat leaves along it "
      "(shaft.overhang is not given)",
      kNotNegative);
  shaft.elastic_overhang = section->maybe_quantity("elastic_overhang", kLength, kNotNegative);
  if (!shaft.elastic_overhang) {
    section->assume(
        "where surfaces are elastic the shaft is taken to go on beyond the bearing by its "
        "overhang, "
        "at least by one radius (shaft.elastic_overhang is not given)");
  }
  shaft.span = section->maybe_quantity("span", kLength.such_as("100 mm"), kPositive);
  if (shaft.overhang > 0.0) {
    shaft.heat_transfer = section->quantity("heat_transfer", kHeatTransfer, kNotNegative);
    shaft.ambient = section->quantity("ambient", kTemperature);
    return shaft;
  }
  const auto rate = section->maybe_quantity("heat_transfer", kHeatTransfer, kNotNegative);
  const auto ambient = section->maybe_quantity("ambient", kTemperature);
  if (rate || ambient) {
    section->assume(
        "shaft.heat_transfer and shaft.ambient are those of its overhang, of which there is none");
  }
  return shaft;
}

}  // namespace shellback::app
