/// A slider of finite width with a pocket: Barus oil of varying density, two-dimensional film.
#include "app/words/ending_words.hpp"
#include "validation/evaluators/barotropic_oil.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/evaluators/slider.hpp"

namespace shellback::validation {
namespace {

using namespace fluid;

constexpr double kTemperature = 313.15;  // of no effect: the viscosity depends on p only [K]

/// The source's oil; its density law has constants other than those of the law without C1 and C2.
rheology::Oil oil_of_source() {
  constexpr double kC1 = 2.22e9;  // header of validation/data/bertocchi_2013_pocket_2d.csv [Pa]
  constexpr double kC2 = 1.66;
  rheology::Oil oil;
  oil.temperature = rheology::ConstantViscosity{0.01};
  oil.pressure = rheology::Barus{1.2e-8};
  oil.density = rheology::DowsonHigginson{850.0, kTemperature, 0.0, (kC2 - 1.0) / kC1, 1.0 / kC1};
  return oil;
}

/// The slider of the table's header; its widths are what tells the small from the large one.
Slider slider_of(const Entry& entry) {
  Slider s;
  s.length = number_setting(entry, "length_m");
  s.width = number_setting(entry, "width_m");
  s.pocket_width = number_setting(entry, "pocket_width_m");
  s.h_in = 1.1e-6;
  s.h_out = 1.0e-6;
  s.pocket_from = 0.004;
  s.pocket_to = 0.010;
  s.depth = 0.4e-6;
  s.speed = 1.0;
  s.p_ambient = 1.0e5;
  s.cells = static_cast<int>(number_setting(entry, "cells"));
  s.cells_across = static_cast<int>(number_setting(entry, "cells_across"));
  return s;
}

}  // namespace

std::any prepare_pocket_plate(const Entry& entry) {
  const rheology::Oil oil = oil_of_source();
  return solve_slider(slider_of(entry), barotropic_oil(oil, kTemperature),
                      rheology::density(oil, kTemperature, 0.0).rho);
}

Values pocket_plate_values(const Question& q) {
  const auto& film = std::any_cast<const SliderFilm&>(q.prepared);
  Values values;
  if (!film.verdict.good()) {
    values.failure = app::reason_of(film.verdict);
    return values;
  }
  values.value["p_max"] = film.p_max;
  values.value["pressure"] =
      pressure_at(film, q.number("x_over_L") * number_setting(q.entry, "length_m"));
  return values;
}

}  // namespace shellback::validation
