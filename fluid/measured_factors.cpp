#include "fluid/measured_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/contract.hpp"

namespace shellback::fluid {
namespace {

/// Exponent of the decay above the table: second-order perturbation of a smooth film [-].
constexpr double kDecay = 2.0;
/// What reciprocity may be missed by, over hT: the fits of Patir and Cheng do by 0.03 [-].
constexpr double kReciprocal = 0.05;
/// hT is at least h, to what a table's digits leave of it [-].
constexpr double kDigits = 1e-3;

std::vector<double> logs(const std::vector<double>& x) {
  std::vector<double> out;
  for (const double v : x) out.push_back(std::log(v));
  return out;
}

/// ln(H^power phi) over ln H, its last slope that of 1 + (phi - 1)(H_high/H)^2.
MonotoneCubic log_curve(const FactorTable& t, const std::vector<double>& phi, double power) {
  std::vector<double> y = logs(phi);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += power * std::log(t.H[i]);
  const double end = phi.back();
  return {logs(t.H), y, {}, power - kDecay * (end - 1.0) / end};
}

/// Over H, its last slope that of y (H_high/H)^2.
MonotoneCubic decaying(const FactorTable& t, const std::vector<double>& y) {
  return {t.H, y, {}, -kDecay * y.back() / t.H.back()};
}

/// Rate at which hT - h vanishes at the end of the table, by 1/H; 1 if it has vanished already.
double closing_rate(const FactorTable& t) {
  const std::size_t n = t.H.size();
  const double last = t.average_gap[n - 1] - t.H[n - 1];
  const double before = t.average_gap[n - 2] - t.H[n - 2];
  return last > 0.0 && before > last ? std::log(before / last) / (t.H[n - 1] - t.H[n - 2]) : 1.0;
}

/// limit + (end - limit)(H_high/H)^2.
ValueAndSlope beyond(double end, double limit, double H_high, double H) {
  const double part = (end - limit) * std::pow(H_high / H, kDecay);
  return {limit + part, -kDecay * part / H};
}

/// H^3 phi.
ValueAndSlope conductance(const MonotoneCubic& curve, const MeasuredFactors& m, double H) {
  if (H > m.H_high) {
    const double end = std::exp(curve.at(std::log(m.H_high)).value) / std::pow(m.H_high, 3);
    const ValueAndSlope phi = beyond(end, 1.0, m.H_high, H);
    return {H * H * H * phi.value, H * H * (3.0 * phi.value + H * phi.slope)};
  }
  const double Hc = std::max(H, m.H_low);
  const ValueAndSlope ln_c = curve.at(std::log(Hc));
  const double c = std::exp(ln_c.value), slope = c * ln_c.slope / Hc;
  if (H >= m.H_low) return {c, slope};
  const double rate = slope / c / (1.0 - kClosedFlow), e = std::exp(rate * (H - m.H_low));
  return {c * (kClosedFlow + (1.0 - kClosedFlow) * e), c * (1.0 - kClosedFlow) * rate * e};
}

/// hT/sigma.
ValueAndSlope mean_gap(const MeasuredFactors& m, double H) {
  if (H > m.H_high) {
    const ValueAndSlope end = m.average_gap.at(m.H_high);
    const double excess = end.value - m.H_high;
    if (excess <= 0.0) return {H, 1.0};
    const double rate = (1.0 - end.slope) / excess, e = excess * std::exp(-rate * (H - m.H_high));
    return {H + e, 1.0 - rate * e};
  }
  const ValueAndSlope at = m.average_gap.at(std::max(H, m.H_low));
  if (H >= m.H_low) return at;
  const double rate = at.slope / at.value, g = at.value * std::exp(rate * (H - m.H_low));
  return {g, rate * g};
}

/// Phi_s sigma/hT.
ValueAndSlope carried(const MeasuredFactors& m, double H) {
  if (H > m.H_high) return beyond(m.carried.at(m.H_high).value, 0.0, m.H_high, H);
  if (H < m.H_low) return {m.carried.at(m.H_low).value, 0.0};
  return m.carried.at(H);
}

/// Phi_fs, at or above the table's first row.
double roughness_shear(const MeasuredFactors& m, double H) {
  return H > m.H_high ? beyond(m.phi_fs.at(m.H_high).value, 0.0, m.H_high, H).value
                      : m.phi_fs.at(H).value;
}

/// phi_f/H, at or above the table's first row.
double inverse_gap(const MeasuredFactors& m, double H) {
  if (H <= m.H_high) return std::exp(m.ln_f.at(std::log(H)).value);
  const double end = std::exp(m.ln_f.at(std::log(m.H_high)).value) * m.H_high;
  return beyond(end, 1.0, m.H_high, H).value / H;
}

struct Column {
  const char* name;
  std::vector<double> FactorTable::*values;
  std::function<bool(const FactorTable&, std::size_t)> sound;
  const char* problem;
};

const std::vector<Column>& columns() {
  using T = FactorTable;
  const auto above = [](std::vector<double> T::*c, double least) {
    return [c, least](const T& t, std::size_t i) { return (t.*c)[i] > least; };
  };
  const auto not_below = [](std::vector<double> T::*c, double least) {
    return [c, least](const T& t, std::size_t i) { return (t.*c)[i] >= least; };
  };
  const auto rising = [](std::vector<double> T::*c) {
    return [c](const T& t, std::size_t i) { return i == 0 || (t.*c)[i] > (t.*c)[i - 1]; };
  };
  static const std::vector<Column> all{
      {"h_over_sigma", &T::H, above(&T::H, 0.0), "must be positive"},
      {"h_over_sigma", &T::H, rising(&T::H), "must rise from row to row"},
      {"average_gap", &T::average_gap, above(&T::average_gap, 0.0), "must be positive"},
      {"average_gap", &T::average_gap, rising(&T::average_gap), "must rise with the gap"},
      {"average_gap", &T::average_gap,
       [](const T& t, std::size_t i) { return t.average_gap[i] >= (1.0 - kDigits) * t.H[i]; },
       "the mean open gap cannot be smaller than the gap h_over_sigma"},
      {"phi_x", &T::phi_x, above(&T::phi_x, 0.0), "must be positive; leave out closed gaps"},
      {"phi_z", &T::phi_z, above(&T::phi_z, 0.0), "must be positive; leave out closed gaps"},
      {"phi_x", &T::phi_x,
       [](const T& t, std::size_t i) {
         return i == 0 || t.phi_x[i] * std::pow(t.H[i] / t.H[i - 1], 3) > t.phi_x[i - 1];
       },
       "phi_x h^3 must rise with the gap"},
      {"phi_z", &T::phi_z,
       [](const T& t, std::size_t i) {
         return i == 0 || t.phi_z[i] * std::pow(t.H[i] / t.H[i - 1], 3) > t.phi_z[i - 1];
       },
       "phi_z h^3 must rise with the gap"},
      {"phi_s", &T::phi_s, not_below(&T::phi_s, 0.0), "must not be negative"},
      {"phi_s", &T::phi_s, [](const T& t, std::size_t i) { return t.phi_s[i] < t.average_gap[i]; },
       "must be below average_gap: a surface carries no more oil than there is"},
      {"phi_f", &T::phi_f, above(&T::phi_f, 0.0), "must be positive"},
      {"phi_fs", &T::phi_fs, not_below(&T::phi_fs, 0.0), "must not be negative"},
      {"phi_fp", &T::phi_fp,
       [](const T& t, std::size_t i) {
         const double hT = t.average_gap[i];
         return std::abs(t.H[i] * t.phi_fp[i] - (hT - t.phi_s[i])) <= kReciprocal * hT;
       },
       "h_over_sigma phi_fp must be average_gap - phi_s within 5 % of average_gap (reciprocity of "
       "shear flow and pressure shear); mend phi_s or phi_fp, or leave phi_fp out"}};
  return all;
}

}  // namespace

FactorFault fault_of(const FactorTable& t) {
  constexpr std::size_t kFewest = 3;
  for (const Column& column : columns()) {
    const bool left_out = column.values == &FactorTable::phi_fp && t.phi_fp.empty();
    if (left_out) continue;
    EXPECTS((t.*column.values).size() == t.H.size());
    for (std::size_t i = 0; i < t.H.size(); ++i) {
      if (!column.sound(t, i)) {
        return {
            i, column.name,
            fmt::format("{} is {:.6g}; {}", column.name, (t.*column.values)[i], column.problem)};
      }
    }
  }
  if (t.H.size() >= kFewest) return {};
  return {0, "h_over_sigma",
          fmt::format("there are {} rows; give {} or more gaps", t.H.size(), kFewest)};
}

MeasuredFactors measured_factors(const FactorTable& t, double shell, double journal) {
  EXPECTS(fault_of(t).problem.empty());
  MeasuredFactors m;
  m.sigma = std::hypot(shell, journal);
  m.shear_share = (journal * journal - shell * shell) / (m.sigma * m.sigma);
  m.H_low = t.H.front();
  m.H_high = t.H.back();
  m.ln_c_x = log_curve(t, t.phi_x, 3.0);
  m.ln_c_z = log_curve(t, t.phi_z, 3.0);
  m.ln_f = log_curve(t, t.phi_f, -1.0);
  const double excess = std::max(t.average_gap.back() - t.H.back(), 0.0);
  m.average_gap = {t.H, t.average_gap, {}, 1.0 - closing_rate(t) * excess};
  std::vector<double> ratio;
  for (std::size_t i = 0; i < t.H.size(); ++i) ratio.push_back(t.phi_s[i] / t.average_gap[i]);
  m.carried = decaying(t, ratio);
  m.phi_fs = decaying(t, t.phi_fs);
  return m;
}

GapFlow gap_flow(const MeasuredFactors& m, double h) {
  const double s = m.sigma, H = h / s;
  const ValueAndSlope gap = mean_gap(m, H), r = carried(m, H);
  const ValueAndSlope x = conductance(m.ln_c_x, m, H), z = conductance(m.ln_c_z, m, H);
  const double shear = m.shear_share * r.value * gap.value;
  const double dshear = m.shear_share * (r.slope * gap.value + r.value * gap.slope);
  return {s * gap.value, s * s * s * x.value, s * s * s * z.value, s * shear,
          gap.slope,     s * s * x.slope,     s * s * z.slope,     dshear};
}

GapShear gap_shear(const MeasuredFactors& m, double h) {
  const double s = m.sigma, H = h / s, Hc = std::max(H, m.H_low);
  const double open = H < m.H_low ? mean_gap(m, H).value / mean_gap(m, Hc).value : 1.0;
  const double f = open * inverse_gap(m, Hc) / s;
  const double fs = open * roughness_shear(m, Hc) / Hc / s;
  const double fp = mean_gap(m, H).value * (1.0 - carried(m, H).value);
  return {f, m.shear_share * fs, f + fs, s * fp};
}

}  // namespace shellback::fluid
