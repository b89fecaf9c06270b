/// A soft layer on a steel ring under pressure patches and under heat, by the operators and on the
/// mesh that the solver uses. What validation/calculix/ring.hpp gives to a finite-element program
/// stands here in harmonics.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/constants.hpp"
#include "proof/evaluators/evaluators.hpp"
#include "solid/revolution_elasticity.hpp"

namespace shellback::proof {
namespace {

using namespace solid;

constexpr double kBore = 23.9e-3;      ///< radius [m]
constexpr double kOuter = 47.8e-3;     ///< radius of the outer surface [m]
constexpr double kShell = 2e-3;        ///< thickness of the steel shell [m]
constexpr double kWidth = 17.2e-3;     ///< [m]
constexpr double kPatchEnd = 5.16e-3;  ///< half length of the patches [m]
constexpr double kPressure = 10e6;     ///< largest of the patch [Pa]
constexpr double kHeating = 50.0;      ///< [K]
constexpr int kResolved = 48;          ///< harmonics for which the solver makes its mesh

/// cos^8(2 phi) = sum of share cos(n phi) [textbook].
struct PatchHarmonic {
  int n;
  double share;
};
constexpr PatchHarmonic kPatch[] = {
    {0, 35.0 / 128}, {4, 56.0 / 128}, {8, 28.0 / 128}, {12, 8.0 / 128}, {16, 1.0 / 128}};

/// Thickness [m] and Poisson's ratio of the layer, film cells over the full width.
using Body = std::tuple<double, double, int>;

/// Gap opening by harmonic on the axial film cells [m].
using Harmonic = std::pair<int, Eigen::VectorXd>;
using Opening = std::vector<Harmonic>;

struct Openings {
  std::vector<double> z;  ///< of the cells [m]
  std::map<std::string, Opening> by_load;
};

double uneven_heat(double r, double z) {
  const double depth = (r - kBore) / (kOuter - kBore), along = 2.0 * z / kWidth;
  return 0.5 * kHeating * (1.0 - 0.5 * depth) * (1.0 - 0.5 * along * along);
}

Opening pressed(const FilmGrid& grid, const ElasticOperators& held) {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.nz);
  for (int j = 0; j < grid.nz; ++j) p(j) = grid.z[j] < kPatchEnd ? kPressure : 0.0;
  Opening opening;
  for (std::size_t k = 0; k < std::size(kPatch); ++k) {
    opening.emplace_back(kPatch[k].n, kPatch[k].share * held.compliance[k] * p);
  }
  return opening;
}

void add_heated(const RevolutionMesh& mesh, const ElasticOperators& operators,
                const std::string& outside, Openings& openings) {
  Eigen::VectorXd uneven(mesh.nodes());
  for (int m = 0; m < mesh.nodes(); ++m) uneven(m) = uneven_heat(mesh.r[m], mesh.z[m]);
  openings.by_load["uniform heat, " + outside] = {{0, kHeating * uniform_growth(operators)}};
  openings.by_load["uneven heat, " + outside] = {{0, operators.growth[0] * uneven},
                                                 {1, operators.growth[1] * uneven}};
}

Openings openings_of(const Body& body) {
  const auto [thickness, nu, cells] = body;
  const Material steel{"", 1.0, 1000.0, 1000.0, 210e9, 0.3, 11e-6};
  const Material layer{"", 1.0, 1000.0, 1000.0, 2e9, nu, 60e-6};
  constexpr int kCircumferential = 48;  // cells; of no effect on the harmonics
  const FilmGrid grid = make_grid(kBore, kWidth, kCircumferential, cells, true);
  const RadialRows rows =
      rows_outwards(kBore, {thickness, kShell, kOuter - kBore - kShell - thickness},
                    surface_row(kBore, kResolved));
  const RevolutionMesh mesh =
      make_revolution_mesh(rows.face, rows.layer, axial_elements(grid), true);
  ElasticOptions options;
  const auto solve = [&](Support support, bool growth, std::vector<int> only) {
    options.support = support;
    options.growth = growth;
    options.only = std::move(only);
    return shell_elasticity(mesh, grid, {layer, steel, steel}, options);
  };
  Openings openings{grid.z, {}};
  std::vector<int> of_patch;
  for (const PatchHarmonic& h : kPatch) of_patch.push_back(h.n);
  openings.by_load["pressure"] = pressed(grid, solve(Support::held, false, of_patch));
  add_heated(mesh, solve(Support::held, true, {0, 1}), "free outside", openings);
  add_heated(mesh, solve(Support::clamped, true, {0, 1}), "clamped outside", openings);
  return openings;
}

Body body_of(double thickness_um, double nu, double cells) {
  return {1e-6 * thickness_um, nu, static_cast<int>(std::lround(cells))};
}

}  // namespace

std::any prepare_layered_ring(const Entry& entry) {
  std::map<Body, Openings> all;
  for (std::size_t line = 0; line < entry.table->lines().size(); ++line) {
    const auto number = [&](const char* column) {
      return entry.table->number(line, column).value();
    };
    const Body body = body_of(number("thickness_um"), number("nu"), number("cells"));
    if (!all.contains(body)) all.emplace(body, openings_of(body));
  }
  return all;
}

Values layered_ring_values(const Question& q) {
  const auto& all = std::any_cast<const std::map<Body, Openings>&>(q.prepared);
  const Openings& found =
      all.at(body_of(q.number("thickness_um"), q.number("nu"), q.number("cells")));
  const double phi = q.number("phi_deg") * kPi / 180.0, z = 1e-3 * q.number("z_mm");
  const auto cell = std::min_element(found.z.begin(), found.z.end(), [&](double a, double b) {
                      return std::abs(a - z) < std::abs(b - z);
                    }) - found.z.begin();
  Values values;
  for (const auto& [load, opening] : found.by_load) {
    double& sum = values.value[load];
    for (const auto& [n, u] : opening) sum += u(cell) * std::cos(n * phi);
  }
  return values;
}

}  // namespace shellback::proof
