/// The exact pocket slider: endlessly wide, isoviscous, incompressible.
#include "app/words/ending_words.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/evaluators/plain_oil.hpp"
#include "validation/evaluators/slider.hpp"

namespace shellback::validation {
namespace {

using namespace fluid;

constexpr double kSliderViscosity = 0.01;  // validation 5.1 [Pa s]

/// The slider of Fowell et al. (header of validation/data/pocket_slider_fowell_exact.csv).
SliderFilm solve_on(int cells) {
  Slider s;
  s.length = 0.01;
  s.h_in = 1.05e-6;
  s.h_out = 1.0e-6;
  s.pocket_from = 0.002;
  s.pocket_to = 0.005;
  s.depth = 1.0e-6;
  s.speed = 1.0;
  s.p_ambient = 1.0e5;
  s.cells = cells;
  const OilLaw oil = plain_oil(kSliderViscosity, kAnyDensity);
  return solve_slider(s, oil, kAnyDensity);
}

}  // namespace

std::any prepare_pocket_slider(const Entry& entry) {
  if (entry.table->has("cells")) return {};  // the rows are grids
  return solve_on(static_cast<int>(number_setting(entry, "cells")));
}

Values pocket_slider_values(const Question& q) {
  const SliderFilm film = q.prepared.has_value() ? std::any_cast<const SliderFilm&>(q.prepared)
                                                 : solve_on(static_cast<int>(q.number("cells")));
  Values values;
  if (!film.verdict.good()) {
    values.failure = app::reason_of(film.verdict);
    return values;
  }
  values.value = {{"flow_per_width", film.flow_per_width},
                  {"p_max", film.p_max},
                  {"reformation", film.reformation},
                  {"load_per_width", film.load_per_width}};
  if (q.prepared.has_value()) values.value["pressure"] = pressure_at(film, q.number("x_m"));
  return values;
}

}  // namespace shellback::validation
