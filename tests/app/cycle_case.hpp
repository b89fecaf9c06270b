#pragma once
/// The sample case with a load over time: from a table, or from a crank and its pressures.
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "tests/app/sample_case.hpp"

namespace shellback::app {

inline constexpr double kDeg = kPi / 180.0;
inline constexpr double kOmega = 100.0 * kPi;  // 3000 rpm [rad/s]
inline constexpr double kTurn = 0.02;          // time of a turn [s]

inline const std::string kInDegrees = "[load_cycle]\nfile = \"load.csv\"\nperiod = \"360 deg\"\n";
inline const std::string kInTime = "[load_cycle]\nfile = \"load.csv\"\nperiod = \"20 ms\"\n";
inline const std::string kCrank =
    "[crank]\nstroke = \"137 mm\"\nrod_length = \"207 mm\"\nbore = \"105 mm\"\npiston_mass = "
    "\"2.5 kg\"\nrod_mass = \"1.6 kg\"\npressure = \"p.csv\"\n";
inline const std::string kRows =
    "angle [deg], load_x [N], load_y [N]\n0, 0, -1000\n90, 500, -2000\n180, 0, -3000\n"
    "270, -500, -2000\n";
inline const std::string kTrace = "angle [deg], pressure [bar]\n0, 140\n90, 10\n360, 3\n630, 20\n";

/// The sample with sections in place of its load.
inline std::string sample_of(const std::string& sections, const std::string& speed = "3000 rpm") {
  std::string text = sample_with("load = \"5 kN\"\n", "\n" + sections);
  text.replace(text.find("3000 rpm"), 8, speed);
  return text.replace(text.find("tier = \"tehd\""), 13, "tier = \"isothermal\"");
}

inline bearing::Case read(const ScratchFolder& folder, const std::string& sections,
                          const std::string& table, const std::string& speed = "3000 rpm") {
  folder.write("load.csv", table);
  folder.write("p.csv", table);
  return read_case_text(sample_of(sections, speed), folder.path("case.toml"));
}

inline bearing::LoadCycle cycle_of(const std::string& sections, const std::string& table,
                                   const std::string& speed = "3000 rpm") {
  const ScratchFolder folder;
  const auto c = read(folder, sections, table, speed);
  REQUIRE(c.cycle);
  return *c.cycle;
}

/// What is said against it, the folder's name taken out.
inline std::string against(const std::string& sections, const std::string& table,
                           const std::string& speed = "3000 rpm") {
  const ScratchFolder folder;
  try {
    static_cast<void>(read(folder, sections, table, speed));
  } catch (const InputError& error) {
    std::string what = error.what();
    const std::string name = folder.path("");
    for (std::size_t at = what.find(name); at != std::string::npos; at = what.find(name)) {
      what.erase(at, name.size());
    }
    return what;
  }
  return "";
}

inline void check_against(const std::string& table, const std::vector<std::string>& parts,
                          const std::string& sections = kInDegrees) {
  const std::string what = against(sections, table);
  check_parts(what, parts);
  CHECK(what.find(parts.front()) == 0);
}

}  // namespace shellback::app
