#include "app/hdf5_result.hpp"

#include <cmath>
#include <functional>
#include <numeric>

#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "core/contract.hpp"

namespace shellback::app::hdf5 {

using bearing::Result;

void write_head(hid_t file, const Result& result) {
  attribute(file, "format", std::string("shellback result"));
  attribute(file, "format_version", kFormatVersion);
  attribute(file, "title", result.title);
  attribute(file, "tier", std::string(to_string(result.tier)));
  attribute(file, "status", std::string(to_string(result.verdict.status)));
  attribute(file, "converged", result.verdict.good() ? 1 : 0);
  const EndingWords words = words_of(result.verdict);
  attribute(file, "reason", words.reason);
  attribute(file, "place", words.place);
  attribute(file, "cure", words.cure);
}

void write_bars(hid_t quantities, const bearing::Quantity& q) {
  const auto known = [&](const char* suffix, double value) {  // what is not known is not there
    if (std::isfinite(value)) attribute(quantities, q.name + suffix, value);
  };
  known("_error", q.error());
  known("_error_grid", q.error_grid);
  known("_error_time", q.error_time);
  known("_error_model", q.error_model);
  known("_limit", q.limit);
}

void write_cost(hid_t file, const bearing::Cost& k) {
  const Handle cost = group(file, "cost");
  attribute(cost, "wall_s", k.wall_s);
  attribute(cost, "setup_s", k.setup_s);
  attribute(cost, "factorizations", k.factorizations);
  attribute(cost, "newton_iterations", k.newton_iterations);
  attribute(cost, "outer_iterations", k.outer_iterations);
}

void write_film_grid(hid_t grid, const FilmGrid& g) {
  attribute(grid, "radius", g.radius);
  attribute(grid, "radius_unit", std::string("m"));
  attribute(grid, "width", g.width);
  attribute(grid, "width_unit", std::string("m"));
  doubles(grid, "phi", g.phi, "rad", "circumferential cell position, counter-clockwise from X");
  doubles(grid, "dphi", g.dphi, "rad", "circumferential cell width");
  doubles(grid, "phi_face", g.phi_face, "rad", "circumferential face position");
  doubles(grid, "z", g.z, "m", "axial cell position, 0 at mid-width");
  doubles(grid, "dz", g.dz, "m", "axial cell width");
  doubles(grid, "z_face", g.z_face, "m", "axial face position");
}

void field(hid_t parent, const char* name, const std::vector<double>& values, const Shape& shape,
           const Meaning& meaning) {
  if (values.empty()) return;
  [[maybe_unused]] const auto size =
      std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
  EXPECTS(size == values.size());
  dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), shape, meaning);
}

void write_effects(hid_t file, const Result& result) {
  using bearing::Effect;
  const Handle effects = group(file, "effects");
  texts(effects, "name",
        column<std::string>(result.effects, [](const Effect& e) { return name_of(e.kind); }),
        "effect");
  doubles(effects, "included", column<double>(result.effects, &Effect::included), "-",
          "1: part of the model, 0: left out");
  doubles(effects, "indicator", column<double>(result.effects, &Effect::indicator), "-",
          "indicator number of the effect");
  texts(effects, "meaning", column<std::string>(result.effects, meaning_of),
        "what the indicator is");
}

void write_notes(hid_t file, const Result& result) {
  using bearing::LimiterCount;
  const Handle limiters = group(file, "limiters");
  texts(
      limiters, "what",
      column<std::string>(result.limiters, [](const LimiterCount& l) { return words_of(l.what); }),
      "limiter");
  doubles(limiters, "count", column<double>(result.limiters, &LimiterCount::count), "-",
          "how often it acted");
  const Handle notes = group(file, "notes");
  texts(notes, "warnings", words_of(result.warnings), "warnings");
  texts(notes, "assumptions", words_of(result.assumptions), "defaults and assumed data relied on");
}

}  // namespace shellback::app::hdf5
