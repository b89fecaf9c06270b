// The table of the finite bearing's mobility: against closed forms at both ends of the width, a
// published solution of the squeeze film, the steady bearing, its own potential, and the solver
// that made it.
#include "fidelity/mobility_table.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/constants.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/closed_forms.hpp"
#include "tests/read_csv.hpp"
#include "validation/tables/squeeze_mobility.hpp"

namespace shellback::fidelity {
namespace {

using test::CsvRow;
using test::read_csv;
using validation::angle_of_sweep;
using validation::SqueezeMobility;

constexpr double kDegree = kPi / 180.0;

struct Vector {
  double x = 0.0;
  double y = 0.0;
};

/// W psi^2/(B D) over eta |v|/c of the narrow bearing's half film, by quadrature [-]; v has the
/// angle `gamma` from the line of centres: p = 6 eta v.n (B^2/4 - z^2)/h^3 where it is positive.
Vector narrow_impedance(double eps, double gamma, double b) {
  constexpr int kPoints = 20000;
  Vector sum;
  for (int k = 0; k < kPoints; ++k) {
    const double phi = 2.0 * kPi * (k + 0.5) / kPoints;
    const double closing = std::cos(phi - gamma);
    if (closing <= 0.0) continue;
    const double h = 1.0 - eps * std::cos(phi);
    const double p = 2.0 * b * b * closing / (h * h * h) * 2.0 * kPi / kPoints;
    sum.x += p * std::cos(phi);
    sum.y += p * std::sin(phi);
  }
  return sum;
}

/// Angle from the load to the line of centres, and load, of a journal that stands still while the
/// shell's oil goes by: v = -omega/2 x e.
struct Steady {
  double attitude = 0.0;
  double so = 0.0;
};
Steady steady(const MobilityMap& map, double eps) {
  // v is at right angles to e: M_along cos(alpha) + M_across sin(alpha) = 0.
  const auto radial = [&](double alpha) {
    const Mobility m = map.at(eps, alpha);
    return -(m.along * std::cos(alpha) + m.across * std::sin(alpha));
  };
  Steady s;
  s.attitude = root_between(radial, 0.01, kPi - 0.01, 1e-10);
  const Mobility m = map.at(eps, s.attitude);
  s.so = eps / (2.0 * std::hypot(m.along, m.across));
  return s;
}

}  // namespace

TEST_CASE("InterpolatedMobilityLiesWithinTheStatedError", "[mobility]") {
  // The solver on finer cells, asked between the rows of the table in all three directions.
  int points = 0, inside = 0;
  double worst = 0.0;
  for (const CsvRow& row : read_csv("validation/tables/bearing_mobility_between.csv")) {
    const double eps = row.at("eps");
    const MobilityMap map(row.at("B_over_D"));
    const Mobility m = map.at(eps, angle_of_sweep(kPi * row.at("sweep"), eps));
    const double size = std::hypot(row.at("along"), row.at("across"));
    for (const double off :
         {(m.along - row.at("along")) / size, (m.across - row.at("across")) / size,
          m.pressure / row.at("p_max") - 1.0, m.side / row.at("side") - 1.0}) {
      ++points;
      inside += std::abs(off) < kMobilityError;
      worst = std::max(worst, std::abs(off));
    }
  }
  INFO("worst " << worst << ", inside " << inside << " of " << points);
  CHECK(points == 2400);
  CHECK(inside > 0.98 * points);
  CHECK(worst < 4.0 * kMobilityError);
}

TEST_CASE("CellsOfTheMobilityFilmAreOfSecondOrder", "[mobility]") {
  for (const double b : {0.25, 1.0}) {
    for (const double eps : {0.3, 0.9}) {
      for (const double load : {0.0, -100.0 * kDegree}) {
        std::vector<double> M;
        for (const int n : {96, 192, 384}) {
          M.push_back(SqueezeMobility(b, eps, n, n / 16).at(load)->along);
        }
        INFO("B/D " << b << ", eps " << eps << ", load " << load);
        CHECK(std::log2((M[1] - M[0]) / (M[2] - M[1])) == Approx(2.0).margin(0.15));
      }
    }
  }
}

TEST_CASE("NarrowMobilityIsThatOfTheHalfFilm", "[mobility]") {
  // B/D = 0.01 asks the narrow end of the table, which is off by (B/D)^2 = 0.3 % times a few
  // where the film is thin.
  const double b = 0.01;
  const MobilityMap map(b);
  for (const double eps : {0.1, 0.4, 0.7, 0.9}) {
    for (const double gamma : {0.0, 40.0, 80.0, 120.0, 160.0, 180.0}) {
      const Vector load = narrow_impedance(eps, gamma * kDegree, b);
      const double size = std::hypot(load.x, load.y);
      const double direction = std::atan2(load.y, load.x);
      const Mobility m = map.at(eps, -direction);
      INFO("eps " << eps << ", motion at " << gamma << " deg");
      CHECK(std::hypot(m.along, m.across) * size == Approx(1.0).epsilon(0.02));
      const double found = direction + std::atan2(m.across, m.along);
      CHECK(std::remainder(found - gamma * kDegree, 2.0 * kPi) == Approx(0.0).margin(0.02));
      CHECK(m.side == Approx(1.0).epsilon(2e-3));  // all oil that is displaced leaves at the edges
      CHECK(m.along == Approx(narrow_mobility(eps, -direction, b)).epsilon(0.02 + 0.1 * eps * eps));
    }
  }
}

TEST_CASE("WideMobilityIsThatOfTheFilmWithoutEnds", "[mobility]") {
  // Along the line of centres. Ends take part in 1/b: from B/D = 4 and 8 to none. What is left is
  // of order 1/b^2 times what the ends take, which falls as the film grows thin against the width.
  const MobilityMap four(4.0), eight(8.0);
  for (const double eps : {0.1, 0.5, 0.8, 0.95}) {
    const double limit = 2.0 * eight.at(eps, 0.0).along - four.at(eps, 0.0).along;
    INFO("eps " << eps);
    CHECK(limit == Approx(wide_mobility(eps, 0.0)).epsilon(0.01 + 0.12 * (1.0 - eps)));
  }
}

TEST_CASE("MobilityIsTheSlopeOfAPotential", "[mobility]") {
  // The film's forces minimise: v = grad of a convex function of W, so M_across = -M_along'/2. The
  // two are interpolated on their own; a slope is known to the error over some of a field's width.
  for (const double b : {0.13, 0.4, 1.2, 3.0}) {
    const MobilityMap map(b);
    for (const double eps : {0.05, 0.4, 0.75, 0.9, 0.96}) {
      for (double alpha = 10.0 * kDegree; alpha < kPi; alpha += 20.0 * kDegree) {
        constexpr double kStep = 1e-4;
        const double slope =
            (map.at(eps, alpha + kStep).along - map.at(eps, alpha - kStep).along) / (2.0 * kStep);
        const Mobility m = map.at(eps, alpha);
        INFO("B/D " << b << ", eps " << eps << ", alpha " << alpha / kDegree);
        CHECK(m.across + 0.5 * slope == Approx(0.0).margin(0.03 * std::hypot(m.along, m.across)));
      }
    }
  }
}

TEST_CASE("SqueezeAlongTheLineOfCentresIsThatOfButenschoen", "[mobility]") {
  // So = F psi^2/(B D eta |deps/dt|) = 1/M_along. The column of an independent program, where it
  // has none the thesis's, printed to four decimals.
  int rows = 0;
  for (const CsvRow& row : read_csv("validation/data/butenschoen_1976_squeeze.csv")) {
    const double eps = row.at("eps"), own = row.at("own_So");
    const double so = std::isfinite(own) ? own : row.at("So");
    const Mobility m = MobilityMap(row.at("B_over_D")).at(std::abs(eps), eps < 0.0 ? kPi : 0.0);
    INFO("eps " << eps << ", B/D " << row.at("B_over_D"));
    CHECK(1.0 / m.along == Approx(so).epsilon(0.01).margin(5e-5));
    ++rows;
  }
  CHECK(rows >= 80);
}

TEST_CASE("AJournalThatStandsStillIsTheSteadyBearing", "[mobility]") {
  // Raimondi and Boyd's film ruptures as this one, but begins at the widest gap; this one begins
  // where its pressure has no slope, a little before: it carries more, and turns the load the more
  // the wider it is and the lighter it is loaded.
  for (const double b : {0.1, 0.25, 0.5, 1.0, 2.0}) {
    const MobilityMap map(b);
    const BearingCurve conserving(b);
    for (const double eps : {0.2, 0.5, 0.8, 0.95}) {
      const Steady s = steady(map, eps);
      const BearingNumbers n = conserving.at(eps);
      INFO("B/D " << b << ", eps " << eps << ": " << s.so << " against " << n.so << ", "
                  << s.attitude / kDegree << " against " << n.attitude / kDegree);
      const double wide = b > 0.5 ? b * (1.0 - eps) : 0.0;
      CHECK(s.so > 0.99 * n.so);
      CHECK(s.so == Approx(n.so).epsilon(0.03 + 0.04 * wide));
      CHECK(s.attitude == Approx(n.attitude).margin((2.0 + 6.0 * wide) * kDegree));
    }
  }
}

TEST_CASE("MobilityMirrorsAndHasNoSeam", "[mobility]") {
  const MobilityMap map(0.5);
  for (const double eps : {0.0, 0.3, 0.9, 0.9995}) {
    for (const double alpha : {0.3, 1.5, 2.9, kPi}) {
      const Mobility a = map.at(eps, alpha), b = map.at(eps, -alpha),
                     c = map.at(eps, alpha + 2 * kPi);
      CHECK(a.along == Approx(b.along));
      CHECK(a.across == Approx(-b.across).margin(1e-12));
      CHECK(a.along == Approx(c.along));
      CHECK(a.along > 0.0);
    }
  }
  // Continued beyond the table as the wide film: M ~ (1 - eps)^(3/2) along the line of centres.
  const double near = map.at(1.0 - 1e-6, 0.0).along, nearer = map.at(1.0 - 1e-8, 0.0).along;
  CHECK(near / nearer == Approx(1000.0).epsilon(0.02));
}

}  // namespace shellback::fidelity
