#include "validation/rig/rig_sum.hpp"

#include <cmath>
#include <limits>

#include "core/contract.hpp"

namespace shellback::validation {
namespace {

using bearing::CycleInstant;

/// The value of `member` at time t, straight between instants; `k`: where the last search ended.
double value_at(const std::vector<CycleInstant>& series, double CycleInstant::*member, double t,
                std::size_t k) {
  if (k + 1 >= series.size()) return series.back().*member;
  const CycleInstant& a = series[k];
  const CycleInstant& b = series[k + 1];
  const double part = b.t > a.t ? (t - a.t) / (b.t - a.t) : 1.0;
  return (1.0 - part) * (a.*member) + part * (b.*member);
}

}  // namespace

std::array<double, 3> rig_loads(double load) { return {0.5 * load, load, 0.5 * load}; }

double rig_torque(const std::array<double, 3>& torques) {
  return torques[0] + torques[1] + torques[2];
}

double rig_torque(double test, double support) {
  return rig_torque(std::array<double, 3>{support, test, support});
}

std::vector<RigInstant> rig_series(const std::vector<CycleInstant>& test,
                                   const std::vector<CycleInstant>& support) {
  EXPECTS(!test.empty() && !support.empty());
  std::vector<RigInstant> sum;
  std::size_t k = 0;
  for (const CycleInstant& i : test) {
    while (k + 2 < support.size() && support[k + 1].t < i.t) ++k;
    const double torque = value_at(support, &CycleInstant::torque, i.t, k);
    const double asperity = value_at(support, &CycleInstant::torque_asperity, i.t, k);
    sum.push_back(
        {i.t, i.omega, rig_torque(i.torque, torque), rig_torque(i.torque_asperity, asperity)});
  }
  return sum;
}

double time_of_full_film(const std::vector<RigInstant>& series, double breakaway) {
  const double small = 0.01 * breakaway;
  for (std::size_t k = 1; k < series.size(); ++k) {
    const RigInstant& a = series[k - 1];
    const RigInstant& b = series[k];
    if (!(a.asperity >= small && b.asperity < small)) continue;
    return a.t + (b.t - a.t) * (a.asperity - small) / (a.asperity - b.asperity);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace shellback::validation
