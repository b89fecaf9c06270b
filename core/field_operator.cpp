#include "core/field_operator.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/lanes.hpp"

namespace shellback {
namespace {

using Eigen::Index;

/// Columns of a product that are summed side by side: with two registers a column twelve sums, as
/// many as the machine needs not to wait for one of them.
constexpr int kBlock = 6;
/// Registers of a column that are summed side by side: their sums must find room.
constexpr int kMostLanes = kLane == 8 ? 4 : 2;

int padded(int rows) { return (rows + kLane - 1) / kLane * kLane; }

int whole_blocks(int columns) { return (columns + kBlock - 1) / kBlock * kBlock; }

/// Columns b of `out` += sum_k f_k a(k, b): L registers of B columns. Columns stand `ld` apart.
template <int L, int B, class Factor>
void add_columns(const double* f, Index ld, int terms, const Factor& a, double* out) {
  Lane sum[B][L];
  for (int b = 0; b < B; ++b) {
    for (int l = 0; l < L; ++l) sum[b][l] = lanes(out + b * ld)[l];
  }
  for (int k = 0; k < terms; ++k, f += ld) {
    Lane x[L];
    for (int l = 0; l < L; ++l) x[l] = lanes(f)[l];
#pragma GCC unroll 8
    for (int b = 0; b < B; ++b) {
      const double factor = a(k, b);
#pragma GCC unroll 4
      for (int l = 0; l < L; ++l) sum[b][l] += x[l] * factor;
    }
  }
  for (int b = 0; b < B; ++b) {
    for (int l = 0; l < L; ++l) lanes(out + b * ld)[l] = sum[b][l];
  }
}

/// The same of all registers of a column.
template <int B, class Factor>
void add_columns(const double* f, Index ld, int terms, const Factor& a, double* out) {
  const int all = static_cast<int>(ld) / kLane;
  for (int l = 0; l < all; l += kMostLanes) {
    const double* from = f + l * kLane;
    double* to = out + l * kLane;
    switch (std::min(kMostLanes, all - l)) {
      case 1:
        add_columns<1, B>(from, ld, terms, a, to);
        break;
      case 2:
        add_columns<2, B>(from, ld, terms, a, to);
        break;
      case 3:
        add_columns<3, B>(from, ld, terms, a, to);
        break;
      default:
        add_columns<4, B>(from, ld, terms, a, to);
    }
  }
}

/// `m` block by block of columns, row by row, columns that are missing in the last one zero.
std::vector<double> in_blocks(const Eigen::MatrixXd& m) {
  const auto columns = static_cast<int>(m.cols());
  std::vector<double> out(static_cast<std::size_t>(m.rows()) * whole_blocks(columns), 0.0);
  for (int col = 0; col < columns; ++col) {
    const Index block = col / kBlock * kBlock * m.rows();
    for (Index row = 0; row < m.rows(); ++row) {
      out[block + row * kBlock + col % kBlock] = m(row, col);
    }
  }
  return out;
}

/// out += f m, m in_blocks, `columns` of them.
void add_product(const Eigen::MatrixXd& f, int terms, const std::vector<double>& m, int columns,
                 Eigen::MatrixXd& out) {
  for (int col = 0; col < columns; col += kBlock) {
    const double* block = m.data() + static_cast<std::size_t>(col) * terms;
    const auto factor = [block](int k, int b) { return block[k * kBlock + b]; };
    add_columns<kBlock>(f.data(), f.rows(), terms, factor, out.col(col).data());
  }
}

}  // namespace

FieldOperator::FieldOperator(const Harmonics& harmonics, const HarmonicOperator& op)
    : rows_(static_cast<int>(op.front().rows())),
      lines_(harmonics.lines()),
      coefficients_(harmonics.coefficients()),
      analysis_(in_blocks(harmonics.analysis())),
      synthesis_(in_blocks(harmonics.synthesis().transpose())) {
  EXPECTS(op.front().cols() == rows_ && static_cast<int>(op.size()) > harmonics.highest());
  const int ld = padded(rows_);
  const Eigen::MatrixXd& last = op[harmonics.highest()];
  last_ = Eigen::MatrixXd::Zero(ld, rows_);
  last_.topRows(rows_) = last;
  rest_ = Eigen::MatrixXd::Zero(ld, static_cast<Index>(rows_) * (harmonics.highest() + 1));
  for (int n = 0; n <= harmonics.highest(); ++n) {
    rest_.block(0, static_cast<Index>(n) * rows_, rows_, rows_) = op[n] - last;
  }
}

Field FieldOperator::operator()(const Field& field) const {
  EXPECTS(field.size() == static_cast<std::size_t>(rows_) * lines_);
  const int ld = padded(rows_);
  using Columns = Eigen::Map<const Eigen::MatrixXd>;
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(ld, whole_blocks(lines_));
  f.topLeftCorner(rows_, lines_) = Columns(field.data(), rows_, lines_);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(ld, whole_blocks(coefficients_));
  add_product(f, lines_, analysis_, coefficients_, c);
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(ld, coefficients_);
  for (int n = 0; 2 * n < coefficients_; ++n) {
    const int col = std::max(2 * n - 1, 0);
    const double* at = c.col(col).data();
    const auto factor = [at, ld](int k, int b) { return at[b * ld + k]; };
    const double* op = rest_.col(static_cast<Index>(n) * rows_).data();
    if (n == 0) {
      add_columns<1>(op, ld, rows_, factor, u.col(0).data());
    } else {
      add_columns<2>(op, ld, rows_, factor, u.col(col).data());
    }
  }
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(ld, whole_blocks(lines_));
  for (int col = 0; col < lines_; col += kBlock) {
    const double* at = f.col(col).data();
    const auto factor = [at, ld](int k, int b) { return at[b * ld + k]; };
    add_columns<kBlock>(last_.data(), ld, rows_, factor, out.col(col).data());
  }
  add_product(u, coefficients_, synthesis_, lines_, out);
  Field result(field.size());
  Eigen::Map<Eigen::MatrixXd>(result.data(), rows_, lines_) = out.topLeftCorner(rows_, lines_);
  return result;
}

}  // namespace shellback
