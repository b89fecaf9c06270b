/// Makes the table of the finite bearing's mobility that the tier `estimate` follows load cycles
/// with (fidelity/mobility_table.hpp).
///
///   make_mobility_table > data/tables/bearing_mobility.csv
///   make_mobility_table --between > FILE     between the rows of the table, on finer cells
///
/// Each point is solved on two grids, the second with half the steps of the first, and extrapolated
/// by the second order that tests/validation observes; the last column says how far the limit lies
/// from the finer grid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "validation/tables/squeeze_mobility.hpp"

namespace {

using namespace shellback;
using validation::MobilityPoint;
using validation::SqueezeMobility;

constexpr double kEnd = 0.02;  ///< of pi; nearer to the line of centres M_across is lost in cells

struct Nodes {
  std::vector<double> b;  ///< B/D
  std::vector<double> eps;
  std::vector<double> sweep;  ///< over pi, of the angle between load and line of centres
  int around;                 ///< cells of the finer grid, sixteen times those along
};

/// The middles between.
std::vector<double> middles(const std::vector<double>& x) {
  std::vector<double> m;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) m.push_back(0.5 * (x[k] + x[k + 1]));
  return m;
}

Nodes nodes(bool between) {
  Nodes n{{0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.5, 4.0, 8.0},
          {0.02, 0.15, 0.3, 0.45, 0.6, 0.7, 0.8, 0.87, 0.92, 0.95, 0.97, 0.98, 0.99, 0.995, 0.998,
           0.999},
          {kEnd},
          192};
  for (int k = 1; k < 12; ++k) n.sweep.push_back(k / 12.0);
  n.sweep.push_back(1.0 - kEnd);
  if (!between) return n;
  const auto sweep = middles(n.sweep);
  return {middles(n.b), middles(n.eps), {sweep[1], sweep[4], sweep[7], sweep[10]}, 288};
}

/// The limit of two grids of which the second has half the steps, second order.
double limit(double coarse, double fine) { return fine + (fine - coarse) / 3.0; }

std::string row(double b, double eps, double sweep, SqueezeMobility& coarse,
                SqueezeMobility& fine) {
  const double angle = validation::angle_of_sweep(kPi * sweep, eps);
  const auto one = coarse.at(-angle);  // the line of centres lies counter-clockwise of the load
  const auto two = fine.at(-angle);
  if (!one || !two) return "";
  double largest = 0.0;
  const auto of = [&](double MobilityPoint::*value) {
    const double result = limit(*one.*value, *two.*value);
    largest = std::max(largest, std::abs(result / (*two.*value) - 1.0));
    return result;
  };
  const double along = of(&MobilityPoint::along), across = of(&MobilityPoint::across);
  const double pressure = of(&MobilityPoint::pressure), side = of(&MobilityPoint::side);
  return fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.1e}\n", b, eps, sweep,
                     along, across, pressure, side, largest);
}

}  // namespace

int main(int argc, char** argv) {
  const Nodes n = nodes(argc > 1 && std::strcmp(argv[1], "--between") == 0);
  std::vector<std::string> rows(n.b.size() * n.eps.size());
  constexpr int kThreads = 2;
  parallel_for(static_cast<int>(rows.size()), kThreads, [&](int task) {
    const auto k = static_cast<std::size_t>(task);
    const double b = n.b[k / n.eps.size()], eps = n.eps[k % n.eps.size()];
    SqueezeMobility coarse(b, eps, n.around / 2, n.around / 32);
    SqueezeMobility fine(b, eps, n.around, n.around / 16);
    for (const double sweep : n.sweep) {
      const std::string next = row(b, eps, sweep, coarse, fine);
      if (next.empty()) {
        fmt::print(stderr, "B/D {} eps {} sweep {}: no settled set of cells\n", b, eps, sweep);
        std::exit(3);
      }
      rows[k] += next;
    }
  });
  fmt::print("# Made by make_mobility_table: see docs/auto-tier.md. Do not edit.\n");
  fmt::print("B_over_D,eps,sweep,along,across,p_max,side,largest_extrapolation\n");
  for (const std::string& each : rows) fmt::print("{}", each);
  return 0;
}
