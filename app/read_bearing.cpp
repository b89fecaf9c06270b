#include <filesystem>

#include "app/sections.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

constexpr double kUsualReference = kZeroCelsius + 20.0;  ///< clearances are measured so [K]

}  // namespace

std::string table_beside(const Section& section, const std::string& key) {
  const std::filesystem::path folder = std::filesystem::path(section.reader().file).parent_path();
  return section.reader().tables.emplace_back((folder / section.text(key)).string());
}

bearing::Bearing read_bearing(const Section& file) {
  const Section section = file.section("bearing");
  section.only({"diameter", "width", "radial_clearance", "reference_temperature", "profile"},
               "[bearing]");
  bearing::Bearing bearing;
  bearing.radius = 0.5 * section.quantity("diameter", kLength, kPositive);
  bearing.width = section.quantity("width", kLength, kPositive);
  bearing.radial_clearance = section.quantity("radial_clearance", kLength, kPositive);
  bearing.reference_temperature =
      section.quantity_or("reference_temperature", kTemperature, kUsualReference,
                          "the radial clearance is taken as measured at 20 degC "
                          "(bearing.reference_temperature is not given)");
  if (section.has("profile")) bearing.profile = read_profile(table_beside(section, "profile"));
  return bearing;
}

}  // namespace shellback::app
