/// Compliance of a ring in plane strain by the harmonics that the solver uses; a thin ring on a
/// rigid base is a bonded layer.
#include <algorithm>
#include <cmath>

#include "core/make_grid.hpp"
#include "solid/revolution_elasticity.hpp"
#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {
namespace {

using namespace solid;

/// Radial displacement of the bore under pressure cos(n phi) per unit pressure [m/Pa], n = 0 to
/// `highest`, uniform along the axis.
std::vector<double> compliances(double radius, double thickness, double first_row,
                                const Material& material, Support support, int highest) {
  constexpr int kCircumferential = 48;  // cells; of no effect on the harmonics
  constexpr int kAxial = 3;             // cells over the full width; plane strain: any number does
  const FilmGrid grid = make_grid(radius, 0.5 * radius, kCircumferential, kAxial, true);
  const RadialRows rows = rows_outwards(radius, {thickness}, first_row);
  const RevolutionMesh mesh =
      make_revolution_mesh(rows.face, rows.layer, axial_elements(grid), true);
  const auto operators =
      shell_elasticity(mesh, grid, {material}, {highest, support, AxialEnds::plane_strain, false});
  std::vector<double> c;
  for (const auto& matrix : operators.compliance) c.push_back(matrix.row(0).sum());
  return c;
}

Material elastic(double youngs_modulus, double poisson_ratio) {
  return {"", 1.0, 1000.0, 1000.0, youngs_modulus, poisson_ratio, 0.0};
}

// The bonded layer: 1 mm thick on a bore of 100 mm, so that k t = n t/R; curvature costs t/R = 1 %.
constexpr double kThickness = 1e-3;  // [m]
constexpr double kBore = 0.1;        // [m]
constexpr double kModulus = 1e9;     // [Pa]; of no effect on the ratio
constexpr int kHighest = 300;        // k t = 3
/// Poisson's ratios of the table's columns.
constexpr double kPoisson[] = {0.30, 0.33, 0.40, 0.45, 0.49};

/// t (1 + nu)(1 - 2 nu)/(E (1 - nu)): deflection of a layer under uniform pressure [m/Pa].
double winkler(double nu) {
  return kThickness * (1.0 + nu) * (1.0 - 2.0 * nu) / (kModulus * (1.0 - nu));
}

}  // namespace

Values elastic_ring_values(const Question& q) {
  constexpr double kRadius = 0.024;  // [m], as the table
  constexpr double kSteel = 210e9;   // [Pa], as the table
  constexpr double kNu = 0.3;
  constexpr int kResolved = 48;  // harmonics for which the solver makes its mesh
  const int n = static_cast<int>(std::lround(q.number("n")));
  Values values;
  for (const Support support : {Support::free, Support::held}) {
    const auto c = compliances(kRadius, 1e-3 * q.number("thickness_mm"),
                               surface_row(kRadius, kResolved), elastic(kSteel, kNu), support, n);
    values.value[support == Support::free ? "compliance_free" : "compliance_held"] = c.back();
  }
  return values;
}

std::any prepare_bonded_layer(const Entry& /*entry*/) {
  std::vector<std::vector<double>> ratios;
  for (const double nu : kPoisson) {
    std::vector<double> c = compliances(kBore, kThickness, 0.25 * kThickness, elastic(kModulus, nu),
                                        Support::held, kHighest);
    for (double& value : c) value /= winkler(nu);
    ratios.push_back(std::move(c));
  }
  return ratios;
}

Values bonded_layer_values(const Question& q) {
  const auto& ratios = std::any_cast<const std::vector<std::vector<double>>&>(q.prepared);
  const double n = q.number("kt") * kBore / kThickness;
  Values values;
  if (n > kHighest) {
    values.failure = "more harmonics than were computed";
    return values;
  }
  // The table's k t are whole harmonics; points of the curve between them are interpolated.
  const int below = std::min(static_cast<int>(n + 1e-9), kHighest - 1);
  const char* names[] = {"ratio_030", "ratio_033", "ratio_040", "ratio_045", "ratio_049"};
  for (std::size_t k = 0; k < std::size(kPoisson); ++k) {
    const double u = n - below;
    values.value[names[k]] = (1.0 - u) * ratios[k][below] + u * ratios[k][below + 1];
  }
  return values;
}

}  // namespace shellback::validation
