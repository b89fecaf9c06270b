/// A soft layer on a steel ring under pressure patches and under heat, by the operators and on the
/// mesh that the solver uses. What validation/calculix/ring.hpp gives to a finite-element program
/// stands here in harmonics.
#include <algorithm>
#include <cmath>
#include <compare>

#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "solid/revolution_elasticity.hpp"
#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {
namespace {

using namespace solid;

constexpr double kRadius = 23.9e-3;    ///< radius [m]
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

/// What the rows of one ring share.
struct Body {
  double thickness;  ///< of the layer [m]
  double nu;         ///< Poisson's ratio of the layer [-]
  int cells;         ///< over the full width, whose means are compared
  int film_cells;    ///< over the full width, of the film that is solved: a multiple of `cells`
  [[nodiscard]] auto operator<=>(const Body&) const = default;
};

/// Gap opening by harmonic on the axial cells [m].
using Opening = std::vector<std::pair<int, Eigen::VectorXd>>;

struct Openings {
  std::vector<double> z;  ///< of the cells whose means are compared [m]
  std::map<std::string, Opening> by_load;
};

double uneven_heat(double r, double z) {
  const double depth = (r - kRadius) / (kOuter - kRadius), along = 2.0 * z / kWidth;
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
  openings.by_load["uniform heat, " + outside] = {{0, kHeating * uniform_expansion(operators)}};
  openings.by_load["uneven heat, " + outside] = {{0, operators.thermal_deformation[0] * uneven},
                                                 {1, operators.thermal_deformation[1] * uneven}};
}

/// Film and section of a body as the solver takes them.
struct Section {
  FilmGrid grid;
  RevolutionMesh mesh;
  std::vector<Material> layers;
};

FilmGrid film(int cells) {
  constexpr int kCircumferential = 48;  // cells; of no effect on the harmonics
  return make_grid(kRadius, kWidth, kCircumferential, cells, true);
}

Section section_of(const Body& body) {
  const FilmGrid grid = film(body.film_cells);
  const double rest = kOuter - kRadius - kShell - body.thickness;
  const RadialRows rows =
      rows_outwards(kRadius, {body.thickness, kShell, rest}, surface_row(kRadius, kResolved));
  const Material steel{"", 1.0, 1000.0, 1000.0, 210e9, 0.3, 11e-6};
  const Material layer{"", 1.0, 1000.0, 1000.0, 2e9, body.nu, 60e-6};
  return {grid,
          make_revolution_mesh(rows.face, rows.layer, axial_elements(grid), true),
          {layer, steel, steel}};
}

ElasticOperators operators_of(const Section& s, Support support, bool thermal_deformation,
                              std::vector<int> only) {
  ElasticOptions options;
  options.support = support;
  options.thermal_deformation = thermal_deformation;
  options.only = std::move(only);
  return shell_elasticity(s.mesh, s.grid, s.layers, options);
}

Opening pressed_opening(const Section& s) {
  std::vector<int> n;
  for (const PatchHarmonic& h : kPatch) n.push_back(h.n);
  return pressed(s.grid, operators_of(s, Support::held, false, n));
}

/// Means over the cells of `coarse`, whose faces are faces of `fine` too.
Opening means(const FilmGrid& coarse, const FilmGrid& fine, const Opening& opening) {
  Opening out;
  for (const auto& [n, u] : opening) {
    out.emplace_back(n, Eigen::VectorXd::Zero(coarse.nz));
    for (int j = 0; j < coarse.nz; ++j) {
      for (int k = 0; k < fine.nz; ++k) {
        const double middle = 0.5 * (fine.z_face[k] + fine.z_face[k + 1]);
        if (middle < coarse.z_face[j] || middle > coarse.z_face[j + 1]) continue;
        out.back().second(j) += u(k) * fine.dz[k] / coarse.dz[j];
      }
    }
  }
  return out;
}

Openings openings_of(const Body& body) {
  const Section s = section_of(body);
  Openings openings;
  openings.by_load["pressure"] = pressed_opening(s);
  add_heated(s.mesh, operators_of(s, Support::held, true, {0, 1}), "free outside", openings);
  add_heated(s.mesh, operators_of(s, Support::clamped, true, {0, 1}), "clamped outside", openings);
  const FilmGrid compared = film(body.cells);
  openings.z = compared.z;
  for (auto& [load, opening] : openings.by_load) opening = means(compared, s.grid, opening);
  return openings;
}

Body body_of(const RowNumbers& row) {
  const auto count = [&](const char* column) {
    return static_cast<int>(std::lround(row.at(column)));
  };
  return {1e-6 * row.at("thickness_um"), row.at("nu"), count("cells"), count("film_cells")};
}

}  // namespace

std::any prepare_layered_ring(const Entry& entry) {
  std::map<Body, Openings> all;
  for (std::size_t line = 0; line < entry.table->lines().size(); ++line) {
    const Body body = body_of(entry.table->numbers(line));
    if (!all.contains(body)) all.emplace(body, openings_of(body));
  }
  return all;
}

Values layered_ring_values(const Question& q) {
  const auto& all = std::any_cast<const std::map<Body, Openings>&>(q.prepared);
  const Openings& found = all.at(body_of(q.point));
  const double phi = q.number("phi_deg") * kPi / 180.0, z = 1e-3 * q.number("z_mm");
  const auto cell =
      std::min_element(found.z.begin(), found.z.end(),
                       [&](double a, double b) { return std::abs(a - z) < std::abs(b - z); }) -
      found.z.begin();
  Values values;
  for (const auto& [load, opening] : found.by_load) {
    double& sum = values.value[load];
    for (const auto& [n, u] : opening) sum += u(cell) * std::cos(n * phi);
  }
  return values;
}

}  // namespace shellback::validation
