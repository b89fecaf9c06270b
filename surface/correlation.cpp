#include "surface/correlation.hpp"

#include <gsl/gsl_fft_complex.h>

#include <algorithm>
#include <bit>
#include <complex>
#include <numeric>

#include "core/constants.hpp"

namespace shellback::surface {
namespace {

constexpr double kHalf = 0.5;           ///< R at the correlation length (Patir and Cheng) [-]
constexpr double kAreaFactor = 2.2662;  ///< int R^2 dA/lambda^2, pi/(2 ln 2), Gaussian R [-]
constexpr int kDirections = 180;        ///< searched for the lay

/// R on lags 0 <= i < mx along, -my < j < my across.
class Autocorrelation {
 public:
  explicit Autocorrelation(const HeightMap& map)
      : map_(map), nx_(padded(map.nx)), ny_(padded(map.ny)), sum_(nx_ * ny_) {
    const double mean =
        std::accumulate(map.z.begin(), map.z.end(), 0.0) / static_cast<double>(map.z.size());
    for (int j = 0; j < map.ny; ++j) {
      for (int i = 0; i < map.nx; ++i) cell(i, j) = map.at(i, j) - mean;
    }
    transform(false);
    for (auto& c : sum_) c = std::norm(c);
    transform(true);
    variance_ = overlap(0, 0);
  }

  /// Bilinear between lags; `s`, `t` in pitches, at most half the patch.
  [[nodiscard]] double at(double s, double t) const {
    const int i = static_cast<int>(std::floor(s)), j = static_cast<int>(std::floor(t));
    const double a = s - i, b = t - j;
    return ((1.0 - a) * ((1.0 - b) * overlap(i, j) + b * overlap(i, j + 1)) +
            a * ((1.0 - b) * overlap(i + 1, j) + b * overlap(i + 1, j + 1))) /
           variance_;
  }

  /// First distance at which R falls to a half, in the direction `angle` from x.
  [[nodiscard]] CorrelationLength length(double angle) const {
    const double cx = std::cos(angle) / map_.dx, cy = std::sin(angle) / map_.dy;
    const double step = 1.0 / std::hypot(cx, cy);  // about a pitch
    const double end = std::min(0.5 * map_.nx / std::max(std::abs(cx), 1e-12),
                                0.5 * map_.ny / std::max(std::abs(cy), 1e-12));
    double before = 1.0;
    for (double r = step; r < end; r += step) {
      const double now = at(r * cx, r * cy);
      if (now <= kHalf) return {r - step * (kHalf - now) / (before - now), false, kHalf};
      before = now;
    }
    return {end, true, before};
  }

 private:
  static std::size_t padded(int n) { return std::bit_ceil(2 * static_cast<std::size_t>(n)); }
  std::complex<double>& cell(int i, int j) {
    return sum_[static_cast<std::size_t>(j) * nx_ + static_cast<std::size_t>(i)];
  }
  /// Mean product at a lag; FFT lags wrap round.
  [[nodiscard]] double overlap(int i, int j) const {
    const auto wrap = [](int k, std::size_t n) {
      return k < 0 ? n - static_cast<std::size_t>(-k) : static_cast<std::size_t>(k);
    };
    const double points = static_cast<double>(map_.nx - std::abs(i)) * (map_.ny - std::abs(j));
    return sum_[wrap(j, ny_) * nx_ + wrap(i, nx_)].real() / points;
  }
  /// Both directions, without scaling of the forward transform; radix 2 never fails.
  void transform(bool back) {
    const auto line = [back](double* data, std::size_t stride, std::size_t n) {
      back ? gsl_fft_complex_radix2_inverse(data, stride, n)
           : gsl_fft_complex_radix2_forward(data, stride, n);
    };
    auto* data = reinterpret_cast<double*>(sum_.data());
    for (std::size_t j = 0; j < ny_; ++j) line(data + 2 * j * nx_, 1, nx_);
    for (std::size_t i = 0; i < nx_; ++i) line(data + 2 * i, nx_, ny_);
  }

  const HeightMap& map_;
  std::size_t nx_, ny_;
  std::vector<std::complex<double>> sum_;
  double variance_ = 1.0;
};

}  // namespace

namespace {

/// Relative variance of Rq that one area leaves [-].
double variance_of_Rq(double kurtosis) {
  constexpr double kGaussian = 3.0;
  return 0.25 * (std::max(kurtosis, kGaussian) - 1.0);
}

}  // namespace

double Correlation::error_of_Rq(double kurtosis) const {
  return std::sqrt(variance_of_Rq(kurtosis) / independent);
}

double independent_areas_for(double error_of_Rq, double kurtosis) {
  return variance_of_Rq(kurtosis) / (error_of_Rq * error_of_Rq);
}

double lengths_for(double independent) { return std::sqrt(kAreaFactor * independent); }

namespace {

/// Lengths beyond the patch are told apart by what is left of R.
bool longer(const CorrelationLength& a, const CorrelationLength& b) {
  if (a.at_least != b.at_least) return a.at_least;
  return a.at_least ? a.R > b.R : a.length > b.length;
}

}  // namespace

Correlation correlation_of(const HeightMap& map) {
  const Autocorrelation R(map);
  Correlation c;
  c.along = R.length(0.0);
  c.across = R.length(0.5 * kPi);
  c.gamma = c.along.length / c.across.length;
  c.longest.length = 0.0;
  c.shortest.length = INFINITY;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = kPi * k / kDirections;
    const CorrelationLength l = R.length(angle);
    if (longer(l, c.longest)) c.longest = l, c.lay = angle;
  }
  c.shortest = R.length(c.lay + (c.lay < 0.5 * kPi ? 0.5 : -0.5) * kPi);
  if (c.lay > 0.5 * kPi) c.lay -= kPi;
  c.independent =
      std::clamp(map.length() * map.width() / (kAreaFactor * c.longest.length * c.shortest.length),
                 1.0, static_cast<double>(map.z.size()));
  return c;
}

}  // namespace shellback::surface
