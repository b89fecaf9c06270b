#include <filesystem>

#include "app/reading/sections.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

constexpr double kUsualReference = kZeroCelsius + 20.0;  ///< clearances are measured so [K]

std::optional<bearing::EdgeOpening> read_edge_opening(const Section& section,
                                                      const std::string& key) {
  const auto opening = section.maybe_section(key);
  if (!opening) return std::nullopt;
  opening->only({"depth", "length"}, "bearing." + key);
  return bearing::EdgeOpening{opening->quantity("depth", kLength.such_as("5 um"), kNotNegative),
                              opening->quantity("length", kLength.such_as("5 mm"), kPositive)};
}

}  // namespace

std::string table_beside(const Section& section, const std::string& key) {
  const std::filesystem::path folder = std::filesystem::path(section.reader().file).parent_path();
  const std::string name = section.text(key);
  if (name.empty()) section.fail(key, "this names no file; give that of the table, \"table.csv\"");
  const std::string path = (folder / name).string();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    section.fail_file(key, path +
                               ": there is no such file; a table named in a case is looked for "
                               "from the folder of the case");
  }
  return section.reader().tables.emplace_back(path);
}

namespace {

bearing::Profile profile_of(const Section& section, const std::string& key) {
  std::string not_finished;
  bearing::Profile profile = read_profile(table_beside(section, key), &not_finished);
  if (!not_finished.empty()) section.warn(key, "the table's own words: " + not_finished);
  return profile;
}

}  // namespace

bearing::Bearing read_bearing(const Section& file) {
  const Section section = file.section("bearing");
  section.only({"diameter", "width", "radial_clearance", "reference_temperature", "profile",
                "shape", "edge_relief", "chamfer"},
               "[bearing]");
  bearing::Bearing bearing;
  bearing.radius = 0.5 * section.quantity("diameter", kLength.such_as("50 mm"), kPositive);
  bearing.width = section.quantity("width", kLength.such_as("25 mm"), kPositive);
  bearing.radial_clearance =
      section.quantity("radial_clearance", kLength.such_as("25 um"), kPositive);
  bearing.reference_temperature =
      section.quantity_or("reference_temperature", kTemperature.such_as("20 degC"), kUsualReference,
                          "the radial clearance is taken as measured at 20 degC "
                          "(bearing.reference_temperature is not given)");
  if (section.has("profile")) bearing.profile = profile_of(section, "profile");
  if (section.has("shape")) bearing.shape = profile_of(section, "shape");
  bearing.edge_relief = read_edge_opening(section, "edge_relief");
  bearing.chamfer = read_edge_opening(section, "chamfer");
  return bearing;
}

}  // namespace shellback::app
