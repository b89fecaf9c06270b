#include "core/harmonics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback {
namespace {

constexpr int kCellsPerPeriod = 4;  ///< of the highest harmonic [-]
constexpr int kMostHarmonics = 48;  ///< default limit [-], see default_harmonics

// The three that give the smallest error for their cost; see HarmonicSample.
constexpr int kFirstSmooth = 6;        ///< harmonic from which on operators are interpolated [-]
constexpr int kSampleNodes = 11;       ///< of the polynomial, before those that coincide [-]
constexpr double kSampleMiddle = 5.0;  ///< a of x = (n - a) / (n + a) [-]

double sample_place(double n) { return (n - kSampleMiddle) / (n + kSampleMiddle); }

Eigen::Map<const Eigen::MatrixXd> columns(const Field& field, int nt) {
  const auto rows = static_cast<Eigen::Index>(field.size()) / nt;
  return {field.data(), rows, nt};
}

}  // namespace

int default_harmonics(int nt) { return std::min(nt / kCellsPerPeriod, kMostHarmonics); }

Harmonics::Harmonics(const FilmGrid& grid, int highest)
    : nt_(grid.nt), highest_(highest), synthesis_(grid.nt, 2 * std::max(highest, 0) + 1) {
  if (highest < 0 || 2 * highest + 1 > grid.nt) {
    throw InputError(
        fmt::format("{} harmonics cannot be told apart on {} circumferential cells; use at most {}",
                    highest, grid.nt, (grid.nt - 1) / 2));
  }
  synthesis_.col(0).setOnes();
  for (int n = 1; n <= highest; ++n) {
    for (int i = 0; i < nt_; ++i) {
      const double a = n * grid.phi_face[i], b = n * grid.phi_face[i + 1];
      synthesis_(i, 2 * n - 1) = (std::sin(b) - std::sin(a)) / (b - a);
      synthesis_(i, 2 * n) = (std::cos(a) - std::cos(b)) / (b - a);
    }
  }
  const Eigen::Map<const Eigen::VectorXd> width(grid.dphi.data(), nt_);
  analysis_ = width.asDiagonal() * synthesis_ / kPi;
  gram_.compute(synthesis_.transpose() * analysis_);
  analysis_.col(0) *= 0.5;
}

Eigen::MatrixXd Harmonics::analyse(const Field& field) const {
  return columns(field, nt_) * analysis_;
}

Field Harmonics::synthesise(const Eigen::MatrixXd& coefficients) const {
  Field field(static_cast<std::size_t>(coefficients.rows()) * nt_);
  Eigen::Map<Eigen::MatrixXd>(field.data(), coefficients.rows(), nt_).noalias() =
      coefficients * synthesis_.transpose();
  return field;
}

Eigen::MatrixXd Harmonics::fit(const Field& field) const {
  Eigen::MatrixXd c = analyse(field).transpose();
  c.row(0) *= 2.0;  // the Gram matrix is that of S^T W / pi
  gram_.solveInPlace(c);
  return c.transpose();
}

Eigen::MatrixXd multiply(const HarmonicOperator& op, const Eigen::MatrixXd& coefficients) {
  EXPECTS(2 * static_cast<Eigen::Index>(op.size()) - 1 >= coefficients.cols());
  Eigen::MatrixXd out(op.front().rows(), coefficients.cols());
  out.col(0).noalias() = op[0] * coefficients.col(0);
  for (Eigen::Index n = 1; 2 * n < coefficients.cols(); ++n) {
    out.middleCols<2>(2 * n - 1).noalias() = op[n] * coefficients.middleCols<2>(2 * n - 1);
  }
  return out;
}

HarmonicOperator compose(const HarmonicOperator& a, const HarmonicOperator& b) {
  EXPECTS(a.size() == b.size());
  HarmonicOperator product;
  for (std::size_t n = 0; n < a.size(); ++n) product.emplace_back(a[n] * b[n]);
  return product;
}

HarmonicSample::HarmonicSample(int highest, bool all) : highest_(highest) {
  const int exact = all || highest - kFirstSmooth < kSampleNodes ? highest : kFirstSmooth;
  for (int n = 0; n <= exact; ++n) computed_.push_back(n);
  const double low = sample_place(kFirstSmooth), high = sample_place(highest);
  for (int k = 1; k < kSampleNodes && exact < highest; ++k) {
    const double x =
        0.5 * (low + high) - 0.5 * (high - low) * std::cos(kPi * k / (kSampleNodes - 1));
    const int n = static_cast<int>(std::lround(kSampleMiddle * (1.0 + x) / (1.0 - x)));
    if (n > computed_.back()) computed_.push_back(n);
  }
}

HarmonicOperator HarmonicSample::complete(const HarmonicOperator& at_computed) const {
  EXPECTS(at_computed.size() == computed_.size());
  const auto first = static_cast<std::size_t>(kFirstSmooth);
  HarmonicOperator all;
  std::size_t next = 0;  // of the computed ones
  for (int n = 0; n <= highest_; ++n) {
    if (computed_[next] == n) {
      all.push_back(at_computed[next++]);
      continue;
    }
    all.push_back(Eigen::MatrixXd::Zero(at_computed[0].rows(), at_computed[0].cols()));
    for (std::size_t k = first; k < computed_.size(); ++k) {
      double weight = 1.0;
      for (std::size_t m = first; m < computed_.size(); ++m) {
        if (m == k) continue;
        const double here = sample_place(computed_[m]);
        weight *= (sample_place(n) - here) / (sample_place(computed_[k]) - here);
      }
      all.back().noalias() += weight * at_computed[k];
    }
  }
  return all;
}

Field apply(const Harmonics& harmonics, const HarmonicOperator& op, const Field& field) {
  return harmonics.synthesise(multiply(op, harmonics.analyse(field)));
}

}  // namespace shellback
