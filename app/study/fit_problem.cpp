#include "app/study/fit_problem.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::study {
namespace {

constexpr double kDecade = 10.0;  ///< ratio of bounds from which on a logarithm serves better [-]

}  // namespace

bool in_logarithms(const FitParameter& p) {
  return p.has_zero && p.low > 0.0 && p.high >= kDecade * p.low;
}

double fit_coordinate(const FitParameter& p, double x) {
  return in_logarithms(p) ? std::log(x) : x;
}

double fit_value(const FitParameter& p, double y) {
  return std::clamp(in_logarithms(p) ? std::exp(y) : y, p.low, p.high);
}

}  // namespace shellback::study
