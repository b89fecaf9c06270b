#pragma once
/// Oil of one temperature whose viscosity and density follow the pressure by its own laws.
#include "fluid/reynolds.hpp"
#include "rheology/density.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::validation {

[[nodiscard]] inline fluid::OilLaw barotropic_oil(const rheology::Oil& oil, double temperature) {
  return [oil, temperature](const fluid::FilmState& state, fluid::FilmCoefficients& c) {
    const std::size_t n = state.p.size();
    c.fluidity.resize(n);
    c.alpha.resize(n);
    c.density.resize(n);
    c.chi.assign(n, 0.5);  // one viscosity across the film
    for (std::size_t k = 0; k < n; ++k) {
      c.fluidity[k] = 1.0 / (12.0 * rheology::viscosity(oil, temperature, state.p[k]));
      c.alpha[k] = rheology::pressure_slope(oil, temperature, state.p[k]);
      c.density[k] = rheology::density(oil, temperature, state.p[k]).rho;
    }
  };
}

}  // namespace shellback::validation
