/// The skin of a wall: closed forms of the half space and of a coating, heat balance.
#include "thermal/wall_skin.hpp"

#include <catch2/catch.hpp>
#include <complex>

#include "core/constants.hpp"

using namespace shellback;
using namespace shellback::thermal;

namespace {

const SkinLayer kSteel{0.01, 50.0, 7850.0 * 460.0};
const SkinLayer kPolymer{20e-6, 0.25, 1300.0 * 1100.0};
constexpr double kPeriod = 0.06;  ///< four strokes at 2000 rpm [s]

/// Amplitude of the surface's temperature per heat that swings n times in the period, found in
/// `steps` steps a swing by the implicit midpoint of two half steps' slopes (Crank-Nicolson).
std::complex<double> swing(const WallSkin& skin, int n, int steps) {
  const double dt = kPeriod / n / steps;
  const double omega = 2.0 * kPi * n / kPeriod;
  const SkinStep step = skin.over(0.5 * dt);
  std::vector<double> T(skin.nodes(), 0.0);
  std::complex<double> sum = 0.0;
  const int settled = 20 * n;
  for (int k = 0; k < (settled + 1) * steps; ++k) {
    const double q = std::cos(omega * (k + 0.5) * dt);
    std::vector<double> middle = T;
    skin.relax(step, middle.data());
    for (std::size_t i = 0; i < T.size(); ++i) {
      T[i] = 2.0 * (middle[i] + step.by_flux[i] * q) - T[i];
    }
    if (k < settled * steps) continue;
    sum += 2.0 / steps * T[0] * std::polar(1.0, -omega * (k + 1) * dt);
  }
  return sum;
}

/// Of layers in series on the last one, which has no end: a chain of lines, textbook.
std::complex<double> exact_swing(const std::vector<SkinLayer>& layers, double omega) {
  const std::complex<double> i_omega(0.0, omega);
  const auto impedance = [&](const SkinLayer& l) {
    return 1.0 / std::sqrt(i_omega * l.conductivity * l.capacity);
  };
  std::complex<double> below = impedance(layers.back());
  for (std::size_t k = layers.size() - 1; k-- > 0;) {
    const SkinLayer& l = layers[k];
    const std::complex<double> t =
        std::tanh(std::sqrt(i_omega * l.capacity / l.conductivity) * l.thickness);
    const std::complex<double> Z = impedance(l);
    below = Z * (below + Z * t) / (Z + below * t);
  }
  return below;
}

}  // namespace

TEST_CASE("SwingsOfAHalfSpaceAreThoseOfTheClosedForm", "[wall_skin]") {
  const WallSkin skin({kSteel}, kPeriod, kPeriod / 720.0);
  CHECK(skin.nodes() <= 10);
  for (const int n : {1, 2, 5, 20}) {
    const double omega = 2.0 * kPi * n / kPeriod;
    const std::complex<double> exact =
        1.0 / std::sqrt(std::complex<double>(0.0, omega * kSteel.conductivity * kSteel.capacity));
    const std::complex<double> found = swing(skin, n, 400);
    INFO(n << ": " << found << " for " << exact);
    // ten linear elements; exp(-6) of the fundamental comes back from the depth
    CHECK(std::abs(found - exact) < 0.02 * std::abs(exact));
  }
}

TEST_CASE("ACoatingOfPolymerSwingsAsTheClosedFormOfTwoLayers", "[wall_skin]") {
  const WallSkin skin({kPolymer, kSteel}, kPeriod, kPeriod / 720.0);
  CHECK(skin.nodes() <= 12);
  for (const int n : {1, 2, 5, 20}) {
    const std::complex<double> i_omega(0.0, 2.0 * kPi * n / kPeriod);
    const auto impedance = [&](const SkinLayer& l) {
      return 1.0 / std::sqrt(i_omega * l.conductivity * l.capacity);
    };
    const std::complex<double> x =
        std::sqrt(i_omega * kPolymer.capacity / kPolymer.conductivity) * kPolymer.thickness;
    const std::complex<double> Z = impedance(kPolymer), below = impedance(kSteel);
    const std::complex<double> exact = Z * (below + Z * std::tanh(x)) /
                                       (Z + below * std::tanh(x));  // a line with its end, textbook
    const std::complex<double> found = swing(skin, n, 400);
    INFO(n << ": " << found << " for " << exact);
    CHECK(std::abs(found - exact) < 0.02 * std::abs(exact));
  }
}

TEST_CASE("ThinLayersBehindOneAnotherKeepTheirResistance", "[wall_skin]") {
  // Their ends lie nearer to one another than nodes do: one took the other's node, and the layer
  // between them was gone (0.53 of the swing with a joint, 1.17 with the nickel).
  const SkinLayer nickel{2e-6, 60.0, 8900.0 * 440.0};
  const SkinLayer bronze{0.01, 60.0, 8700.0 * 380.0};
  SkinLayer polymer = kPolymer;
  polymer.thickness = 10e-6;
  SkinLayer lining = kSteel, back = kSteel;
  lining.thickness = 60e-6;
  std::vector<std::vector<SkinLayer>> stacks{{polymer, nickel, bronze}};
  for (const double joint : {3e3, 1e4, 3e4, 1e5}) {  // [W/(m2 K)]
    const SkinLayer gap{2e-6, joint * 2e-6, kSteel.capacity};
    stacks.push_back({lining, gap, back});
  }
  for (const auto& layers : stacks) {
    const WallSkin skin(layers, kPeriod, kPeriod / 720.0);
    for (const int n : {1, 5, 20}) {
      const std::complex<double> exact = exact_swing(layers, 2.0 * kPi * n / kPeriod);
      const std::complex<double> found = swing(skin, n, 400);
      INFO(layers[1].conductivity << ", " << n << ": " << found << " for " << exact);
      CHECK(std::abs(found - exact) < 0.03 * std::abs(exact));  // ten linear elements
    }
  }
}

TEST_CASE("AShaftWarmsInsideAndABoreSpreadsItsHeat", "[wall_skin]") {
  // Solid cylinder that takes q at its surface from t = 0, mean temperature 2 q t/(rho c R)
  // exactly; surface above it by q R/(4 k) once a t > R^2/2, textbook.
  const SkinLayer shaft = kSteel;
  const double R = shaft.thickness, a = shaft.conductivity / shaft.capacity, q = 1e5;
  const double end = R * R / a;
  const int steps = 400;
  {
    const WallSkin skin({shaft}, 4.0 * end, end / steps, 0.0, -1.0 / R);
    std::vector<double> T(skin.nodes(), 0.0);
    const SkinStep step = skin.over(end / steps);
    for (int k = 0; k < steps; ++k) {
      skin.relax(step, T.data());
      for (std::size_t i = 0; i < T.size(); ++i) T[i] += step.by_flux[i] * q;
    }
    CHECK(skin.heat(T.data()) == Approx(q * end).epsilon(1e-9));
    const double mean = 2.0 * q * end / (shaft.capacity * R);
    CHECK(T[0] == Approx(mean + q * R / (4.0 * shaft.conductivity)).epsilon(0.005));  // elements
  }
  {  // A tube in the end: q R/k ln(1 + d/R), and h (1 + d/R) at its back.
    const double h = 2e3;
    const WallSkin skin({shaft}, 4.0 * end, end / steps, h, 1.0 / R);
    const double exact = R / shaft.conductivity * std::log(2.0) + 1.0 / (2.0 * h);
    CHECK(skin.over(1e9).impedance() == Approx(exact).epsilon(0.005));
  }
}

TEST_CASE("HeatThatEntersTheSkinIsHeldOrGoesOn", "[wall_skin]") {
  const WallSkin skin({kPolymer, kSteel}, kPeriod, kPeriod / 720.0);
  std::vector<double> T(skin.nodes());
  for (int k = 0; k < skin.nodes(); ++k) T[k] = std::sin(1.0 + k);
  const double before = skin.heat(T.data());
  const double last = skin.depths()[skin.nodes()] - skin.depths()[skin.nodes() - 1];
  const SkinStep step = skin.over(1e-4);
  const double q = 3e5;  // [W/m2]
  skin.relax(step, T.data());
  for (int k = 0; k < skin.nodes(); ++k) T[k] += step.by_flux[k] * q;
  const double on = kSteel.conductivity / last * T.back();  // into the body, held at 0
  const double stored = (skin.heat(T.data()) - before) / step.dt;
  CHECK(q - on - stored == Approx(0.0).margin(1e-9 * q));
  CHECK(step.impedance() == step.by_flux.front());
}

TEST_CASE("ASkinEndsWhereItsLayersEnd", "[wall_skin]") {
  const SkinLayer thin{50e-6, 180.0, 3110.0 * 760.0};
  const WallSkin skin({thin}, kPeriod, kPeriod / 720.0);
  CHECK(skin.depths().back() == Approx(50e-6));
  const SkinStep endless = skin.over(1e9);
  CHECK(endless.impedance() == Approx(50e-6 / 180.0));  // nothing but conduction
}

TEST_CASE("LayersThatEndBeforeTheSkinGiveTheirHeatToTheirBack", "[wall_skin]") {
  // A plate of length L with q at y = 0 and h T at its back, textbook:
  // Z = (m cosh gL + h sinh gL)/(m (m sinh gL + h cosh gL)), g = sqrt(i omega/a), m = k g.
  SkinLayer thin = kSteel;
  thin.thickness = 0.3e-3;  // the period reaches 0.5 mm
  for (const double h : {0.0, 80.0, 2e4, 1e6}) {
    const WallSkin skin({thin}, kPeriod, kPeriod / 720.0, h);
    CHECK(skin.depths().back() == Approx(thin.thickness));
    for (const int n : {1, 2, 5}) {
      const std::complex<double> i_omega(0.0, 2.0 * kPi * n / kPeriod);
      const std::complex<double> gamma = std::sqrt(i_omega * thin.capacity / thin.conductivity);
      const std::complex<double> m = thin.conductivity * gamma, x = gamma * thin.thickness;
      const std::complex<double> exact =
          (m * std::cosh(x) + h * std::sinh(x)) / (m * (m * std::sinh(x) + h * std::cosh(x)));
      // A plate that hardly gives heat off keeps what it had at first: the swing about that.
      const std::complex<double> found = swing(skin, n, 400);
      INFO(h << " W/(m2 K), " << n << ": " << found << " for " << exact);
      CHECK(std::abs(found - exact) < 0.02 * std::abs(exact));
    }
  }
  // Held, as a back of given temperature is: nothing but conduction in the end.
  const double endless = WallSkin({thin}, kPeriod, kPeriod / 720.0, 80.0).over(1e9).impedance();
  CHECK(endless == Approx(thin.thickness / thin.conductivity + 1.0 / 80.0));
}
