#include <fmt/format.h>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/library.hpp"
#include "app/reading/sections.hpp"

namespace shellback::app {
namespace {

using namespace rheology;

constexpr double kPerGiga = 1e9;      ///< 1/Pa to 1/GPa
constexpr double kBarusEnds = 200e6;  ///< docs/models.md: Roelands lies below it beyond [Pa]

/// A value written as text alone ("832.5 kg/m3") is the constant law.
bool is_constant(const Section& oil, const std::string& key) { return !oil.is_table(key); }

void assume_missing(const Section& oil, const std::string& key, const std::string& value) {
  oil.assume(fmt::format("oil: no {} is given; {} is assumed", key, value));
}

/// The pressure part as C1 and C2 of rho0 (C1 + C2 p)/(C1 + p), which belong together; without
/// them the printed constants.
void read_compressibility(const Section& law, DowsonHigginson& density) {
  constexpr Range kRising{1.0, kInfinite, true, "exceed 1, as the density rises to C2 rho0"};
  if (!law.has("C1") && !law.has("C2")) {
    law.assume(
        fmt::format("oil: no C1 and C2 are given for the density; C1 = {:.4g} MPa, C2 = {:.4g} "
                    "(Dowson and Higginson) are assumed",
                    1e-6 / density.limit, 1.0 + density.rise / density.limit));
    return;
  }
  if (!law.has("C1")) law.fail_missing("C1", "\"2.22 GPa\", to go with C2");
  if (!law.has("C2")) law.fail_missing("C2", "1.66, to go with C1");
  const double C1 = law.quantity("C1", kPressure.such_as("2.22 GPa"), kPositive);
  const double C2 = law.quantity("C2", kNumber.such_as("1.66"), kRising);
  density.rise = (C2 - 1.0) / C1;
  density.limit = 1.0 / C1;
}

DensityLaw read_density(const Section& oil) {
  if (!oil.has("density")) {
    assume_missing(oil, "density", "860 kg/m3");
    return ConstantDensity{860.0};
  }
  if (is_constant(oil, "density")) {
    return ConstantDensity{oil.quantity("density", kDensity, kPositive)};
  }
  const Section law = oil.law("density");
  enum class Law { constant, dowson_higginson };
  const Law which = law.choice<Law>(
      "law", {{"constant", Law::constant}, {"dowson-higginson", Law::dowson_higginson}});
  if (which == Law::constant) {
    law.only({"law", "rho"}, "a constant density");
    return ConstantDensity{law.quantity("rho", kDensity, kPositive)};
  }
  law.only({"law", "rho0", "at", "expansivity", "C1", "C2"}, "a density law \"dowson-higginson\"");
  DowsonHigginson density{
      law.quantity("rho0", kDensity, kPositive), law.quantity("at", kTemperature),
      law.quantity("expansivity", kPerKelvin.such_as("7e-4 1/K"), kNotNegative)};
  read_compressibility(law, density);
  return density;
}

ConductivityLaw read_conductivity(const Section& oil) {
  if (!oil.has("conductivity")) {
    assume_missing(oil, "conductivity", "0.14 W/(m K)");
    return ConstantConductivity{0.14};
  }
  if (is_constant(oil, "conductivity")) {
    return ConstantConductivity{oil.quantity("conductivity", kConductivity, kPositive)};
  }
  const Section law = oil.law("conductivity");
  enum class Law { constant, pressure, temperature };
  const Law which = law.choice<Law>("law", {{"constant", Law::constant},
                                            {"pressure", Law::pressure},
                                            {"temperature", Law::temperature}});
  if (which == Law::constant) {
    law.only({"law", "k"}, "a constant conductivity");
    return ConstantConductivity{law.quantity("k", kConductivity, kPositive)};
  }
  if (which == Law::pressure) {
    law.only({"law", "a", "b", "c"}, "a conductivity law \"pressure\"");
    return PressureConductivity{law.quantity("a", kConductivity, kPositive),
                                law.quantity("b", kPerPressure, kNotNegative) * kPerGiga,
                                law.quantity("c", kPerPressure, kNotNegative) * kPerGiga};
  }
  law.only({"law", "a", "b", "s"}, "a conductivity law \"temperature\"");
  return TemperatureConductivity{law.quantity("a", kConductivity, kPositive),
                                 law.quantity("b", kPerKelvin),
                                 law.quantity("s", kNumber, kPositive)};
}

HeatCapacityLaw read_heat_capacity(const Section& oil) {
  if (!oil.has("heat_capacity")) {
    assume_missing(oil, "heat_capacity", "2000 J/(kg K)");
    return ConstantHeatCapacity{2000.0};
  }
  if (is_constant(oil, "heat_capacity")) {
    return ConstantHeatCapacity{oil.quantity("heat_capacity", kHeatCapacity, kPositive)};
  }
  const Section law = oil.law("heat_capacity");
  enum class Law { constant, temperature };
  const Law which =
      law.choice<Law>("law", {{"constant", Law::constant}, {"temperature", Law::temperature}});
  if (which == Law::constant) {
    law.only({"law", "cp"}, "a constant heat capacity");
    return ConstantHeatCapacity{law.quantity("cp", kHeatCapacity, kPositive)};
  }
  law.only({"law", "a", "b", "s", "n"}, "a heat capacity law \"temperature\"");
  return TemperatureHeatCapacity{law.quantity("a", kHeatCapacity, kPositive),
                                 law.quantity("b", kHeatCapacitySlope),
                                 law.quantity("s", kNumber, kPositive), law.quantity("n", kNumber)};
}

/// `pressure`: its law, which tells how far it goes where the case does not.
ValidityRange read_range(const Section& oil, const PressureLaw& pressure) {
  ValidityRange range;
  if (std::holds_alternative<rheology::Barus>(pressure)) range.p_max = kBarusEnds;
  const auto valid = oil.maybe_section("valid");
  if (!valid) {
    oil.assume(
        "oil: no range of validity is given (oil.valid); the laws are used at any temperature and "
        "shear rate");
    return range;
  }
  valid->only({"temperature", "pressure", "shear_rate"}, "oil.valid");
  if (valid->has("temperature")) {
    const auto [low, high] =
        valid->pair_of_quantities("temperature", kTemperature, "[\"20 degC\", \"150 degC\"]");
    if (low >= high) valid->fail("temperature", "the first temperature must be the lower one");
    range.T_min = low;
    range.T_max = high;
  }
  range.p_max =
      valid->quantity_or("pressure", kPressure.such_as("200 MPa"), range.p_max, "", kPositive);
  range.rate_max = valid->quantity_or("shear_rate", kShearRate, range.rate_max, "", kPositive);
  return range;
}

void read_viscosity(const Section& oil_section, Oil& oil) {
  const Section viscosity = oil_section.section("viscosity");
  viscosity.only({"temperature", "pressure", "shear"}, "oil.viscosity");
  if (!viscosity.has("temperature")) {
    viscosity.fail_missing("temperature",
                           "{ law = \"vogel\", A = \"0.0952 mPa s\", B = "
                           "\"896.4 K\", C = \"110 K\" }");
  }
  oil.temperature = read_temperature_law(viscosity.law("temperature"), oil.density);
  if (viscosity.has("pressure")) {
    oil.pressure = read_pressure_law(viscosity.law("pressure"));
  } else {
    oil_section.assume("oil: no viscosity.pressure is given; pressure is taken to have no effect");
  }
  if (viscosity.has("shear")) {
    oil.shear = read_shear_law(viscosity.law("shear"));
  } else {
    oil_section.assume("oil: no viscosity.shear is given; the oil is taken as Newtonian");
  }
}

/// [oil], with the shipped oil of that name behind it if there is one.
Section oil_section(const Section& file) {
  const Section own = file.section("oil");
  if (!own.has("name")) {
    if (!own.has("viscosity")) {
      own.fail("", fmt::format("the oil has neither name nor viscosity; shipped oils are: {}",
                               comma_list(shipped_oils())));
    }
    return own;
  }
  const std::string name = own.text("name");
  const toml::table* shipped = find_oil(own.reader(), name);
  if (shipped != nullptr) {
    return {own.reader(), *own.table(), "oil", shipped};
  }
  const auto laws = own.maybe_section("viscosity");
  if (!laws || !laws->has("temperature")) {
    own.fail("name",
             fmt::format("there is no shipped oil {}{}; or give viscosity.temperature "
                         "inline",
                         in_quotes(name), choices_for(name, shipped_oils(), "shipped are")));
  }
  return own;
}

/// Properties that the case gives itself in place of those of a shipped oil: the shipped statements
/// are of the others.
std::vector<std::string> own_properties(const Section& file) {
  const Section own = file.section("oil");
  std::vector<std::string> properties;
  if (!own.has("name") || find_oil(own.reader(), own.text("name")) == nullptr) return properties;
  for (const char* key : {"density", "conductivity", "heat_capacity", "valid"}) {
    if (own.has(key)) properties.emplace_back(key);
  }
  if (const auto laws = own.maybe_section("viscosity")) {
    for (const char* key : {"temperature", "pressure", "shear"}) {
      if (laws->has(key)) properties.push_back(std::string("viscosity.") + key);
    }
  }
  return properties;
}

}  // namespace

Oil read_oil(const Section& file) {
  const Section section = oil_section(file);
  const std::vector<std::string> own = own_properties(file);
  section.only({"name", "title", "source", "note", "density", "conductivity", "heat_capacity",
                "temperature", "viscosity", "valid", "assumed"},
               "[oil]");
  Oil oil;
  oil.name = section.has("name") ? section.text("name") : "inline";
  for (const char* label : {"title", "source", "note"}) {  // words for the reader of the file
    if (section.has(label)) static_cast<void>(section.text(label));
  }
  oil.density = read_density(section);
  read_viscosity(section, oil);
  oil.conductivity = read_conductivity(section);
  oil.heat_capacity = read_heat_capacity(section);
  oil.range = read_range(section, oil.pressure);
  oil.assumed = section.texts("assumed");
  if (!own.empty()) {
    section.assume(
        fmt::format("oil {}: {} of this case instead of the shipped", oil.name, comma_list(own)));
  }
  for (const std::string& statement : oil.assumed) {
    section.assume(
        fmt::format("oil {}{}: {}", oil.name, own.empty() ? "" : ", shipped values", statement));
  }
  return oil;
}

std::optional<double> read_oil_temperature(const Section& file) {
  return file.section("oil").maybe_quantity("temperature", kTemperature);
}

}  // namespace shellback::app
