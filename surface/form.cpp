#include "surface/form.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/contract.hpp"
#include "core/eigen.hpp"

namespace shellback::surface {
namespace {

/// Products of Legendre polynomials up to a degree: (0,0), (1,0), (0,1), (2,0) ...
struct Term {
  int a, b;
};

std::vector<Term> terms_of(int degree) {
  std::vector<Term> terms;
  for (int n = 0; n <= degree; ++n) {
    for (int b = 0; b <= n; ++b) terms.push_back({n - b, b});
  }
  return terms;
}

/// P_0 ... P_degree at all points of a line (columns: points).
Eigen::MatrixXd legendre(int degree, int points) {
  Eigen::MatrixXd P(degree + 1, points);
  for (int i = 0; i < points; ++i) {
    const double u = (2.0 * i + 1.0) / points - 1.0;
    P(0, i) = 1.0;
    if (degree > 0) P(1, i) = u;
    for (int n = 1; n < degree; ++n) {
      P(n + 1, i) = ((2.0 * n + 1.0) * u * P(n, i) - n * P(n - 1, i)) / (n + 1.0);
    }
  }
  return P;
}

class Fit {
 public:
  Fit(const HeightMap& map, int degree)
      : map_(map),
        terms_(terms_of(degree)),
        Px_(legendre(degree, map.nx)),
        Py_(legendre(degree, map.ny)),
        c_(Eigen::VectorXd::Zero(count())) {
    solve();
  }

  [[nodiscard]] double at(int i, int j, int from = 0) const {
    double sum = 0.0;
    for (int k = from; k < count(); ++k) sum += c_[k] * value(k, i, j);
    return sum;
  }

  [[nodiscard]] Form told(int degree) const {
    Form form;
    form.degree = degree;
    const double ux = 2.0 / map_.length(), uy = 2.0 / map_.width();
    for (int k = 0; k < count(); ++k) {
      const auto [a, b] = terms_[static_cast<std::size_t>(k)];
      if (a == 0 && b == 0) form.mean = c_[k];
      // Means over [-1, 1]: of P_n' 1 for odd n, of P_n'' n (n + 1)/2 for even n, else 0.
      if (b == 0 && a % 2 == 1) form.slope_x += c_[k] * ux;
      if (a == 0 && b % 2 == 1) form.slope_y += c_[k] * uy;
      if (b == 0 && a % 2 == 0) form.curvature_x += c_[k] * a * (a + 1) / 2.0 * ux * ux;
      if (a == 0 && b % 2 == 0) form.curvature_y += c_[k] * b * (b + 1) / 2.0 * uy * uy;
    }
    return form;
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(terms_.size()); }
  [[nodiscard]] double value(int k, int i, int j) const {
    const auto [a, b] = terms_[static_cast<std::size_t>(k)];
    return Px_(a, i) * Py_(b, j);
  }

  void solve() {
    const int n = count();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n), row(n);
    for (int j = 0; j < map_.ny; ++j) {
      for (int i = 0; i < map_.nx; ++i) {
        const double z = map_.at(i, j);
        if (!std::isfinite(z)) continue;
        for (int k = 0; k < n; ++k) row[k] = value(k, i, j);
        A.selfadjointView<Eigen::Lower>().rankUpdate(row);
        rhs += z * row;
      }
    }
    const Eigen::LDLT<Eigen::MatrixXd> factor(A.selfadjointView<Eigen::Lower>());
    constexpr double kSingular = 1e-10;  // of a matrix near to a diagonal one
    if (factor.info() != Eigen::Success || factor.rcond() < kSingular) {
      throw InputError(fmt::format(
          "the points measured do not determine a form of degree {}; take a lower --form, or a "
          "map with fewer holes",
          map_.nx > 0 ? terms_.back().b : 0));
    }
    c_ = factor.solve(rhs);
  }

  const HeightMap& map_;
  std::vector<Term> terms_;
  Eigen::MatrixXd Px_, Py_;
  Eigen::VectorXd c_;
};

}  // namespace

Levelled remove_form(HeightMap map, int degree) {
  if (degree < 0 || degree > kHighestForm) {
    throw InputError(
        fmt::format("a form of degree {} is not offered; --form takes 0 (mean only), "
                    "1 (tilt), 2 (curvature) up to {}",
                    degree, kHighestForm));
  }
  const Fit fit(map, degree);
  Form form = fit.told(degree);
  double low = INFINITY, high = -INFINITY;
  constexpr int kPlane = 3;  // terms of the mean plane
  std::vector<double> left(map.z.size());
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      const double bend = fit.at(i, j, kPlane);
      low = std::min(low, bend), high = std::max(high, bend);
      left[map.index(i, j)] = map.at(i, j) - fit.at(i, j);
    }
  }
  form.peak_to_valley = high - low;
  map.z = std::move(left);
  return {std::move(map), form};
}

}  // namespace shellback::surface
