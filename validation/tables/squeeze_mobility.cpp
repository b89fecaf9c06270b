#include "validation/tables/squeeze_mobility.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace shellback::validation {
namespace {

constexpr double kForce = 12.0;     ///< of h^3/(12 eta) in (1)
constexpr int kMostExchanges = 80;  ///< of cells; twenty suffice for the widest bearings

double gap(double eps, double phi) { return 1.0 - eps * std::cos(phi); }

double cube(double x) { return x * x * x; }

/// Equal steps of t make fine cells near the edge 1, where a wide bearing's pressure falls.
double crowded(double t) { return t * (1.5 - 0.5 * t * t); }

}  // namespace

double angle_of_sweep(double s, double eps) {
  const double stretch = std::sqrt((1.0 + eps) / (1.0 - eps));
  const auto sweep = [&](double phi) {  // -pi ... pi
    return 0.5 * phi + std::atan(stretch * std::tan(0.5 * phi));
  };
  double low = -kPi;
  double high = kPi;
  for (int k = 0; k < 60; ++k) {  // to rounding
    const double middle = 0.5 * (low + high);
    (sweep(middle) < s ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

SqueezeMobility::SqueezeMobility(double b, double eps, int around, int along)
    : b_(b), eps_(eps), nt_(around), nz_(along) {
  for (int i = 0; i <= nt_; ++i) face_.push_back(angle_of_sweep(kPi * (2.0 * i / nt_ - 1.0), eps));
  for (int j = 0; j <= nz_; ++j) edge_.push_back(crowded(static_cast<double>(j) / nz_));
  full_.assign(static_cast<std::size_t>(nt_) * nz_, 1);
  assemble();
}

void SqueezeMobility::assemble() {
  const int n = nt_ * nz_;
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int p, int q, double g) {
    entries.insert(entries.end(), {{p, p, g}, {q, q, g}, {p, q, -g}, {q, p, -g}});
  };
  n_.resize(n, 2);
  edge_conductance_ = Vector::Zero(n);
  const auto centre = [](double a, double b) { return 0.5 * (a + b); };
  for (int i = 0; i < nt_; ++i) {
    const double low = face_[i], high = face_[i + 1], phi = centre(low, high);
    const double beyond =
        i + 1 < nt_ ? centre(high, face_[i + 2]) : centre(high, face_[1] + 2 * kPi);
    const double around = cube(gap(eps_, high)) / (beyond - phi);
    const double h3 =
        (cube(gap(eps_, low)) + 4.0 * cube(gap(eps_, phi)) + cube(gap(eps_, high))) / 6.0;
    for (int j = 0; j < nz_; ++j) {
      const int cell = i * nz_ + j;
      const double width = edge_[j + 1] - edge_[j];
      const double z = centre(edge_[j], edge_[j + 1]);
      couple(cell, ((i + 1) % nt_) * nz_ + j, around * width);
      const double axial = h3 * (high - low) / (b_ * b_);
      if (j + 1 < nz_) {
        couple(cell, cell + 1, axial / (centre(edge_[j + 1], edge_[j + 2]) - z));
      } else {
        edge_conductance_[cell] = axial / (1.0 - z);
        entries.emplace_back(cell, cell, edge_conductance_[cell]);
      }
      n_(cell, 0) = (std::sin(high) - std::sin(low)) * width;
      n_(cell, 1) = (std::cos(low) - std::cos(high)) * width;
    }
  }
  a_.resize(n, n);
  a_.setFromTriplets(entries.begin(), entries.end());
  reduced_ = a_;
  factor_.analyzePattern(a_);
}

Eigen::Vector2d SqueezeMobility::solve(double x, double y) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> right = kForce * n_;
  for (int col = 0; col < a_.outerSize(); ++col) {
    Eigen::SparseMatrix<double>::InnerIterator to(reduced_, col);
    for (Eigen::SparseMatrix<double>::InnerIterator from(a_, col); from; ++from, ++to) {
      const bool inside = full_[from.row()] && full_[col];
      to.valueRef() = inside || from.row() == col ? from.value() : 0.0;
    }
    if (!full_[col]) right.row(col).setZero();
  }
  factor_.factorize(reduced_);
  const Eigen::Matrix<double, Eigen::Dynamic, 2> carried = factor_.solve(right);
  const Eigen::Matrix2d impedance = 0.5 * n_.transpose() * carried;  // of W/(B D) by v
  const Eigen::Vector2d v = impedance.inverse() * Eigen::Vector2d(x, y);
  p_ = carried * v;
  return v;
}

int SqueezeMobility::exchange(const Eigen::Vector2d& v) {
  const Vector missing = kForce * (n_ * v) - a_ * p_;
  const double largest = p_.maxCoeff();
  constexpr double kRound = 1e-12;  // of the largest pressure, and of what is pressed out of a cell
  int moved = 0;
  for (Eigen::Index k = 0; k < p_.size(); ++k) {
    const auto cell = static_cast<std::size_t>(k);
    const bool leaves = full_[cell] && p_[k] < -kRound * largest;
    const bool joins = !full_[cell] && missing[k] > kRound * kForce * v.norm() * n_.row(k).norm();
    if (!leaves && !joins) continue;
    full_[cell] = joins;
    ++moved;
  }
  return moved;
}

std::optional<MobilityPoint> SqueezeMobility::at(double load) {
  const double x = std::cos(load), y = std::sin(load);
  for (int k = 0; k < kMostExchanges; ++k) {
    const Eigen::Vector2d v = solve(x, y);
    if (exchange(v) > 0) continue;
    return MobilityPoint{v[0] * x + v[1] * y, v[1] * x - v[0] * y, p_.maxCoeff(),
                         edge_conductance_.dot(p_) / (2.0 * kForce * v.norm())};
  }
  return std::nullopt;
}

}  // namespace shellback::validation
