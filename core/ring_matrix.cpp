#include "core/ring_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/contract.hpp"
#include "core/lanes.hpp"

namespace shellback {
namespace {

bool all_zero(const double* x, int n) {
  for (int k = 0; k < n; ++k) {
    if (x[k] != 0.0) return false;
  }
  return true;
}

/// Columns that are multiplied together: what they add up to stays in registers.
template <int LD>
inline constexpr int kTogether = LD <= 48 ? 4 : 2;

/// W columns of A * B.
template <int LD, int W>
inline void multiply_columns(const double* a, const double* const* b, double* const* c, int n) {
  constexpr int L = LD / kLane;
  Lane sum[W][L];
  for (int w = 0; w < W; ++w) {
    for (int l = 0; l < L; ++l) sum[w][l] = Lane{};
  }
  for (int k = 0; k < n; ++k) {
    const Lane* ak = lanes(a + k * LD);
    for (int w = 0; w < W; ++w) {
      for (int l = 0; l < L; ++l) sum[w][l] += ak[l] * b[w][k];
    }
  }
  for (int w = 0; w < W; ++w) {
    for (int l = 0; l < L; ++l) lanes(c[w])[l] = sum[w][l];
  }
}

/// C = A * B for column-major LD x n blocks; padding rows hold zeros. Columns of zeros, of which
/// the border of a film fed across most of its width has many, cost nothing.
template <int LD>
void multiply(const double* a, const double* b, double* c, int n) {
  const double* from[kTogether<LD>];
  double* to[kTogether<LD>];
  int m = 0;
  for (int col = 0; col < n; ++col) {
    from[m] = b + col * LD;
    to[m] = c + col * LD;
    if (all_zero(from[m], n)) {
      std::memset(to[m], 0, LD * sizeof(double));
    } else if (++m == kTogether<LD>) {
      multiply_columns<LD, kTogether<LD>>(a, from, to, n);
      m = 0;
    }
  }
  for (int k = 0; k < m; ++k) multiply_columns<LD, 1>(a, from + k, to + k, n);
}

/// C -= A * B, as above.
template <int LD>
void subtract_product(const double* a, const double* b, double* c, int n) {
  constexpr int L = LD / kLane;
  for (int col = 0; col < n; ++col) {
    const double* bc = b + col * LD;
    if (all_zero(bc, n)) continue;
    Lane left[L];
    for (int l = 0; l < L; ++l) left[l] = lanes(c + col * LD)[l];
    for (int k = 0; k < n; ++k) {
      for (int l = 0; l < L; ++l) left[l] -= lanes(a + k * LD)[l] * bc[k];
    }
    for (int l = 0; l < L; ++l) lanes(c + col * LD)[l] = left[l];
  }
}

/// C = A * B with a diagonal A.
template <int LD>
void scale_rows(const double* a, const double* b, double* c, int n) {
  double d[LD] = {};
  for (int k = 0; k < n; ++k) d[k] = a[k * LD + k];
  for (int col = 0; col < n; ++col) {
    for (int l = 0; l < LD / kLane; ++l) {
      lanes(c + col * LD)[l] = lanes(d)[l] * lanes(b + col * LD)[l];
    }
  }
}

/// C = A * B with a diagonal B.
template <int LD>
void scale_columns(const double* a, const double* b, double* c, int n) {
  for (int col = 0; col < n; ++col) {
    for (int l = 0; l < LD / kLane; ++l) {
      lanes(c + col * LD)[l] = lanes(a + col * LD)[l] * b[col * LD + col];
    }
  }
}

/// y = A x: two sums, neither of which waits for the other.
template <int LD>
void apply(const double* a, const double* x, double* y, int n) {
  constexpr int L = LD / kLane;
  Lane even[L], odd[L];
  for (int l = 0; l < L; ++l) even[l] = odd[l] = Lane{};
  int k = 0;
  for (; k + 1 < n; k += 2) {
    for (int l = 0; l < L; ++l) even[l] += lanes(a + k * LD)[l] * x[k];
    for (int l = 0; l < L; ++l) odd[l] += lanes(a + (k + 1) * LD)[l] * x[k + 1];
  }
  if (k < n) {
    for (int l = 0; l < L; ++l) even[l] += lanes(a + k * LD)[l] * x[k];
  }
  for (int l = 0; l < L; ++l) lanes(y)[l] = even[l] + odd[l];
}

/// y = A x for a diagonal A.
template <int LD>
void apply_diagonal(const double* a, const double* x, double* y, int n) {
  for (int k = 0; k < n; ++k) y[k] = a[k * LD + k] * x[k];
  for (int k = n; k < LD; ++k) y[k] = 0.0;
}

/// Row of `a` from k on with the largest entry in column k.
template <int LD>
int pivot_row(const double* a, int k, int n) {
  int best = k;
  for (int r = k + 1; r < n; ++r) {
    if (std::abs(a[k * LD + r]) > std::abs(a[k * LD + best])) best = r;
  }
  return best;
}

/// One step of Gauss-Jordan inversion: row and column k, d the inverse of their pivot. Row k takes
/// part in it from nought: written behind the others, it would be waited for in the next step.
template <int LD>
inline void eliminate(double* a, int k, double d, int n) {
  constexpr int L = LD / kLane;
  double factors[LD], others[LD];
  for (int l = 0; l < L; ++l) lanes(factors)[l] = lanes(a + k * LD)[l] * -d;
  factors[k] = d;
  std::fill(others, others + LD, 1.0);
  others[k] = 0.0;
  Lane step[L], rest[L];
  for (int l = 0; l < L; ++l) {
    step[l] = lanes(factors)[l];
    rest[l] = lanes(others)[l];
  }
  for (int col = 0; col < n; ++col) {
    if (col == k) continue;
    Lane* ac = lanes(a + col * LD);
    const double f = a[col * LD + k];
    for (int l = 0; l < L; ++l) ac[l] = ac[l] * rest[l] + step[l] * f;
  }
  for (int l = 0; l < L; ++l) lanes(a + k * LD)[l] = step[l];
}
/// Gauss-Jordan inversion in place with partial pivoting; false if singular.
template <int LD>
bool invert(double* a, int n) {
  std::vector<int> swapped(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) {
    const int p = pivot_row<LD>(a, k, n);
    swapped[k] = p;
    if (p != k) {
      for (int col = 0; col < n; ++col) std::swap(a[col * LD + k], a[col * LD + p]);
    }
    const double pivot = a[k * LD + k];
    if (pivot == 0.0 || !std::isfinite(pivot)) return false;
    eliminate<LD>(a, k, 1.0 / pivot, n);
  }
  for (int k = n - 1; k >= 0; --k) {
    const int p = swapped[k];
    if (p == k) continue;
    for (int r = 0; r < LD; ++r) std::swap(a[k * LD + r], a[p * LD + r]);
  }
  return true;
}

/// Inverse of a diagonal block, in place; false if singular.
template <int LD>
bool invert_diagonal(double* a, int n) {
  for (int k = 0; k < n; ++k) {
    double& d = a[k * LD + k];
    if (d == 0.0 || !std::isfinite(d)) return false;
    d = 1.0 / d;
  }
  return true;
}

// The steps of the elimination belong into its loop. Left to the compiler, a factorisation takes 4
// % longer with 13 cells to a line, and as long with 25 and 50 (GCC 12, 2026-11-22).
#define SHELLBACK_IN_THE_LOOP [[gnu::always_inline]] inline

/// The tridiagonal block of one line, `row0` its first row in the matrix.
template <int LD>
SHELLBACK_IN_THE_LOOP void fill_block(const RingMatrix& a, std::size_t row0, double* d, int n) {
  std::memset(d, 0, static_cast<std::size_t>(LD) * n * sizeof(double));
  for (int k = 0; k < n; ++k) {
    d[k * LD + k] = a.c[row0 + k];
    if (k > 0) d[(k - 1) * LD + k] = a.s[row0 + k];
    if (k + 1 < n) d[(k + 1) * LD + k] = a.n[row0 + k];
  }
}

/// D -= w o (previous inverse) o e: what is left of a block when the line before is eliminated.
template <int LD>
SHELLBACK_IN_THE_LOOP void subtract_previous(const double* w, const double* previous,
                                             const double* e, double* d, int n) {
  for (int col = 0; col < n; ++col) {
    for (int l = 0; l < LD / kLane; ++l) {
      lanes(d + col * LD)[l] -= lanes(w)[l] * lanes(previous + col * LD)[l] * e[col];
    }
  }
}

/// v of the next line: -w_next o (inverse v).
template <int LD>
SHELLBACK_IN_THE_LOOP void next_border_column(const double* w, const double* iv, double* v, int n) {
  for (int col = 0; col < n; ++col) {
    for (int l = 0; l < LD / kLane; ++l) {
      lanes(v + col * LD)[l] = -lanes(w)[l] * lanes(iv + col * LD)[l];
    }
  }
}

/// u of the next line: -(u inverse) o e.
template <int LD>
SHELLBACK_IN_THE_LOOP void next_border_row(const double* ui, const double* e, double* u, int n) {
  for (int col = 0; col < n; ++col) {
    for (int l = 0; l < LD / kLane; ++l) {
      lanes(u + col * LD)[l] = -lanes(ui + col * LD)[l] * e[col];
    }
  }
}

/// Adds the couplings of a line to the diagonal of a border block.
template <int LD>
SHELLBACK_IN_THE_LOOP void add_diagonal(const double* x, double* block, int n) {
  for (int k = 0; k < n; ++k) block[k * LD + k] += x[k];
}

/// Calls f.template operator()<LD>() for the padded size `ld`.
template <class F, int LD = kRegister>
auto with_padding(int ld, F&& f) {
  if constexpr (LD < kLongestLine) {
    if (ld > LD) return with_padding<F, LD + kRegister>(ld, std::forward<F>(f));
  }
  return f.template operator()<LD>();
}

}  // namespace

void RingMatrix::resize(int lines, int per_line) {
  nt = lines;
  nz = per_line;
  for (auto* a : {&c, &w, &e, &s, &n}) a->assign(static_cast<std::size_t>(nt) * nz, 0.0);
}

void RingMatrix::multiply(const std::vector<double>& x, std::vector<double>& y) const {
  y.assign(x.size(), 0.0);
  for (int i = 0; i < nt; ++i) {
    const int west = (i == 0 ? nt - 1 : i - 1) * nz;
    const int east = (i + 1 == nt ? 0 : i + 1) * nz;
    for (int j = 0; j < nz; ++j) {
      const int k = i * nz + j;
      y[k] = c[k] * x[k] + w[k] * x[west + j] + e[k] * x[east + j];
      if (j > 0) y[k] += s[k] * x[k - 1];
      if (j + 1 < nz) y[k] += n[k] * x[k + 1];
    }
  }
}

bool RingFactor::factorize(const RingMatrix& a) {
  EXPECTS(a.nt >= 3 && a.nz >= 1);
  nt_ = a.nt;
  nz_ = a.nz;
  ld_ = (nz_ + kRegister - 1) / kRegister * kRegister;
  if (ld_ > kLongestLine)
    throw InputError(
        fmt::format("more than {} axial cells are solved; use a coarser grid", kLongestLine));
  first_ = 0;
  row_border_ = true;  // unless the ring can be cut where no line depends on the one after it
  int fewest = nz_ + 1;
  for (int i = 0; i < nt_; ++i) {
    const int before = (i == 0 ? nt_ - 1 : i - 1) * nz_;
    if (!all_zero(&a.e[before], nz_)) continue;
    const double* w = &a.w[static_cast<std::size_t>(i) * nz_];
    const int coupled = nz_ - static_cast<int>(std::count(w, w + nz_, 0.0));
    if (coupled >= fewest) continue;
    fewest = coupled;
    first_ = i;
    row_border_ = false;
  }
  column_border_ = fewest > 0;
  return with_padding(ld_, [&]<int LD>() { return factorize_padded<LD>(a); });
}

template <int LD>
void RingFactor::take_couplings(const RingMatrix& a) {
  w_.assign(static_cast<std::size_t>(nt_) * LD, 0.0);
  e_.assign(static_cast<std::size_t>(nt_) * LD, 0.0);
  for (int i = 0; i < nt_; ++i) {
    const std::size_t from = static_cast<std::size_t>(line(i)) * nz_;
    std::memcpy(&w_[static_cast<std::size_t>(i) * LD], &a.w[from], nz_ * sizeof(double));
    std::memcpy(&e_[static_cast<std::size_t>(i) * LD], &a.e[from], nz_ * sizeof(double));
  }
}

template <int LD>
bool RingFactor::factorize_padded(const RingMatrix& a) {
  const int n = nz_;
  const std::size_t block = static_cast<std::size_t>(LD) * n;
  const int last = nt_ - 1;
  inverse_.resize(block * nt_);
  diagonal_.assign(nt_, 0);
  inverse_v_.resize(column_border_ ? block * nt_ : block * 1);
  u_inverse_.resize(row_border_ ? block * nt_ : block * 1);
  take_couplings<LD>(a);
  const auto w = [&](int i) { return &w_[static_cast<std::size_t>(i) * LD]; };
  const auto e = [&](int i) { return &e_[static_cast<std::size_t>(i) * LD]; };
  std::vector<double> v(block, 0.0), u(block, 0.0), corner(block, 0.0);
  add_diagonal<LD>(w(0), v.data(), n);
  add_diagonal<LD>(e(last), u.data(), n);
  for (int i = 0; i < last; ++i) {
    double* d = &inverse_[block * i];
    const std::size_t row0 = static_cast<std::size_t>(line(i)) * n;
    fill_block<LD>(a, row0, d, n);
    const bool follows = i > 0 && !all_zero(e(i - 1), n);
    if (follows) subtract_previous<LD>(w(i), &inverse_[block * (i - 1)], e(i - 1), d, n);
    if (i == last - 1) {  // its coupling to the last line is part of the border
      add_diagonal<LD>(e(i), v.data(), n);
      add_diagonal<LD>(w(last), u.data(), n);
    }
    const bool diagonal = !follows && all_zero(&a.s[row0], n) && all_zero(&a.n[row0], n);
    diagonal_[i] = diagonal;
    if (!(diagonal ? invert_diagonal<LD>(d, n) : invert<LD>(d, n))) return false;
    const bool has_v = column_border_ || i == last - 1;
    const bool has_u = row_border_ || i == last - 1;
    double* iv = &inverse_v_[column_border_ ? block * i : 0];
    double* ui = &u_inverse_[row_border_ ? block * i : 0];
    if (has_v) diagonal ? scale_rows<LD>(d, v.data(), iv, n) : multiply<LD>(d, v.data(), iv, n);
    if (has_u) diagonal ? scale_columns<LD>(u.data(), d, ui, n) : multiply<LD>(u.data(), d, ui, n);
    if (has_u && has_v) subtract_product<LD>(ui, v.data(), corner.data(), n);
    if (column_border_) next_border_column<LD>(w(i + 1), iv, v.data(), n);
    if (row_border_) next_border_row<LD>(ui, e(i), u.data(), n);
  }
  double* d = &inverse_[block * last];
  fill_block<LD>(a, static_cast<std::size_t>(line(last)) * n, d, n);
  for (std::size_t k = 0; k < block; ++k) d[k] += corner[k];
  return invert<LD>(d, n);
}

template <int LD>
void RingFactor::apply_inverse(int i, const double* x, double* y) const {
  const double* a = &inverse_[static_cast<std::size_t>(LD) * nz_ * i];
  diagonal_[i] ? apply_diagonal<LD>(a, x, y, nz_) : apply<LD>(a, x, y, nz_);
}

template <int LD>
void RingFactor::solve_padded(double* b) const {
  const int n = nz_;
  const std::size_t block = static_cast<std::size_t>(LD) * n;
  const int last = nt_ - 1;
  std::vector<double> z(static_cast<std::size_t>(nt_) * LD, 0.0);  // inverse times reduced rhs
  double y[LD] = {}, t[LD] = {}, border[LD] = {};
  std::memcpy(border, b + static_cast<std::size_t>(line(last)) * n, n * sizeof(double));
  for (int i = 0; i < last; ++i) {
    std::memcpy(y, b + static_cast<std::size_t>(line(i)) * n, n * sizeof(double));
    if (i > 0) {
      const double* wi = &w_[static_cast<std::size_t>(i) * LD];
      const double* zp = &z[static_cast<std::size_t>(i - 1) * LD];
      for (int r = 0; r < LD; ++r) y[r] -= wi[r] * zp[r];
    }
    apply_inverse<LD>(i, y, &z[static_cast<std::size_t>(i) * LD]);
    if (row_border_ || i == last - 1) {
      apply<LD>(&u_inverse_[row_border_ ? block * i : 0], y, t, n);
      for (int r = 0; r < LD; ++r) border[r] -= t[r];
    }
  }
  double x_last[LD], x[LD];
  apply<LD>(&inverse_[block * last], border, x_last, n);
  std::memcpy(b + static_cast<std::size_t>(line(last)) * n, x_last, n * sizeof(double));
  double coupled[LD] = {};  // what the first line takes over from the last
  for (int k = 0; k < n; ++k) coupled[k] = w_[k] != 0.0 ? x_last[k] : 0.0;
  for (int i = last - 1; i >= 0; --i) {
    const double* zi = &z[static_cast<std::size_t>(i) * LD];
    for (int r = 0; r < LD; ++r) y[r] = 0.0;
    const double* ei = &e_[static_cast<std::size_t>(i) * LD];
    if (i < last - 1 && !all_zero(ei, n)) {
      for (int r = 0; r < LD; ++r) y[r] = ei[r] * x[r];
      apply_inverse<LD>(i, y, t);
      for (int r = 0; r < LD; ++r) x[r] = zi[r] - t[r];
    } else {
      for (int r = 0; r < LD; ++r) x[r] = zi[r];
    }
    if (column_border_ || i == last - 1) {
      const double* from = i == last - 1 ? x_last : coupled;
      apply<LD>(&inverse_v_[column_border_ ? block * i : 0], from, t, n);
      for (int r = 0; r < LD; ++r) x[r] -= t[r];
    }
    std::memcpy(b + static_cast<std::size_t>(line(i)) * n, x, n * sizeof(double));
  }
}

void RingFactor::solve(double* b, int count) const {
  for (int k = 0; k < count; ++k) {
    double* rhs = b + static_cast<std::size_t>(k) * nt_ * nz_;
    with_padding(ld_, [&]<int LD>() { solve_padded<LD>(rhs); });
  }
}

}  // namespace shellback
