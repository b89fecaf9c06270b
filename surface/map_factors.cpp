#include "surface/map_factors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract.hpp"
#include "core/parallel.hpp"

namespace shellback::surface {
namespace {

constexpr int kQuarters = 4;

constexpr std::array kFactors{&FactorRow::contact, &FactorRow::average_gap, &FactorRow::phi_x,
                              &FactorRow::phi_z,   &FactorRow::phi_s,       &FactorRow::phi_f,
                              &FactorRow::phi_fs,  &FactorRow::phi_fp};

/// A quarter of the map as a map of its own: its mean is 0.
HeightMap quarter(const HeightMap& map, int which) {
  const int nx = map.nx / 2, ny = map.ny / 2;
  const int i0 = which % 2 == 0 ? 0 : map.nx - nx, j0 = which < 2 ? 0 : map.ny - ny;
  HeightMap out{nx, ny, map.dx, map.dy, {}};
  out.z.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) out.z.push_back(map.at(i0 + i, j0 + j));
  }
  double mean = 0.0;
  for (const double z : out.z) mean += z / static_cast<double>(out.z.size());
  for (double& z : out.z) z -= mean;
  return out;
}

/// Rq of a quarter; that of the whole if the quarter is flat.
double roughness_of(const HeightMap& map, double whole) {
  double squares = 0.0;
  for (const double z : map.z) squares += z * z / static_cast<double>(map.z.size());
  return squares > 0.0 ? std::sqrt(squares) : whole;
}

FactorRow error_of(const std::array<FactorRow, kQuarters>& quarters) {
  FactorRow error;
  error.H = quarters[0].H;
  for (const auto factor : kFactors) {
    double mean = 0.0, squares = 0.0;
    for (const FactorRow& q : quarters) mean += q.*factor / kQuarters;
    for (const FactorRow& q : quarters) squares += std::pow(q.*factor - mean, 2);
    error.*factor = std::sqrt(squares / (kQuarters - 1) / kQuarters);
  }
  return error;
}

/// Grooves along the motion carry nothing: zero but for round-off.
double not_negative(double factor) { return std::abs(factor) < kOpen ? 0.0 : factor; }

}  // namespace

FactorRow factors_at(const HeightMap& map, double sigma, double H, PatchEnds ends) {
  EXPECTS(sigma > 0.0 && H > 0.0);
  PatchGap gap{map.nx, map.ny, map.dx / map.dy, 1.0, std::vector<double>(map.z.size())};
  const auto n = static_cast<double>(map.z.size());
  FactorRow row;
  row.H = H;
  double inverse = 0.0;
  for (std::size_t c = 0; c < map.z.size(); ++c) {
    const double h = H - map.z[c] / sigma;
    if (h <= kTouching) {
      row.contact += 1.0 / n;
      continue;
    }
    gap.h[c] = h;
    row.average_gap += h / n;
    inverse += 1.0 / (h * n);
  }
  const PatchMeans means = patch_flow(gap, ends);
  row.phi_x = means.conductance / (H * H * H);
  row.phi_z = patch_conductance(exchanged(gap), ends) / (H * H * H);
  row.phi_s = row.average_gap - means.couette;
  row.phi_f = H * inverse;
  row.phi_fs = H * means.sliding_pressure;
  row.phi_fp = means.pressure_shear / H;
  return row;
}

FactorRows map_factors(const HeightMap& map, double sigma, const std::vector<double>& H,
                       const FactorOptions& options) {
  const auto stopped = [&] { return options.stop != nullptr && *options.stop; };
  const int n = static_cast<int>(H.size());
  FactorRows out;
  out.rows.resize(H.size());
  out.errors.resize(H.size());
  std::atomic<int> done{0};
  parallel_for(n, options.threads, [&](int k) {
    if (stopped()) return;
    const auto at = static_cast<std::size_t>(k);
    out.rows[at] = factors_at(map, sigma, H[at], options.ends);
    std::array<FactorRow, kQuarters> quarters;
    for (int q = 0; q < kQuarters && !stopped(); ++q) {
      // A part of a periodic surface repeats itself no more.
      const HeightMap part = quarter(map, q);
      quarters[static_cast<std::size_t>(q)] =
          factors_at(part, roughness_of(part, sigma), H[at], PatchEnds::patch);
    }
    out.errors[at] = error_of(quarters);
    const int now = ++done;
    if (options.progress) options.progress(now, n);
  });
  if (stopped()) return {};
  return out;
}

bool is_open(const FactorRow& row) {
  return std::min(row.phi_x, row.phi_z) * std::pow(row.H, 3) > kOpen;
}

fluid::FactorTable factor_table(const std::vector<FactorRow>& rows, double sigma) {
  fluid::FactorTable table;
  table.sigma = sigma;
  const auto closed = std::find_if_not(rows.rbegin(), rows.rend(), is_open);
  for (auto at = closed.base(); at != rows.end(); ++at) {
    const FactorRow& row = *at;
    table.H.push_back(row.H);
    table.average_gap.push_back(row.average_gap);
    table.phi_x.push_back(row.phi_x);
    table.phi_z.push_back(row.phi_z);
    table.phi_s.push_back(not_negative(row.phi_s));
    table.phi_f.push_back(row.phi_f);
    table.phi_fs.push_back(not_negative(row.phi_fs));
    table.phi_fp.push_back(not_negative(row.phi_fp));
  }
  return table;
}

}  // namespace shellback::surface
