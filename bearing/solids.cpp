#include "bearing/solids.hpp"

#include <algorithm>

#include "bearing/case_limits.hpp"
#include "core/contract.hpp"
#include "core/revolution_mesh.hpp"
#include "core/stopwatch.hpp"
#include "solid/revolution_elasticity.hpp"
#include "solid/shaft_bending.hpp"

namespace shellback::bearing {

using Layers = Solids::Layers;

/// A joint is a layer of the housing so thick, whose conductivity makes its conductance: a
/// thousandth of a shell's thickness, so that it carries no heat along and moves nothing [m].
constexpr double kJoint = 2e-6;

/// Poisson's ratio up to which a layer under load is pressed together; a layer beyond it is pushed
/// aside, its shear strain a parabola over its thickness and singular where it ends, and has so
/// many rows of elements [-].
constexpr double kCompressible = 0.4;
constexpr int kRowsIncompressible = 8;
/// And so many elements of an axial cell that is longer than it is thick: one alone locks beside
/// the edges, where such a layer is pushed out (second cell off by a sixth of its opening).
constexpr int kElementsIncompressible = 2;

Layers wall_layers(const Case& c) {
  if (!c.shell || c.shell->layers.empty()) {
    throw InputError(
        "the shell's layers are needed for heat conduction and deformation; give "
        "[shell] layers, or use tier isothermal or lumped");
  }
  Layers out;
  double radius = c.bearing.radius;
  for (const ShellLayer& layer : c.shell->layers) {
    out.material.push_back(layer.material);
    out.thickness.push_back(layer.thickness);
    radius += layer.thickness;
  }
  out.last_of_shell = static_cast<int>(out.material.size()) - 1;
  if (!c.shell->housing) return out;
  const Housing& housing = *c.shell->housing;
  if (housing.joint_conductance > 0.0) {
    out.material.push_back(housing.material);
    out.material.back().conductivity = housing.joint_conductance * kJoint;
    out.thickness.push_back(kJoint);
    radius += kJoint;
  }
  out.material.push_back(housing.material);
  out.thickness.push_back(housing.outer_radius - radius);
  return out;
}

namespace {

RevolutionMesh shell_mesh(const Case& c, const Layers& layers, const FilmGrid& grid,
                          int harmonics) {
  std::vector<int> least;
  int per_cell = 1;
  const double longest = *std::max_element(grid.dz.begin(), grid.dz.end());
  for (std::size_t k = 0; k < layers.material.size(); ++k) {
    const bool flows = layers.material[k].poisson_ratio > kCompressible;
    least.push_back(flows ? kRowsIncompressible : 0);
    if (flows && layers.thickness[k] < longest) per_cell = kElementsIncompressible;
  }
  const RadialRows rows = rows_outwards(c.bearing.radius, layers.thickness,
                                        surface_row(c.bearing.radius, harmonics), least);
  return make_revolution_mesh(rows.face, rows.layer, axial_elements(grid, 0.0, per_cell),
                              grid.half);
}

solid::Support support_of(const Case& c) {
  if (!c.shell->housing) return solid::Support::held;
  switch (c.shell->housing->support) {
    case HousingSupport::free:
      return solid::Support::free;
    case HousingSupport::clamped:
      return solid::Support::clamped;
    case HousingSupport::held:
      break;
  }
  return solid::Support::held;
}

/// Length of shaft beyond the bearing that is elastic, each side [m].
double elastic_overhang(const Case& c) {
  const double R = c.bearing.radius;
  return c.shaft->elastic_overhang.value_or(
      std::clamp(c.shaft->overhang, R, kBearingLimits.elastic_overhang_most * R));
}

constexpr double kLocalPart = 0.55;  ///< of the film's largest local response; above 1/2 [-]

/// Mean over harmonics of the mean eigenvalue: what a pressure of no particular shape meets.
double mean_compliance(const HarmonicOperator& op) {
  double sum = 0.0;
  for (const auto& m : op) sum += m.trace() / static_cast<double>(m.rows());
  return sum / static_cast<double>(op.size());
}

/// What bends and is pressed: an elasto-plastic layer yields by a law of its own, and is as stiff
/// as what it lies on here.
std::vector<solid::Material> elastic_materials(const Case& c, const Layers& layers) {
  std::vector<solid::Material> materials = layers.material;
  if (!c.shell->layers.front().elasto_plastic) return materials;
  materials[0].youngs_modulus = materials.at(1).youngs_modulus;
  materials[0].poisson_ratio = materials[1].poisson_ratio;
  materials[0].expansion = materials[1].expansion;  // it is too soft to stretch what it lies on
  return materials;
}

}  // namespace

Solids::Solids(const Case& c, const FilmGrid& grid, SolidEffects effects)
    : grid_(grid),
      shell_(c.shell),
      shaft_(c.shaft),
      effects_(effects),
      harmonics_(grid, default_harmonics(grid.nt)),
      sample_(harmonics_.highest(), effects.every_harmonic) {
  const Stopwatch watch;
  reference_ = c.bearing.reference_temperature;
  if (!c.shaft) throw InputError("the shaft's data are needed; give [shaft] material");
  const int N = harmonics_.highest();
  const Layers layers = wall_layers(c);
  shell_mesh_ = shell_mesh(c, layers, grid_, N);
  const RevolutionMesh& mesh = shell_mesh_;
  if (effects.heat) build_heat(c, layers, mesh);
  if (effects.elastic || effects.thermal_deformation) {
    auto ops = solid::shell_elasticity(
        mesh, grid_, elastic_materials(c, layers),
        {N, support_of(c), solid::AxialEnds::free, effects.thermal_deformation,
         solid::Elimination::cheapest, sample_.computed()});
    if (effects.elastic) build_compliance(c, sample_.complete(ops.compliance));
    if (effects.thermal_deformation) {
      deformation_per_flux_ =
          sample_.complete(compose(ops.thermal_deformation, conduction_->nodal()));
      uniform_expansion_ = solid::uniform_expansion(ops);
      thermal_deformation_ = std::move(ops.thermal_deformation);
    }
  }
  setup_s_ = watch.seconds();
}

void Solids::build_compliance(const Case& c, const HarmonicOperator& shell) {
  const int N = harmonics_.highest();
  const RadialRows rows = rows_of_cylinder(c.bearing.radius, surface_row(c.bearing.radius, N));
  const double beyond = elastic_overhang(c);
  const RevolutionMesh shaft =
      make_revolution_mesh(rows.face, rows.layer, axial_elements(grid_, beyond), grid_.half);
  const HarmonicOperator journal = solid::shaft_compliance(shaft, grid_, c.shaft->material, N);
  HarmonicOperator both = shell;
  for (std::size_t n = 0; n < both.size(); ++n) both[n] += journal[n];
  if (both.size() > 1) hold_shaft(c, beyond, both);
  winkler_ = mean_compliance(both);  // of the surface: bending is no matter of a cell
  if (c.shaft->span && both.size() > 1) {
    both[1] += solid::shaft_bending(grid_, c.shaft->material, *c.shaft->span,
                                    c.bearing.width + 2.0 * beyond);
  }
  compliance_ = FieldOperator(harmonics_, both);
}

void Solids::hold_shaft(const Case& c, double beyond, HarmonicOperator& compliance) const {
  const double R = c.bearing.radius, width = c.bearing.width;
  if (beyond <= R) return;
  const auto shift = [&](double overhang) {
    return solid::free_shaft_shift(R, width, c.shaft->material, width + 2.0 * overhang);
  };
  const double moved = kPi * R * grid_.multiplicity() * (shift(beyond) - shift(R));
  const Eigen::Map<const Eigen::RowVectorXd> dz(grid_.dz.data(), grid_.nz);
  compliance[1].rowwise() -= moved * dz;
}

void Solids::build_heat(const Case& c, const Layers& layers, const RevolutionMesh& mesh) {
  std::vector<double> k;
  for (const auto& m : layers.material) {
    k.push_back(m.conductivity);
    capacity_.push_back(m.density * m.heat_capacity);
  }
  thermal::ConductionBoundary boundary;
  boundary.end_heat_transfer = c.shell->end_heat_transfer;
  if (const auto* back = std::get_if<ConvectiveBack>(&c.shell->back)) {
    boundary.kind = thermal::BackKind::convective;
    boundary.back_heat_transfer = back->heat_transfer;
    surroundings_ = back->ambient;
  } else {
    boundary.kind = thermal::BackKind::prescribed;
    surroundings_ = std::get<PrescribedBack>(c.shell->back).temperature;
  }
  boundary.back_line = thermal::outer_line(mesh, layers.last_of_shell);
  conduction_.emplace(mesh, grid_, k, boundary, harmonics_, sample_);
  build_shaft(c);
}

void Solids::build_shaft(const Case& c) {
  const Shaft& shaft = *c.shaft;
  const solid::Material& m = shaft.material;
  // Without overhang no ambient is met; temperatures count from one that they are near.
  shaft_ambient_ = shaft.overhang > 0.0 ? shaft.ambient : reference_;
  shaft_mesh_ = thermal::shaft_mesh(grid_, shaft.overhang);
  const RevolutionMesh& mesh = shaft_mesh_;
  shaft_conduction_.emplace(mesh, grid_,
                            thermal::ShaftBody{m.conductivity, shaft.heat_transfer, shaft_ambient_,
                                               m.density * m.heat_capacity});
  if (!effects_.thermal_deformation) return;
  // Where the elastic shaft is longer it is as warm there as at the end of the one that conducts.
  const double more = std::max(0.0, elastic_overhang(c) - shaft.overhang);
  const RevolutionMesh longer = make_revolution_mesh(
      mesh.r_face, mesh.layer, continued(mesh.z_face, more, mesh.half), mesh.half);
  const Eigen::MatrixXd by_node = solid::shaft_thermal_deformation(longer, grid_, m);
  const std::vector<int> node = nearest_along(longer, mesh);
  shaft_thermal_deformation_ = Eigen::MatrixXd::Zero(grid_.nz, mesh.nodes());
  for (std::size_t a = 0; a < node.size(); ++a) {
    shaft_thermal_deformation_.col(node[a]) += by_node.col(static_cast<Eigen::Index>(a));
  }
}

bool Solids::serve(const Case& c, const FilmGrid& grid, SolidEffects wanted) const {
  const bool effects = (effects_.elastic || !wanted.elastic) && (effects_.heat || !wanted.heat) &&
                       (effects_.thermal_deformation || !wanted.thermal_deformation) &&
                       (effects_.every_harmonic || !wanted.every_harmonic);
  const bool bodies =
      c.shell == shell_ && c.shaft == shaft_ && c.bearing.reference_temperature == reference_;
  const bool surface = grid.radius == grid_.radius && grid.half == grid_.half &&
                       grid.phi_face == grid_.phi_face && grid.z_face == grid_.z_face;
  return effects && bodies && surface;
}

Field Solids::compliance(const Field& pressure) const { return compliance_(pressure); }

HarmonicOperator Solids::contact_widening(double rate, const thermal::WallResponse& film,
                                          const SolidStep* step) const {
  const StepOperators* ops = step ? step->operators.get() : nullptr;
  const thermal::ShellConduction& shell = ops ? ops->shell : *conduction_;
  HarmonicOperator op = compose(ops ? ops->deformation_per_flux : deformation_per_flux_,
                                shell.entering({film.shell_ring, film.shell_local}));
  for (Eigen::MatrixXd& m : op) m *= rate;
  return op;
}

Field Solids::widening(const HarmonicOperator& by, const Field& contact) const {
  return apply(harmonics_, by, contact);
}

HarmonicOperator Solids::opening_by_skins(const SkinNodes& shell) const {
  const Eigen::SparseMatrix<double> nodes = nodes_of_skins(shell_mesh_, grid_, SkinOf::bore, shell);
  HarmonicOperator computed;
  for (const Eigen::MatrixXd& by_node : thermal_deformation_)
    computed.emplace_back(by_node * nodes);
  return sample_.complete(computed);
}

Eigen::MatrixXd Solids::opening_by_shaft_skins(const SkinNodes& shaft) const {
  return shaft_thermal_deformation_ * nodes_of_skins(shaft_mesh_, grid_, SkinOf::journal, shaft);
}

Solids::MeanChange Solids::mean_change(const WallFlux& q, const Field& T_shell,
                                       const std::vector<double>& T_shaft,
                                       const SolidStep& step) const {
  // What is missing to balance now: both vanish at the solution.
  const StepOperators* ops = step.operators.get();
  const thermal::ShellConduction& shell = ops ? ops->shell : *conduction_;
  const thermal::ShaftConduction& shaft = ops ? ops->shaft : *shaft_conduction_;
  const double now = shell.mean_surface(q.shell, surroundings_, ops ? &step.history : nullptr);
  double missing = 0.0;
  double area = 0.0;
  for (int i = 0; i < grid_.nt; ++i) {
    for (int j = 0; j < grid_.nz; ++j) {
      const int c = grid_.index(i, j);
      missing += grid_.area(i, j) * (now - T_shell[c]);
      area += grid_.area(i, j);
    }
  }
  const double whole = area * grid_.multiplicity();
  const double b1 = missing / area;  // [K]
  const double b2 = shaft.imbalance(q.shaft, T_shaft, ops ? &step.shaft : nullptr) / whole;
  // dTs (1 + R Gs) - R across dTj = b1,   -back dTs + (draw + Gj) dTj = b2 [W/m2]
  const double draw = shaft.conductance() / whole;
  const double R = shell.resistance();
  const auto& r = q.response;
  const double a11 = 1.0 + R * r.shell;
  const double a12 = -R * r.across;
  const double a21 = -r.back;
  const double a22 = draw + r.shaft;
  const double det = a11 * a22 - a12 * a21;
  if (!(det > 0.0)) return {};
  return {(b1 * a22 - a12 * b2) / det, (a11 * b2 - a21 * b1) / det};
}

SolidTemperature Solids::answer(const WallFlux& q, const Field& T_shell,
                                const std::vector<double>& T_shaft, Wanted wanted,
                                const SolidStep* given) const {
  const SolidStep endless;
  const SolidStep& step = given ? *given : endless;
  const StepOperators* ops = step.operators.get();
  SolidTemperature out;
  const MeanChange mean = mean_change(q, T_shell, T_shaft, step);
  // Half the largest response or more: below it the thinnest film would make a wall overshoot for
  // ever. The mean of a wall, which answers less, is led to its predicted change all the same.
  const auto& r = q.response;
  const double ring = std::max(r.shell, kLocalPart * r.shell_ring);
  const double local = std::max(ring, kLocalPart * r.shell_local);
  const double along = std::max(r.shaft, kLocalPart * r.shaft_ring);
  Field to_shell = q.shell;
  for (double& x : to_shell) x += r.across * mean.shaft + (ring - r.shell) * mean.shell;
  std::vector<double> to_shaft = q.shaft;
  for (double& x : to_shaft) x += r.back * mean.shell + (along - r.shaft) * mean.shaft;
  const thermal::ShellConduction& shell = ops ? ops->shell : *conduction_;
  out.shell = shell.solve(to_shell, {ring, local}, T_shell, surroundings_, wanted.back,
                          ops ? &step.history : nullptr);
  const thermal::ShaftConduction& shaft = ops ? ops->shaft : *shaft_conduction_;
  out.shaft = shaft.solve(to_shaft, along, T_shaft, ops ? &step.shaft : nullptr);
  if (!effects_.thermal_deformation || !wanted.thermal_deformation) return out;
  Eigen::MatrixXd bore = multiply(ops ? ops->deformation_per_flux : deformation_per_flux_,
                                  out.shell.flux.leftCols(harmonics_.coefficients()));
  if (ops) bore += step.thermal_deformation;
  out.thermal_deformation = total_deformation(bore, out.shaft.nodal);
  return out;
}

Field Solids::total_deformation(const Eigen::MatrixXd& bore, const Eigen::VectorXd& shaft) const {
  Field thermal_deformation = harmonics_.synthesise(bore);
  const Eigen::VectorXd journal =
      shaft_thermal_deformation_ * (shaft.array() + (shaft_ambient_ - reference_)).matrix();
  for (int i = 0; i < grid_.nt; ++i) {
    for (int j = 0; j < grid_.nz; ++j) {
      thermal_deformation[grid_.index(i, j)] +=
          uniform_expansion_[j] * (surroundings_ - reference_) + journal[j];
    }
  }
  return thermal_deformation;
}

std::vector<double> Solids::section_radii() const { return conduction_->section_radii(); }

std::vector<double> Solids::section(const thermal::ShellTemperature& T) const {
  Field values = harmonics_.synthesise(
      multiply(conduction_->section(), T.flux.leftCols(harmonics_.coefficients())));
  for (double& x : values) x += surroundings_;
  return values;
}

}  // namespace shellback::bearing
