#include "app/study/measured_residuals.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::study {

PointValues deviations_of(const std::vector<MeasuredPoint>& measured) {
  double squares = 0.0;
  int count = 0;
  for (const MeasuredPoint& p : measured) {
    for (const MeasuredValue& m : p.values) {
      squares += m.value * m.value;
      ++count;
    }
  }
  const double unit = squares > 0.0 ? std::sqrt(squares / count) : 1.0;
  PointValues all;
  for (const MeasuredPoint& p : measured) {
    all.emplace_back();
    for (const MeasuredValue& m : p.values) {
      all.back().push_back(std::isfinite(m.deviation) ? m.deviation : unit);
    }
  }
  return all;
}

std::vector<double> residuals_of(const std::vector<MeasuredPoint>& measured,
                                 const PointValues& deviations, const PointValues& computed) {
  std::vector<double> r;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    for (std::size_t k = 0; k < computed[i].size(); ++k) {
      r.push_back((computed[i][k] - measured[i].values[k].value) / deviations[i][k]);
    }
  }
  return r;
}

double noise_of(const PointValues& deviations, const PointValues& computed, double accuracy) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    for (std::size_t k = 0; k < computed[i].size(); ++k) {
      squares += std::pow(accuracy * computed[i][k] / deviations[i][k], 2);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

bool deviations_known(const std::vector<MeasuredPoint>& measured) {
  return std::all_of(measured.begin(), measured.end(), [](const MeasuredPoint& p) {
    return std::all_of(p.values.begin(), p.values.end(),
                       [](const MeasuredValue& m) { return std::isfinite(m.deviation); });
  });
}

}  // namespace shellback::study
