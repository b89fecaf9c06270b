#include "solid/asperity_contact.hpp"

#include <fmt/format.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/gsl_errors.hpp"

namespace shellback::solid {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kLowest = -30.0;  ///< H below which the asymptotic series takes over [-]
constexpr double kHighest = 10.0;  ///< H above which the contact is exactly zero [-]
constexpr int kPieces = 40;        ///< unit intervals between them [-]
constexpr int kTerms = 14;         ///< polynomial coefficients of an interval: error 1e-13 [-]

constexpr double kPowerFactor = 4.4086e-5;  ///< seed 004, below Eq. 2 [-]
constexpr double kPowerExponent = 6.804;    ///< seed 004, below Eq. 2 [-]
constexpr double kPowerEnd = 4.0;           ///< seed 004, below Eq. 2 [-]

/// ln F_{5/2} and F_{3/2}/F_{5/2} as polynomials in t in [-1, 1] on every interval.
struct Table {
  using Piece = std::array<double, kTerms>;
  std::array<Piece, kPieces> log_F;
  std::array<Piece, kPieces> ratio;
};

/// Powers of t instead of Chebyshev polynomials, for evaluation after Horner. At 14 terms and
/// |t| <= 1 the change of basis costs no more than 1e-12 of the leading coefficient.
Table::Piece monomials(const Table::Piece& chebyshev) {
  Table::Piece out{}, before{}, now{};
  before[0] = 1.0;  // T_0
  now[1] = 1.0;     // T_1
  for (int k = 0; k < kTerms; ++k) {
    const Table::Piece& T = k == 0 ? before : now;
    for (int i = 0; i < kTerms; ++i) out[i] += chebyshev[k] * T[i];
    if (k == 0) continue;
    Table::Piece next{};
    for (int i = 0; i + 1 < kTerms; ++i) next[i + 1] = 2.0 * now[i];
    for (int i = 0; i < kTerms; ++i) next[i] -= before[i];
    before = now;
    now = next;
  }
  return out;
}

/// Interpolation in the Chebyshev points of first kind of the interval [low, low + 1].
template <class Function>
Table::Piece fit(const Function& f, double low) {
  std::array<double, kTerms> value{};
  for (int j = 0; j < kTerms; ++j) {
    value[j] = f(low + 0.5 + 0.5 * std::cos(kPi * (j + 0.5) / kTerms));
  }
  Table::Piece c{};
  for (int k = 0; k < kTerms; ++k) {
    for (int j = 0; j < kTerms; ++j) c[k] += value[j] * std::cos(kPi * k * (j + 0.5) / kTerms);
    c[k] *= (k == 0 ? 1.0 : 2.0) / kTerms;
  }
  return monomials(c);
}

Table make_table() {
  Table table;
  for (int i = 0; i < kPieces; ++i) {
    const double low = kLowest + i;
    table.log_F[i] = fit([](double H) { return std::log(gt_integral(2.5, H)); }, low);
    table.ratio[i] = fit([](double H) { return gt_integral(1.5, H) / gt_integral(2.5, H); }, low);
  }
  return table;
}

/// Made at first use (about 1100 quadratures, some milliseconds), the same for every contact.
const Table& table() {
  static const Table once = make_table();
  return once;
}

double horner(const Table::Piece& c, double t) {
  double sum = c[kTerms - 1];
  for (int i = kTerms - 2; i >= 0; --i) sum = sum * t + c[i];
  return sum;
}

/// F_{5/2} and its derivative by H.
struct FormFactor {
  double F;
  double dF;
};

/// Deep contact: F_n(-x) = E[(s + x)^n] = x^n sum_k binom(n, 2k) (2k - 1)!! x^(-2k), s standard
/// normal; what is cut off at s < -x is of order exp(-x^2/2). At x = 30 the first
/// neglected term is below 1e-14 of the sum.
FormFactor deep(double H) {
  const double x = -H, q = 1.0 / (x * x);
  const double F52 =
      1.0 + q * (1.875 + q * (-0.1171875 + q * (-0.0732421875 - 0.144195556640625 * q)));
  const double F32 =
      1.0 + q * (0.375 + q * (0.0703125 + q * (0.1025390625 + 0.317230224609375 * q)));
  const double root = std::sqrt(x);
  return {x * x * root * F52, -2.5 * x * root * F32};
}

FormFactor exact(double H, const Table& table) {
  if (H > kHighest) return {0.0, 0.0};
  if (H < kLowest) return deep(H);
  if (std::isnan(H)) return {H, H};  // no entry of the table belongs to it; the solver sees it
  const int i = std::min(static_cast<int>(H - kLowest), kPieces - 1);
  const double t = 2.0 * (H - kLowest - i) - 1.0;
  const double F = std::exp(horner(table.log_F[i], t));
  return {F, -2.5 * F * horner(table.ratio[i], t)};
}

FormFactor power_law(double H) {
  if (H >= kPowerEnd) return {0.0, 0.0};
  const double slope = kPowerFactor * std::pow(kPowerEnd - H, kPowerExponent - 1.0);
  return {slope * (kPowerEnd - H), -kPowerExponent * slope};
}

struct Integrand {
  double n, H;
};

/// With s - H = v^2 the half power is gone and the integrand is smooth for n = 1/2, 3/2, 5/2. For
/// H > 0 the factor exp(-H^2/2) is taken out.
double integrand(double v, void* parameters) {
  const auto& [n, H] = *static_cast<const Integrand*>(parameters);
  const double t = v * v;
  const double exponent = H > 0.0 ? -t * (0.5 * t + H) : -0.5 * (t + H) * (t + H);
  return 2.0 * std::pow(v, 2.0 * n + 1.0) * std::exp(exponent);
}

void require_positive(double value, const char* what, const char* unit) {
  if (value > 0.0) return;
  throw InputError(
      fmt::format("asperity contact: {} is {} {} (must be positive)", what, value, unit));
}

/// H at which r_c = pi^2 s^2 F_2(H) = 1, s = eta_d beta sigma; of a pair whose s is not known 0.05,
/// the upper end of what is usual (textbook) [-].
double whole_surface(double s) {
  constexpr double kUsual = 0.05;
  const double by_summits = std::pow(kPi * (s > 0.0 ? s : kUsual), 2);
  double low = kLowest, high = kHighest;  // F_2 falls with H
  while (high - low > 1e-9) {             // of a sigma: far below what a surface is known to
    const double H = 0.5 * (low + high);
    (by_summits * contact_area_integral(H) > 1.0 ? low : high) = H;
  }
  return low;
}

}  // namespace

double gt_integral(double n, double H) {
  constexpr double kTail = 12.0;  // exp(-12^2/2) = 5e-32 of the peak: nothing beyond
  constexpr double kRelative = 1e-13;
  constexpr std::size_t kIntervals = 200;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
      gsl_integration_workspace_alloc(kIntervals), gsl_integration_workspace_free);
  Integrand parameters{n, H};
  gsl_function f{&integrand, &parameters};
  const double low = std::sqrt(std::max(0.0, -H - kTail));
  const double high = std::sqrt(std::max(0.0, -H) + kTail);
  double value = 0.0, error = 0.0;
  gsl_errors_are_results();  // judged here
  const int status = gsl_integration_qag(&f, low, high, 0.0, kRelative, kIntervals,
                                         GSL_INTEG_GAUSS31, space.get(), &value, &error);
  // Round-off may stop the estimate just above the wish (GSL_EROUND): still good if below 1e-12.
  if ((status != GSL_SUCCESS && status != GSL_EROUND) || error > 1e-12 * value) {
    throw std::runtime_error(
        fmt::format("Greenwood-Tripp integral F_{}({}): {}", n, H, gsl_strerror(status)));
  }
  return value * (H > 0.0 ? std::exp(-0.5 * H * H) : 1.0) / std::sqrt(2.0 * kPi);
}

AsperityContact::AsperityContact(const RoughSurface& shell, const RoughSurface& shaft,
                                 const ContactParameters& parameters)
    : sigma_(std::hypot(shell.summit_roughness, shaft.summit_roughness)),
      delta_(shell.summit_height + shaft.summit_height),
      scale_(parameters.elastic_factor * parameters.composite_modulus),
      friction_(parameters, sigma_),
      hardness_(parameters.hardness > 0.0 ? parameters.hardness : kNoLimit),
      integral_(parameters.integral) {
  require_positive(sigma_, "the combined summit roughness", "m");
  require_positive(parameters.elastic_factor, "the elastic factor K", "");
  require_positive(parameters.composite_modulus, "the composite modulus E*", "Pa");
  if (parameters.hardness < 0.0) require_positive(parameters.hardness, "the hardness", "Pa");
  whole_surface_ = whole_surface(friction_.summits());
  flow_gap_ = hardness_ == kNoLimit ? -kNoLimit : gap_of(hardness_);
}

double AsperityContact::gap_of(double p) const {
  EXPECTS(p > 0.0);
  const auto pressure = [this](double h) { return elastic(h).p; };
  double high = delta_ + kHighest * sigma_;  // no contact
  double reach = sigma_;
  while (pressure(high - reach) < p) reach *= 2.0;
  double low = high - reach;
  while (high - low > 1e-12 * (sigma_ + std::abs(low))) {  // bisection to round-off
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (pressure(middle) > p ? low : high) = middle;
  }
  return low;
}

ContactPressure AsperityContact::at(double h) const {
  const ContactPressure c = elastic(h);
  return c.p > hardness_ ? ContactPressure{hardness_, 0.0} : c;
}

ContactPressure AsperityContact::elastic(double h) const {
  const double H = (h - delta_) / sigma_;
  const FormFactor f = integral_ == ContactIntegral::exact ? exact(H, table()) : power_law(H);
  return {scale_ * f.F, scale_ * f.dF / sigma_};
}

void AsperityContact::evaluate(std::span<const double> h, std::span<double> p,
                               std::span<double> dp_dh) const {
  EXPECTS(p.size() == h.size() && dp_dh.size() == h.size());
  const double per_sigma = 1.0 / sigma_;
  const auto each = [&](const auto& form_factor) {
    for (std::size_t i = 0; i < h.size(); ++i) {
      const FormFactor f = form_factor((h[i] - delta_) * per_sigma);
      p[i] = scale_ * f.F;
      dp_dh[i] = scale_ * per_sigma * f.dF;
    }
  };
  if (integral_ == ContactIntegral::exact) {
    const Table& once = table();
    each([&once](double H) { return exact(H, once); });
  } else {
    each(power_law);
  }
  if (hardness_ == kNoLimit) return;
  for (std::size_t i = 0; i < h.size(); ++i) {
    if (!(p[i] > hardness_)) continue;
    p[i] = hardness_;
    dp_dh[i] = 0.0;
  }
}

}  // namespace shellback::solid
