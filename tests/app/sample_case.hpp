#pragma once
/// A complete case as text, and how the reader takes changes to it.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/reading/read_case.hpp"
#include "core/contract.hpp"

namespace shellback::app {

/// A folder of this process alone: tests run side by side. Goes with the object.
class ScratchFolder {
 public:
  ScratchFolder()
      : folder_(std::filesystem::temp_directory_path() /
                ("shellback_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

/// All data inline: independent of the shipped oils and materials.
inline const std::string kSampleCase = R"toml(title = "sample"

[bearing]
diameter = "50 mm"
width = "25 mm"
radial_clearance = "25 um"

[[supply]]
kind = "hole"
angle = "90 deg"
diameter = "5 mm"
pressure = "2 bar"
temperature = "80 degC"

[operation]
speed = "3000 rpm"
load = "5 kN"

[oil]
density = "850 kg/m3"
conductivity = "0.14 W/(m K)"
heat_capacity = "2000 J/(kg K)"
viscosity.temperature = { law = "vogel", A = "0.0952 mPa s", B = "896.4 K", C = "110 K" }
viscosity.pressure = { law = "barus", alpha = "9.5e-9 1/Pa" }
viscosity.shear = { law = "cross", r = 0.5, K = "4.5e-8 s", m = 0.457 }
temperature = "90 degC"
valid = { temperature = ["20 degC", "150 degC"], pressure = "200 MPa", shear_rate = "1e7 1/s" }

[shell]
layers = [ { material = { conductivity = "50 W/(m K)", density = "7800 kg/m3", heat_capacity = "460 J/(kg K)", youngs_modulus = "200 GPa", poisson_ratio = 0.3, expansion = "1.1e-5 1/K" }, thickness = "2 mm" } ]
back = { heat_transfer = "500 W/(m2 K)", ambient = "70 degC" }

[shaft]
material = { conductivity = "46 W/(m K)", density = "7800 kg/m3", heat_capacity = "460 J/(kg K)", youngs_modulus = "210 GPa", poisson_ratio = 0.3, expansion = "1.2e-5 1/K" }

[model]
tier = "tehd"
)toml";

/// Surfaces that may touch, for a case.
inline const std::string kRoughSurfaces = R"([surfaces.shell]
roughness = "0.34 um"
summit_roughness = "0.28 um"
summit_height = "0.39 um"
[surfaces.shaft]
roughness = "0.20 um"
[surfaces.contact]
elastic_factor = 0.001
composite_modulus = "53.3 GPa"
)";

/// The sample with the first `from` replaced by `to`.
inline std::string sample_with(const std::string& from, const std::string& to) {
  std::string text = kSampleCase;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// What the reader says against the text; "" if it takes it.
inline std::string refusal(const std::string& text, const std::vector<std::string>& set = {}) {
  try {
    std::vector<Override> overrides;
    for (const std::string& words : set) overrides.push_back(parse_override(words));
    static_cast<void>(read_case_text(text, "case.toml", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline void check_parts(const std::string& what, const std::vector<std::string>& parts) {
  INFO(what);
  CHECK(!what.empty());
  for (const std::string& part : parts) {
    INFO("wanted: " << part);
    CHECK(what.find(part) != std::string::npos);
  }
}

/// The sample with one replacement is refused with these words, the first at the beginning.
inline void check_refused(const std::string& from, const std::string& to,
                          const std::vector<std::string>& parts) {
  const std::string what = refusal(sample_with(from, to));
  INFO("changed to: " << to);
  check_parts(what, parts);
  CHECK(what.find(parts.front()) == 0);
}

inline bearing::Case read_sample(const std::string& from, const std::string& to) {
  return read_case_text(sample_with(from, to), "case.toml");
}

}  // namespace shellback::app
