#include "bearing/over_time/wear_load.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/solids.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// to += f (a + b)
void add_both(double f, const Field& a, const Field& b, Field& to) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += f * (a[k] + b[k]);
}

}  // namespace

WearLoad wear_load_of(const BearingModel& model, const OperatingPoint& point,
                      const FilmEquilibrium& film, double limit) {
  const double U = std::abs(point.scene.speed);
  const double tau = model.physics.elastic ? model.solids->winkler() : 0.0;
  WearLoad out{film.p_contact, film.dp_contact};
  for (std::size_t k = 0; k < out.load.size(); ++k) {
    const double beyond = film.p_contact[k] - limit;
    const double slope = -film.dp_contact[k];
    out.load[k] = U * std::max(0.0, beyond);
    out.stiffness[k] = beyond > 0.0 ? U * slope / (1.0 + tau * slope) : 0.0;
  }
  return out;
}

void MeanWearLoad::begin(WearLoad first) {
  now_ = std::move(first);
  sum_ = {Field(now_.load.size(), 0.0), Field(now_.load.size(), 0.0)};
  time_ = 0.0;
}

void MeanWearLoad::add(WearLoad now, double dt) {
  add_both(0.5 * dt, now_.load, now.load, sum_.load);
  add_both(0.5 * dt, now_.stiffness, now.stiffness, sum_.stiffness);
  now_ = std::move(now);
  time_ += dt;
}

WearLoad MeanWearLoad::mean() const {
  EXPECTS(time_ > 0.0);
  WearLoad out = sum_;
  for (double& x : out.load) x /= time_;
  for (double& x : out.stiffness) x /= time_;
  return out;
}

}  // namespace shellback::bearing
