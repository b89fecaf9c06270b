#include <fmt/format.h>

#include <cmath>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/sections.hpp"
#include "bearing/case_limits.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using bearing::Supply;
using bearing::SupplyKind;

constexpr double kFullCircle = 2.0 * kPi;  ///< [rad]

/// A hole of the shell, or the mouth of a drilling of the journal.
void read_hole(const Section& section, double radius, Supply& supply) {
  const bool drilling = supply.kind == SupplyKind::drilling;
  if (drilling && section.has("heat_transfer")) {
    section.fail("heat_transfer", "a drilling has no surface that the film sees; remove the key");
  }
  if (drilling) {
    section.only({"kind", "angle", "z", "diameter", "pressure", "pressure_absolute", "temperature",
                  "vessel_volume", "vessel_bulk_modulus", "open"},
                 "a supply of kind \"drilling\"");
    supply.carry_over = 0.0;  // what is pressed back into it does not come again
  }
  section.only(
      {"kind", "angle", "z", "diameter", "depth", "pressure", "pressure_absolute", "temperature",
       "carry_over", "heat_transfer", "vessel_volume", "vessel_bulk_modulus", "open"},
      "a supply of kind \"hole\"");
  supply.angle = section.quantity("angle", kAngle, bearing::kValueRanges.turn);
  supply.diameter = section.quantity("diameter", kLength.such_as("5 mm"), kPositive);
  supply.arc = supply.diameter / radius;
  supply.length = supply.diameter;
}

void read_axial_groove(const Section& section, double radius, Supply& supply) {
  section.only({"kind", "angle", "z", "arc", "width", "length", "depth", "pressure",
                "pressure_absolute", "temperature", "carry_over", "heat_transfer", "vessel_volume",
                "vessel_bulk_modulus", "open"},
               "a supply of kind \"axial_groove\"");
  supply.angle = section.quantity("angle", kAngle, bearing::kValueRanges.turn);
  supply.length = section.quantity("length", kLength.such_as("10 mm"), kPositive);
  if (section.has("arc") && section.has("width")) {
    section.fail("width", "the groove's arc is given too; keep one of them");
  }
  if (!section.has("arc") && !section.has("width")) {
    section.fail("arc",
                 "the groove has no circumferential size; give arc = \"18 deg\" or "
                 "width = \"5 mm\"");
  }
  supply.arc = section.has("arc")
                   ? section.quantity("arc", kAngle.such_as("18 deg"), bearing::kValueRanges.arc)
                   : section.quantity("width", kLength.such_as("5 mm"), kNotNegative) / radius;
}

void read_circumferential_groove(const Section& section, Supply& supply) {
  section.only({"kind", "angle", "z", "extent", "width", "depth", "pressure", "pressure_absolute",
                "temperature", "carry_over", "heat_transfer", "vessel_volume",
                "vessel_bulk_modulus", "open"},
               "a supply of kind \"circumferential_groove\"");
  supply.arc = section.quantity_or("extent", kAngle, kFullCircle, "", bearing::kValueRanges.extent);
  if (supply.arc < kFullCircle)
    supply.angle = section.quantity("angle", kAngle, bearing::kValueRanges.turn);
  if (supply.arc >= kFullCircle) {
    supply.angle = section.quantity_or("angle", kAngle, 0.0, "", bearing::kValueRanges.turn);
  }
  supply.length = section.quantity("width", kLength.such_as("5 mm"), kPositive);
}

std::optional<bearing::Vessel> read_vessel(const Section& section, double omega) {
  if (!section.has("vessel_volume")) {
    for (const char* key : {"vessel_bulk_modulus", "open"}) {
      if (section.has(key)) section.fail(key, "belongs to a vessel; give vessel_volume, too");
    }
    return std::nullopt;
  }
  bearing::Vessel vessel;
  vessel.volume = section.quantity("vessel_volume", kVolume, kPositive);
  vessel.bulk_modulus = section.quantity_or(
      "vessel_bulk_modulus", kPressure.such_as("1.5 GPa"), vessel.bulk_modulus,
      fmt::format("{}: oil and vessel together have a bulk modulus of 1.5 GPa, that of mineral oil "
                  "without air in a stiff vessel",
                  section.name("")),
      kPositive);
  if (!section.has("open")) {
    section.fail_missing("open", "[\"0 deg\", \"360 deg\"] (from, to; [] for a line that is shut)");
  }
  const std::vector<std::string> edges = section.texts("open");
  if (edges.size() % 2 != 0) {
    section.fail("open", "windows have a beginning and an end each; give an even number of them");
  }
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    vessel.open.push_back({read_instant(section, "open", edges[k], omega),
                           read_instant(section, "open", edges[k + 1], omega)});
  }
  return vessel;
}

/// Heat between a supply's oil and the walls: a value, or the law of a channel of its depth.
void read_heat_transfer(const Section& section, Supply& supply) {
  const char* const key = "heat_transfer";
  const bool given = section.has(key);
  if (supply.kind == SupplyKind::axial_groove && supply.arc == 0.0) {
    if (!given) return;
    section.fail(key, "a groove without circumferential extent has no surface; give arc or width");
  }
  const std::string text = given && section.is_text(key) ? section.text(key) : "";
  const bool word = text == "channel";
  if (const std::string near = did_you_mean(text, {"channel"}); !word && !near.empty()) {
    section.fail(key, in_quotes(text) + " is no heat transfer" + near);
  }
  if (word || (!given && section.has("depth"))) {
    supply.heat_transfer = bearing::ChannelHeat{};
  } else if (given) {
    supply.heat_transfer = section.quantity(key, kHeatTransfer, bearing::kValueRanges.groove_heat);
  }
  if (given) return;
  section.assume(
      section.has("depth")
          ? fmt::format("{}: in tiers with heat its oil exchanges it with the walls like "
                        "laminar flow in a channel of its depth (heat_transfer = "
                        "\"channel\")",
                        section.name(""))
          : fmt::format("{}: in tiers with heat its oil exchanges none with the walls "
                        "(no depth and no heat_transfer is given)",
                        section.name("")));
}

Supply read_supply(const Section& section, double radius,
                   const std::optional<double>& oil_temperature, double omega) {
  Supply supply;
  supply.kind = section.choice<SupplyKind>(
      "kind", {{"hole", SupplyKind::hole},
               {"axial_groove", SupplyKind::axial_groove},
               {"circumferential_groove", SupplyKind::circumferential_groove},
               {"drilling", SupplyKind::drilling}});
  const bool drilling = supply.kind == SupplyKind::drilling;
  if (supply.kind == SupplyKind::hole || drilling) read_hole(section, radius, supply);
  if (supply.kind == SupplyKind::axial_groove) read_axial_groove(section, radius, supply);
  if (supply.kind == SupplyKind::circumferential_groove) {
    read_circumferential_groove(section, supply);
  }
  const std::string name = section.name("");
  supply.angle -= kFullCircle * std::floor(supply.angle / kFullCircle);
  supply.z = section.quantity_or("z", kLength.such_as("0 mm"), 0.0, "");
  if (!drilling) {
    supply.depth =
        section.quantity_or("depth", kLength.such_as("1 mm"), supply.depth,
                            fmt::format("{}: a depth of 1 mm is assumed", name), kPositive);
  }
  const auto pressure = section.maybe_gauge_pressure("pressure");
  if (!pressure) section.fail_missing("pressure", "\"2 bar\" (gauge) or pressure_absolute");
  supply.pressure = *pressure;
  if (!drilling) {
    supply.carry_over = section.quantity_or(
        "carry_over", kNumber.such_as("1.0"), supply.carry_over,
        fmt::format("{}: all film oil that enters it is taken to be mixed in again "
                    "(carry_over = 1)",
                    name),
        kUpToOne);
  }
  if (!drilling) read_heat_transfer(section, supply);
  if (!section.has("temperature") && !oil_temperature) {
    section.fail_missing("temperature", "\"80 degC\"");
  }
  supply.temperature =
      section.quantity_or("temperature", kTemperature, oil_temperature.value_or(0.0),
                          fmt::format("{}: the oil is taken to enter at oil.temperature", name));
  supply.vessel = read_vessel(section, omega);
  return supply;
}

}  // namespace

std::vector<Supply> read_supplies(const Section& file, double radius,
                                  const std::optional<double>& oil_temperature, double omega) {
  std::vector<Supply> supplies;
  for (const Section& section : file.sections("supply")) {
    supplies.push_back(read_supply(section, radius, oil_temperature, omega));
  }
  return supplies;
}

}  // namespace shellback::app
