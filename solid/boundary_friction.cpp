#include "solid/boundary_friction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::solid {
namespace {

GenericFriction law_of(const ContactParameters& p) {
  if (p.friction_law) return *p.friction_law;
  GenericFriction constant;
  constant.abrasive = p.friction;
  return constant;
}

void require(bool good, const char* what, double value, const char* wanted) {
  if (good) return;
  throw InputError(fmt::format("boundary friction: {} is {} ({})", what, value, wanted));
}

}  // namespace

double summit_product(double elastic_factor, double sigma, double summit_radius) {
  const double factor = 16.0 * std::sqrt(2.0) * kPi / 15.0;
  return std::sqrt(elastic_factor / factor * std::sqrt(summit_radius / sigma));
}

double contact_area_integral(double H) {
  const double beyond = 0.5 * std::erfc(H / std::sqrt(2.0));
  const double density = std::exp(-0.5 * H * H) / std::sqrt(2.0 * kPi);
  return (1.0 + H * H) * beyond - H * density;
}

BoundaryFriction::BoundaryFriction(const ContactParameters& parameters, double sigma)
    : law_(law_of(parameters)) {
  if (!parameters.friction_law) return;
  require(law_.a > 1.0, "the base a", law_.a, "must be above 1");
  require(law_.summit_radius > 0.0, "the summit radius", law_.summit_radius, "must be positive");
  require(law_.orientation > 0.0, "the orientation", law_.orientation, "must be positive");
  decay_ = std::log(law_.a) * std::sqrt(law_.b);
  summits_ = summit_product(parameters.elastic_factor, sigma, law_.summit_radius);
  L_s_ = law_.L_s ? *law_.L_s : sigma / (summits_ * std::sqrt(law_.orientation));
  require(L_s_ > 0.0, "the reference length", L_s_, "must be positive");
}

double BoundaryFriction::contact_ratio(double H) const {
  if (!(law_.c > 0.0)) return 0.0;
  return std::min(kPi * kPi * summits_ * summits_ * contact_area_integral(H), 1.0);
}

FrictionParts BoundaryFriction::coefficient(const RubbingPlace& at) const {
  if (!varies()) return {law_.abrasive, 0.0, 0.0};
  if (!(at.p > 0.0)) return {law_.abrasive, 0.0, 0.0};
  const double L_N = at.eta * std::abs(at.du) / (at.p * L_s_);
  const double D = std::exp(-decay_ * std::sqrt(L_N));
  return {law_.abrasive, law_.adhesive * D, law_.c * at.r_c * L_N * (1.0 - D)};
}

FrictionParts BoundaryFriction::stress(const RubbingPlace& at) const {
  const FrictionParts mu = coefficient(at);
  const double pressed = at.p * std::tanh(at.du / kMicroSlip);
  return {mu.abrasive * pressed, mu.adhesive * pressed, mu.micro_hydrodynamic * pressed};
}

double BoundaryFriction::per_pressure(const RubbingPlace& at) const {
  return coefficient(at).sum() * std::tanh(at.du / kMicroSlip);
}

}  // namespace shellback::solid
