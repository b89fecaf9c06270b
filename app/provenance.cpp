#include "app/provenance.hpp"

#include <SuiteSparse_config.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <hdf5.h>
#include <sundials/sundials_config.h>
#include <toml++/impl/version.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/provenance_stamp.hpp"

namespace shellback::app {
namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::vector<std::pair<std::string, std::string>> libraries() {
  return {
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"SuiteSparse",
       dotted(SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION)},
      {"SUNDIALS", SUNDIALS_VERSION},
      {"GSL", GSL_VERSION},
      {"HDF5", dotted(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)},
      {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
      {"toml++", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"CLI11", CLI11_VERSION},
#ifdef __clang__
      {"compiler", __VERSION__},
#else
      {"compiler", "GCC " __VERSION__},
#endif
  };
}

}  // namespace

std::string fnv1a_64(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return fmt::format("{:016x}", hash);
}

std::string fingerprint(const bearing::Case& c) {
  std::string all = c.verbatim;
  for (const std::string& text : c.taken_in) all += text;
  return fnv1a_64(all);
}

Provenance provenance(const bearing::Case& c) {
  return {kVersion, kGitState, c.path, fingerprint(c), libraries()};
}

}  // namespace shellback::app
