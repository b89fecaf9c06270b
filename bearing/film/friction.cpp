#include "bearing/film/friction.hpp"

#include <algorithm>

#include "rheology/viscosity.hpp"

namespace shellback::bearing {

namespace {

/// g0 of the columns (columns.hpp, (1)); in supplies, whose film coefficients are those of the film
/// that begins at their edge, of the oil that the journal shears over `h`.
Field sheared_fluidity(const BearingModel& model, const OperatingPoint& point,
                       const FilmEquilibrium& s, const Field& h) {
  Field g0 = s.columns.g0;
  if (!rheology::thins(model.oil)) return g0;
  const auto n = static_cast<std::size_t>(model.gl.n);
  std::vector<int> cells;
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (point.scene.supply.cell[k] >= 0) cells.push_back(static_cast<int>(k));
  }
  if (cells.empty()) return g0;
  OilColumns oil = uniform_columns(static_cast<int>(cells.size()), model.gl.n, 0.0);
  fluid::FilmState film;
  Field depth;
  for (std::size_t m = 0; m < cells.size(); ++m) {
    std::copy_n(&s.columns.T[cells[m] * n], n, &oil.T[m * n]);
    std::copy_n(&s.columns.eta[cells[m] * n], n, &oil.eta[m * n]);
    film.p.push_back(s.film.p[cells[m]]);
    depth.push_back(h[cells[m]]);
  }
  const Field level(cells.size(), 0.0);
  const std::vector<int> supply(cells.size(), 0);
  fluid::FilmCoefficients unused;
  update_columns(model.oil, model.gl, point.scene.speed, depth, supply, film, level, level,
                 EquilibriumOptions{}.viscosity_tolerance, oil, unused);
  for (std::size_t m = 0; m < cells.size(); ++m) g0[cells[m]] = oil.g0[m];
  return g0;
}

}  // namespace

Friction friction_of(const BearingModel& model, const OperatingPoint& point,
                     const FilmEquilibrium& s) {
  const fluid::FilmScene& scene = point.scene;
  const Field h = fluid::nominal_depth(s.gap, scene.supply);
  Friction f;
  f.stress = fluid::shear_stress(scene, h, sheared_fluidity(model, point, s, h), s.oil.chi, s.film,
                                 s.gradient_x, model.shear_rule);
  f.viscous = fluid::torque(scene, f.stress.journal);
  f.viscous_shell = fluid::torque(scene, f.stress.shell);
  if (model.contact) f.asperity = fluid::torque(scene, asperity_stress(model, point, s).sum());
  return f;
}

Field AsperityStress::sum() const {
  Field all = abrasive;
  for (std::size_t c = 0; c < all.size(); ++c) all[c] += adhesive[c] + micro_hydrodynamic[c];
  return all;
}

solid::RubbingPlace rubbing_place(const BearingModel& model, const OperatingPoint& point,
                                  const FilmEquilibrium& s, std::size_t c) {
  return model.contact->place(s.gap.cell[c], s.p_contact[c], 1.0 / s.columns.g0[c],
                              point.scene.speed);
}

AsperityStress asperity_stress(const BearingModel& model, const OperatingPoint& point,
                               const FilmEquilibrium& s) {
  AsperityStress tau;
  if (!model.contact) return tau;
  const std::size_t cells = s.p_contact.size();
  for (Field* part : {&tau.abrasive, &tau.adhesive, &tau.micro_hydrodynamic}) {
    part->assign(cells, 0.0);
  }
  for (std::size_t c = 0; c < cells; ++c) {
    const solid::FrictionParts parts =
        model.contact->friction().stress(rubbing_place(model, point, s, c));
    tau.abrasive[c] = parts.abrasive;
    tau.adhesive[c] = parts.adhesive;
    tau.micro_hydrodynamic[c] = parts.micro_hydrodynamic;
  }
  return tau;
}

double breakaway_torque(const BearingModel& model, const OperatingPoint& point,
                        const FilmEquilibrium& s) {
  if (!model.contact) return 0.0;
  Field tau = s.p_contact;
  for (double& p : tau) p *= model.contact->friction().at_rest();
  return fluid::torque(point.scene, tau);
}

}  // namespace shellback::bearing
