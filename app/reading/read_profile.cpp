#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/reading/csv_table.hpp"
#include "app/reading/sections.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr double kSame = 1e-9;  ///< positions closer than this are one [rad, m]

/// Sorted positions, those closer than kSame merged.
std::vector<double> merged(std::vector<double> positions) {
  std::sort(positions.begin(), positions.end());
  std::vector<double> result;
  for (const double x : positions) {
    if (result.empty() || x - result.back() > kSame) result.push_back(x);
  }
  return result;
}

std::size_t index_of(const std::vector<double>& positions, double x) {
  const auto at = std::lower_bound(positions.begin(), positions.end(), x - kSame);
  return static_cast<std::size_t>(at - positions.begin());
}

/// An angle within [0, 2 pi), 360 deg being 0 deg.
double within_turn(double phi) {
  phi = std::fmod(phi, 2.0 * kPi);
  if (phi < 0.0) phi += 2.0 * kPi;
  return 2.0 * kPi - phi < kSame ? 0.0 : phi;
}

}  // namespace

bearing::Profile read_profile(const std::string& path, std::string* not_finished) {
  const CsvTable table(path, {{"phi", kAngle}, {"z", kLength}, {"height", kLength}},
                       "phi [deg], z [mm], height [um]");
  if (not_finished != nullptr) *not_finished = table.not_finished();
  if (table.rows() == 0) throw InputError(path, "the profile holds no points");
  std::vector<double> phi = table.column("phi");
  const std::vector<double>& z = table.column("z");
  const std::vector<double>& height = table.column("height");
  const auto [first, last] = std::minmax_element(phi.begin(), phi.end());
  if (*last - *first > 2.0 * kPi + kSame) {
    table.fail(static_cast<std::size_t>(last - phi.begin()), "phi",
               fmt::format("angles from {:.6g} to {:.6g} deg go more than once round; check the "
                           "unit in the first line",
                           *first * 180.0 / kPi, *last * 180.0 / kPi));
  }
  std::transform(phi.begin(), phi.end(), phi.begin(), within_turn);
  bearing::Profile profile;
  profile.phi = merged(phi);
  profile.z = merged(z);
  const std::size_t m = profile.z.size();
  std::map<std::size_t, double> given;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t at = index_of(profile.phi, phi[row]) * m + index_of(profile.z, z[row]);
    const auto [entry, fresh] = given.emplace(at, height[row]);
    if (!fresh && std::abs(entry->second - height[row]) > kSame) {
      table.fail(row, "height",
                 "this position has been given before with another height (0 deg and 360 deg are "
                 "one position)");
    }
  }
  if (given.size() != profile.phi.size() * m) {
    throw InputError(path,
                     fmt::format("the positions form no rectangular grid: {} angles by {} "
                                 "axial positions need {} points, but there are {}",
                                 profile.phi.size(), m, profile.phi.size() * m, given.size()));
  }
  for (const auto& [at, height] : given) profile.height.push_back(height);
  return profile;
}

}  // namespace shellback::app
