/// A slider of finite width with a pocket: Barus oil of varying density, two-dimensional film.
#include "proof/evaluators/evaluators.hpp"
#include "proof/evaluators/slider.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::proof {
namespace {

using namespace fluid;

constexpr double kTemperature = 313.15;  // of no effect: the viscosity depends on p only [K]

/// Viscosity of the source's oil.
rheology::Oil oil_of_source() {
  rheology::Oil oil;
  oil.temperature = rheology::ConstantViscosity{0.01};
  oil.pressure = rheology::Barus{1.2e-8};
  return oil;
}

/// Its density, rho0 (C1 + C2 p)/(C1 + p): the law of Dowson and Higginson with the constants of
/// the source, which are others than those the solver's law has.
double density_of_source(double p) {
  constexpr double kDensity = 850.0;  // [kg/m3]
  constexpr double kC1 = 2.22e9;      // [Pa]
  constexpr double kC2 = 1.66;
  return kDensity * (kC1 + kC2 * p) / (kC1 + p);
}

SliderFilm solve_on(int cells, int across) {
  Slider s;  // the small slider, header of validation/data/bertocchi_2013_pocket_2d.csv
  s.length = 0.02;
  s.width = 0.01;
  s.h_in = 1.1e-6;
  s.h_out = 1.0e-6;
  s.pocket_from = 0.004;
  s.pocket_to = 0.010;
  s.pocket_width = 0.007;
  s.depth = 0.4e-6;
  s.speed = 1.0;
  s.p_ambient = 1.0e5;
  s.cells = cells;
  s.cells_across = across;
  const rheology::Oil oil = oil_of_source();
  const OilLaw law = [oil](const FilmState& state, FilmCoefficients& c) {
    const std::size_t n = state.p.size();
    c.fluidity.resize(n);
    c.alpha.resize(n);
    c.density.resize(n);
    c.chi.assign(n, 0.5);
    for (std::size_t k = 0; k < n; ++k) {
      c.fluidity[k] = 1.0 / (12.0 * rheology::viscosity(oil, kTemperature, state.p[k]));
      c.alpha[k] = rheology::pressure_slope(oil, kTemperature, state.p[k]);
      c.density[k] = density_of_source(state.p[k]);
    }
  };
  return solve_slider(s, law, density_of_source(0.0));
}

}  // namespace

std::any prepare_pocket_plate(const Entry& entry) {
  return solve_on(static_cast<int>(number_setting(entry, "cells")),
                  static_cast<int>(number_setting(entry, "cells_across")));
}

Values pocket_plate_values(const Question& q) {
  const auto& film = std::any_cast<const SliderFilm&>(q.prepared);
  Values values;
  if (!film.verdict.good()) {
    values.failure = film.verdict.reason;
    return values;
  }
  values.value["p_max"] = film.p_max;
  values.value["pressure"] =
      pressure_at(film, q.number("x_over_L") * number_setting(q.entry, "length_m"));
  return values;
}

}  // namespace shellback::proof
