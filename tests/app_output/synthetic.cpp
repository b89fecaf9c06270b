#include "synthetic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "core/make_grid.hpp"

namespace shellback::test {
namespace {

using namespace bearing;

constexpr double kRadius = 23.9e-3;     // [m]
constexpr double kWidth = 17.2e-3;      // [m]
constexpr double kClearance = 23.9e-6;  // [m]
constexpr double kHot = 373.15;         // supplied oil [K]

/// What sets one tier's made-up film apart.
struct Film {
  double eps;    // eccentricity ratio [-]
  double gamma;  // direction of the smallest gap [rad]
  double eta;    // viscosity [Pa s]
  double rise;   // largest temperature rise [K]; 0: isothermal
  double bend;   // elastic widening where the pressure is largest [m]
};

double wrapped(double angle) { return angle - 2.0 * kPi * std::floor(angle / (2.0 * kPi)); }

bool in_hole(double phi, double z) {
  const double x = kRadius * (phi - 0.5 * kPi);
  return x * x + z * z < 2.5e-3 * 2.5e-3;
}

/// Ocvirk's short bearing: p = 3 eta U/(R c^2) (B^2/4 - z^2) eps sin(psi)/(1 + eps cos(psi))^3,
/// psi from the largest gap (textbook).
void fill_film(Fields& f, const Film& film) {
  const double U = 314.16 * kRadius;
  const auto& g = f.grid;
  for (int i = 0; i < g.nt; ++i) {
    const double psi = wrapped(g.phi[i] - film.gamma - kPi);
    const double H = 1.0 + film.eps * std::cos(psi);
    for (int j = 0; j < g.nz; ++j) {
      const double z = g.z[j];
      const double axial = 1.0 - 4.0 * z * z / (kWidth * kWidth);
      const double p = psi < kPi
                           ? 0.75 * film.eta * U / (kRadius * kClearance * kClearance) * kWidth *
                                 kWidth * axial * film.eps * std::sin(psi) / (H * H * H)
                           : 0.0;
      const bool hole = in_hole(g.phi[i], z);
      const double bend = film.bend * std::max(0.0, std::cos(g.phi[i] - film.gamma)) * axial;
      const double h = kClearance * H + bend;
      f.p.push_back(std::max(p, hole ? 2e5 : 0.0));
      f.p_asperity.push_back(h < 2e-6 ? 1e6 : 0.0);
      f.theta.push_back(psi < kPi || hole ? 1.0 : (1.0 - film.eps) / H);
      f.h.push_back(h + (hole ? 1e-3 : 0.0));
      f.supplied.push_back(hole ? 1 : 0);
      f.tau_journal.push_back(film.eta * U / h);
      f.tau_shell.push_back(0.98 * film.eta * U / h);
      f.elastic.push_back(bend);
      f.thermal_deformation.push_back(film.bend > 0.0 ? 1.2e-6 : 0.0);
    }
  }
}

/// Heat gathered from the supply on, as the integral of 1/h, scaled to `rise`, cooling after.
std::vector<double> heat_profile(const Fields& f, const Film& film) {
  const int nt = f.grid.nt;
  std::vector<double> heat(nt, 0.0);
  double sum = 0.0;
  double largest = 0.0;
  const int start = nt / 4;
  for (int k = 0; k < nt; ++k) {
    const int i = (start + k) % nt;
    const double psi = wrapped(f.grid.phi[i] - film.gamma - kPi);
    sum = psi < kPi + 0.3 ? sum + 1.0 / (1.0 + film.eps * std::cos(psi)) : sum * 0.985;
    heat[i] = sum;
    largest = std::max(largest, sum);
  }
  for (auto& value : heat) value *= film.rise / largest;
  return heat;
}

void fill_temperature(Fields& f, const Film& film) {
  const auto heat = heat_profile(f, film);
  f.s = {0.0, 0.172673, 0.5, 0.827327, 1.0};
  f.r = {kRadius, 24.05e-3, 24.2e-3, 25.05e-3, 25.9e-3, 30e-3, 35e-3, 40e-3};
  double mean = 0.0;
  for (const double value : heat) mean += value / f.grid.nt;
  for (int i = 0; i < f.grid.nt; ++i) {
    const double shell = kHot - 4.0 + 0.35 * mean + 0.5 * heat[i];
    for (int j = 0; j < f.grid.nz; ++j) {
      const double rim = 1.0 - 0.12 * std::pow(2.0 * f.grid.z[j] / kWidth, 2);
      const double T = kHot + rim * heat[i];
      f.T_mean.push_back(T);
      for (const double s : f.s) {
        const double bulge = 0.3 * heat[i] * std::sin(kPi * s);
        f.T.push_back((1.0 - s) * shell + s * (kHot + 0.8 * mean) + bulge);
      }
      f.T_shell_surface.push_back(shell);
      f.T_shell_back.push_back(kHot - 5.0 + 0.45 * mean + 0.3 * heat[i]);
    }
    for (const double r : f.r) {
      const double depth = (r - kRadius) / (f.r.back() - kRadius);
      f.T_solid.push_back(shell - depth * 9.0 - 0.4 * depth * heat[i]);
    }
  }
  f.T_shaft.assign(f.grid.nz, kHot + 0.8 * mean);
}

Result made_result(Tier tier, const Film& film, double torque) {
  Result r;
  r.tier = tier;
  r.title = synthetic_case().title;
  r.grid = {200, 25};
  r.fields.grid = make_grid(kRadius, kWidth, 200, 25, false);
  fill_film(r.fields, film);
  const auto& f = r.fields;
  r.quantities = {{"friction_torque", torque, "N m"},
                  {"friction_torque_asperity", 0.012, "N m"},
                  {"power_loss", torque * 314.16, "W"},
                  {"eccentricity_ratio", film.eps, "-"},
                  {"attitude_angle", film.gamma * 180.0 / kPi - 270.0, "deg"},
                  {"h_min", *std::min_element(f.h.begin(), f.h.end()), "m"},
                  {"p_max", *std::max_element(f.p.begin(), f.p.end()), "Pa"},
                  {"asperity_load_share", 0.004, "-"},
                  {"load_x", 0.0, "N"},
                  {"load_y", 8000.0, "N"},
                  {"side_flow", 3.1e-6, "m3/s"},
                  {"supply_flow", 3.1e-6, "m3/s"}};
  r.audit = {2.1e-13, 3.4e-9, 1.2e-8, 4.0e-7};
  if (film.rise > 0.0) {
    fill_temperature(r.fields, film);
    r.quantities.push_back({"T_film_max", kHot + film.rise, "K"});
    r.quantities.push_back({"T_film_mean", kHot + 0.5 * film.rise, "K"});
    r.quantities.push_back({"T_shell_max", kHot - 4.0 + 0.7 * film.rise, "K"});
    r.quantities.push_back({"T_shell_back", kHot - 1.0, "K"});
    r.quantities.push_back({"T_shaft", kHot + 0.4 * film.rise, "K"});
  } else {
    r.audit.energy = std::numeric_limits<double>::quiet_NaN();
    r.quantities.push_back({"T_equivalent", 371.15, "K"});
    r.fields.elastic.clear();
    r.fields.thermal_deformation.clear();
  }
  r.effects = {{EffectKind::elastic_deformation, tier == Tier::tehd, 0.21},
               {EffectKind::shear_thinning, true, 0.33}};
  r.assumptions = {"specific heat of 0W20 assumed, 2083 J/(kg K)", "flooded edges"};
  r.cost = {0.062, 0.011, 64, 41, film.rise > 0.0 ? 14 : 1, 0.0};
  r.history = {{"film", 1e-2, 1.2 * torque, 3e-6}, {"heat", 1e-6, torque, 2.4e-6}};
  return r;
}

}  // namespace

Case synthetic_case() {
  Case c;
  c.title = "KS rig, test bearing <4 & 8 kN>";
  c.path = "cases/ks-rig.toml";
  c.verbatim = "title = \"KS rig, test bearing <4 & 8 kN>\"\n[bearing]\ndiameter = \"47.8 mm\"\n";
  c.bearing.radius = kRadius;
  c.bearing.width = kWidth;
  c.bearing.radial_clearance = kClearance;
  Supply hole;
  hole.angle = 0.5 * kPi;
  hole.diameter = 5e-3;
  hole.pressure = 2e5;
  hole.temperature = kHot;
  c.supplies = {hole};
  c.operation.omega = 314.16;
  c.operation.position = LoadGiven{8000.0, 1.5 * kPi};
  c.oil.name = "0W20";
  Shell shell;
  shell.layers = {{{"AlSn20", 0, 0, 0, 0, 0, 0}, 0.3e-3}, {{"steel", 0, 0, 0, 0, 0, 0}, 1.7e-3}};
  c.shell = shell;
  c.measured.shell_back_temperature = 371.15;
  c.measured.friction_torque = 1.00;
  return c;
}

Comparison synthetic_comparison() {
  Comparison comparison;
  const double line = 1.5 * kPi;
  comparison.results = {made_result(Tier::isothermal, {0.860, line + 0.44, 0.0078, 0.0, 0.0}, 1.16),
                        made_result(Tier::thd, {0.880, line + 0.47, 0.0066, 24.0, 0.0}, 1.01),
                        made_result(Tier::tehd, {0.885, line + 0.49, 0.0064, 21.0, 0.9e-6}, 0.968)};
  comparison.results.back().warnings = {"pressure above the oil's fitted range in 3 cells"};
  comparison.results.back().limiters = {{Limiter::rejected_steps, 2}};
  comparison.split = {1.16,
                      0.968,
                      {{"viscosity level", -0.131},
                       {"viscosity variation", -0.047},
                       {"clearance", 0.024},
                       {"elasticity", -0.051},
                       {"asperity share", 0.013}}};
  comparison.calibration.T = 379.4;
  return comparison;
}

Result synthetic_result() { return synthetic_comparison().results.back(); }

Result not_converged(Result result) {
  result.verdict = {
      Status::iteration_limit, ending::FilmUnsettled{80, 3.2e-3, 1.0, 0.0, 1e-6}, {5.27, 0.3e-3}};
  return result;
}

}  // namespace shellback::test
