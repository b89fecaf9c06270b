/// Shell, housing and shaft from one time step to the next.
#include <cmath>

#include "bearing/solids.hpp"

namespace shellback::bearing {
namespace {

/// The bore's thermal deformation for nodal temperatures above the surroundings [m], by their
/// harmonics; none without operators.
Eigen::MatrixXd bore_expansion(const HarmonicOperator& thermal_deformation,
                               const Eigen::MatrixXd& nodal) {
  if (thermal_deformation.empty()) return {};
  const auto known = 2 * static_cast<Eigen::Index>(thermal_deformation.size()) - 1;
  return multiply(thermal_deformation, nodal.leftCols(known));
}

}  // namespace

SolidStep Solids::step(double dt, const SolidState& before, const SolidStep* last) const {
  SolidStep step;
  if (std::isinf(dt) && dt > 0.0) return step;
  if (last && last->operators && last->operators->shell.dt() == dt) {
    step.operators = last->operators;
  } else {
    StepOperators ops{conduction_->over(dt, capacity_), shaft_conduction_->over(dt), {}, {}};
    if (effects_.thermal_deformation) {
      ops.thermal_deformation = sample_.complete(thermal_deformation_);
      ops.deformation_per_flux = compose(ops.thermal_deformation, ops.shell.nodal());
    }
    step.operators = std::make_shared<const StepOperators>(std::move(ops));
  }
  step.history = step.operators->shell.history(before.shell);
  step.shaft = step.operators->shaft.history(before.shaft);
  step.thermal_deformation =
      bore_expansion(step.operators->thermal_deformation, step.history.nodal);
  return step;
}

SolidState Solids::state(const SolidTemperature& answer, const SolidStep* step) const {
  const StepOperators* ops = step ? step->operators.get() : nullptr;
  const Eigen::MatrixXd& flux = answer.shell.flux;
  return {ops ? ops->shell.nodal_temperatures(flux, &step->history)
              : conduction_->nodal_temperatures(flux),
          answer.shaft.nodal};
}

SolidState Solids::uniform_state(double T) const {
  return {conduction_->uniform_temperatures(T - surroundings_), shaft_conduction_->uniform(T)};
}

SolidTemperature Solids::at(const SolidState& state) const {
  SolidTemperature out;
  out.shell = conduction_->at(state.shell, surroundings_);
  out.shaft = shaft_conduction_->at(state.shaft);
  if (effects_.thermal_deformation) {
    out.thermal_deformation = total_deformation(
        bore_expansion(sample_.complete(thermal_deformation_), state.shell), state.shaft);
  }
  return out;
}

std::vector<double> Solids::section(const SolidState& state) const {
  Field values =
      harmonics_.synthesise(conduction_->section(state.shell).leftCols(harmonics_.coefficients()));
  for (double& x : values) x += surroundings_;
  return values;
}

}  // namespace shellback::bearing
