#include "surface/patch_flow.hpp"

#include <array>
#include <memory>
#include <optional>

#include "core/contract.hpp"
#include "surface/sparse_spd.hpp"

namespace shellback::surface {
namespace {

constexpr int kNobody = -1;
constexpr int kLeftEnd = 1, kRightEnd = 2;  ///< bits of the ends that a region reaches

/// An open cell beside another one.
struct Neighbour {
  int cell = 0;
  int rounds = 0;  ///< how often the way there goes round the periodic patch along x
};

/// Numbers the open cells and solves for them.
class Patch {
 public:
  Patch(const PatchGap& gap, PatchEnds ends)
      : g_(gap), periodic_(ends == PatchEnds::periodic), number_(gap.h.size(), kNobody) {
    for (std::size_t c = 0; c < g_.h.size(); ++c) {
      EXPECTS(g_.h[c] >= 0.0);
      if (g_.h[c] > 0.0) number_[c] = open_++;
    }
    if (open_ > 0) factorise();
  }

  /// Whether oil gets from one end to the other.
  [[nodiscard]] bool passes() const { return passes_; }

  /// Flows over the faces in x per width, index j * (nx + 1) + i: pressure flow (couette = 0) or
  /// sliding (driven = 0); pressures are those of (1) or 1/12 of (2).
  [[nodiscard]] std::vector<double> flows(double driven, double couette) const {
    std::vector<double> flow(static_cast<std::size_t>(g_.nx + 1) * g_.ny, 0.0);
    if (open_ == 0) return flow;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(open_);
    each_x_face([&](std::size_t face, int left, int right, double k, double s, double) {
      flow[face] = k * driven + 0.5 * s * couette;
      if (is_second_of_seam(face)) return;
      if (left != kNobody) rhs[left] -= flow[face] * g_.dy;
      if (right != kNobody) rhs[right] += flow[face] * g_.dy;
    });
    // The flow is k dP/dx in (1), s/2 - k dp/dx in (2).
    const double sign = driven != 0.0 ? 1.0 : -1.0;
    const Eigen::VectorXd p = factor_->solve(Eigen::VectorXd(-sign * rhs));
    each_x_face([&](std::size_t face, int left, int right, double k, double, double d) {
      const double rise = (right == kNobody ? 0.0 : p[right]) - (left == kNobody ? 0.0 : p[left]);
      flow[face] += sign * k * rise / d;
    });
    return flow;
  }

  /// Sum over the half cells in x of f(h, flow) times their share of the patch; contact left out.
  template <class F>
  [[nodiscard]] double mean(const std::vector<double>& flow, const F& f) const {
    double sum = 0.0;
    for (int j = 0; j < g_.ny; ++j) {
      for (int i = 0; i < g_.nx; ++i) {
        const double h = g_.h[cell(i, j)];
        if (h == 0.0) continue;
        const std::size_t face = static_cast<std::size_t>(j) * (g_.nx + 1) + i;
        sum += f(h, flow[face]) + f(h, flow[face + 1]);
      }
    }
    return 0.5 * sum / static_cast<double>(g_.h.size());
  }

 private:
  [[nodiscard]] std::size_t cell(int i, int j) const {
    return static_cast<std::size_t>(j) * g_.nx + i;
  }
  [[nodiscard]] bool is_second_of_seam(std::size_t face) const {
    return periodic_ &&
           face % static_cast<std::size_t>(g_.nx + 1) == static_cast<std::size_t>(g_.nx);
  }
  [[nodiscard]] bool is_first_of_seam(std::size_t face) const {
    return periodic_ && face % static_cast<std::size_t>(g_.nx + 1) == 0;
  }
  [[nodiscard]] static double cube(double h) { return h * h * h; }

  /// Two half cells in series; 0 if one is closed.
  [[nodiscard]] static double series(double a, double b) {
    return a > 0.0 && b > 0.0 ? 2.0 * cube(a) * cube(b) / (cube(a) + cube(b)) : 0.0;
  }

  /// visit(face, left cell, right cell, mobility, Couette gap, distance) for every face in x that
  /// lets oil through. At the ends of a patch one cell is nobody; the periodic seam comes twice,
  /// as first and as last face, of which only the first feeds the balance.
  template <class Visit>
  void each_x_face(const Visit& visit) const {
    for (int j = 0; j < g_.ny; ++j) {
      for (int i = 0; i <= g_.nx; ++i) {
        const std::size_t face = static_cast<std::size_t>(j) * (g_.nx + 1) + i;
        const bool end = i == 0 || i == g_.nx;
        if (end && !periodic_) {
          const std::size_t c = cell(i == 0 ? 0 : g_.nx - 1, j);
          if (number_[c] == kNobody) continue;
          const double h = g_.h[c];
          visit(face, i == 0 ? kNobody : number_[c], i == 0 ? number_[c] : kNobody, cube(h), h,
                0.5 * g_.dx);
          continue;
        }
        const std::size_t a = cell((i + g_.nx - 1) % g_.nx, j), b = cell(i % g_.nx, j);
        const double ha = g_.h[a], hb = g_.h[b];
        if (ha == 0.0 || hb == 0.0) continue;
        const double s = ha * hb * (ha * ha + hb * hb) / (cube(ha) + cube(hb));
        visit(face, number_[a], number_[b], series(ha, hb), s, g_.dx);
      }
    }
  }

  void factorise() {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(open_));
    std::vector<int> ends(static_cast<std::size_t>(open_), 0);
    const auto join = [&](int a, int b, double w, int rounds) {
      entries.emplace_back(a, a, w);
      entries.emplace_back(b, b, w);
      entries.emplace_back(a, b, -w);
      entries.emplace_back(b, a, -w);
      neighbours[static_cast<std::size_t>(a)].push_back({b, rounds});
      neighbours[static_cast<std::size_t>(b)].push_back({a, -rounds});
    };
    each_x_face([&](std::size_t face, int left, int right, double k, double, double d) {
      const double w = k * g_.dy / d;
      if (left != kNobody && right != kNobody) {
        if (!is_second_of_seam(face)) join(left, right, w, is_first_of_seam(face) ? 1 : 0);
      } else {
        const int inner = left == kNobody ? right : left;
        entries.emplace_back(inner, inner, w);
        ends[static_cast<std::size_t>(inner)] |= left == kNobody ? kLeftEnd : kRightEnd;
      }
    });
    for (int j = periodic_ ? 0 : 1; j < g_.ny; ++j) {
      for (int i = 0; i < g_.nx; ++i) {
        const std::size_t a = cell(i, (j + g_.ny - 1) % g_.ny), b = cell(i, j);
        const double k = series(g_.h[a], g_.h[b]);
        if (k > 0.0) join(number_[a], number_[b], k * g_.dx / g_.dy, 0);
      }
    }
    visit_regions(neighbours, ends, entries);
    factor_ = std::make_unique<SparseSpd>(open_, entries);
  }

  /// Holds one cell of every connected region that no end holds, and finds out whether oil passes:
  /// through a region that reaches both ends or, of a periodic patch, comes back to where it began
  /// after going round.
  void visit_regions(const std::vector<std::vector<Neighbour>>& neighbours,
                     const std::vector<int>& ends, std::vector<Eigen::Triplet<double>>& entries) {
    std::vector<char> seen(static_cast<std::size_t>(open_), 0);
    std::vector<int> rounds(static_cast<std::size_t>(open_), 0);  // since the region's first cell
    std::vector<double> scale(static_cast<std::size_t>(open_), 0.0);
    for (std::size_t c = 0; c < number_.size(); ++c) {
      if (number_[c] != kNobody) scale[static_cast<std::size_t>(number_[c])] = cube(g_.h[c]);
    }
    for (int first = 0; first < open_; ++first) {
      if (seen[static_cast<std::size_t>(first)]) continue;
      int reached = 0;
      std::vector<int> stack{first};
      seen[static_cast<std::size_t>(first)] = 1;
      while (!stack.empty()) {
        const auto c = static_cast<std::size_t>(stack.back());
        stack.pop_back();
        reached |= ends[c];
        for (const Neighbour& next : neighbours[c]) {
          const auto n = static_cast<std::size_t>(next.cell);
          if (seen[n]) {
            passes_ = passes_ || rounds[n] != rounds[c] + next.rounds;
            continue;
          }
          seen[n] = 1;
          rounds[n] = rounds[c] + next.rounds;
          stack.push_back(next.cell);
        }
      }
      passes_ = passes_ || reached == (kLeftEnd | kRightEnd);
      if (reached == 0) entries.emplace_back(first, first, scale[static_cast<std::size_t>(first)]);
    }
  }

  const PatchGap& g_;
  bool periodic_;
  std::vector<int> number_;  ///< of a cell among the open ones
  int open_ = 0;
  bool passes_ = false;
  std::unique_ptr<SparseSpd> factor_;
};

}  // namespace

PatchMeans patch_flow(const PatchGap& gap, PatchEnds ends) {
  const Patch patch(gap, ends);
  const std::vector<double> pressure = patch.flows(1.0, 0.0);
  const std::vector<double> sliding = patch.flows(0.0, 1.0);
  PatchMeans m;
  if (patch.passes()) {
    m.conductance = patch.mean(pressure, [](double, double q) { return q; });
    m.pressure_shear = patch.mean(pressure, [](double h, double q) { return q / (h * h); });
  }
  m.couette = 2.0 * patch.mean(sliding, [](double, double q) { return q; });
  m.sliding_pressure =
      patch.mean(sliding, [](double h, double q) { return 3.0 / h - 6.0 * q / (h * h); });
  return m;
}

double patch_conductance(const PatchGap& gap, PatchEnds ends) {
  const Patch patch(gap, ends);
  if (!patch.passes()) return 0.0;
  return patch.mean(patch.flows(1.0, 0.0), [](double, double q) { return q; });
}

PatchGap exchanged(const PatchGap& gap) {
  PatchGap out{gap.ny, gap.nx, gap.dy, gap.dx, std::vector<double>(gap.h.size())};
  for (int j = 0; j < gap.ny; ++j) {
    for (int i = 0; i < gap.nx; ++i) {
      out.h[static_cast<std::size_t>(i) * gap.ny + j] =
          gap.h[static_cast<std::size_t>(j) * gap.nx + i];
    }
  }
  return out;
}

}  // namespace shellback::surface
