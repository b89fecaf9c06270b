#include "validation/bench/klu_yardstick.hpp"

#include <klu.h>

#include <map>
#include <stdexcept>
#include <vector>

#include "app/words/ending_words.hpp"
#include "bearing/bearing.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::bench {

RingMatrix reynolds_matrix(const bearing::Case& source, int nt, int nz) {
  bearing::Case c = source;
  c.model.grid = {nt, nz};
  c.operation.position = bearing::EccentricityGiven{0.9, 0.4, 4.71238898038469};
  bearing::BearingModel model =
      bearing::make_bearing(c, bearing::physics_of(c, bearing::Tier::isothermal), {nt, nz});
  model.domain.grid = full_grid(model.domain.grid);  // the same scene on the full width
  model.domain.angles = fluid::Angles(model.domain.grid);
  model.supply = fluid::map_supplies(model.domain.grid, model.supply.patches);
  model.profile.clear();
  const bearing::OperatingPoint point = bearing::operating_point(model);
  bearing::FilmEquilibrium film =
      bearing::cold_start(model, point, bearing::equivalent_temperature(c));
  bearing::EquilibriumCost cost;
  const auto verdict = bearing::solve_equilibrium({model, point, {}}, film, cost);
  if (!verdict.good()) throw std::runtime_error("the yardstick film: " + app::reason_of(verdict));
  RingMatrix matrix;
  fluid::assemble_film(point.scene, film.flow, fluid::active_set_unknowns(film.film), matrix);
  return matrix;
}

struct KluYardstick::Factors {
  klu_common common{};
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
  int n = 0;
  std::vector<int> start, row;
  std::vector<double> value;
};

namespace {

/// Columns of the ring matrix as row -> value, zeros left out.
std::vector<std::map<int, double>> columns_of(const RingMatrix& a) {
  std::vector<std::map<int, double>> columns(static_cast<std::size_t>(a.nt) * a.nz);
  const auto put = [&](int row, int column, double v) {
    if (v != 0.0) columns[column][row] += v;
  };
  for (int i = 0; i < a.nt; ++i) {
    for (int j = 0; j < a.nz; ++j) {
      const int k = i * a.nz + j;
      put(k, k, a.c[k]);
      put(k, (i == 0 ? a.nt - 1 : i - 1) * a.nz + j, a.w[k]);
      put(k, (i + 1 == a.nt ? 0 : i + 1) * a.nz + j, a.e[k]);
      if (j > 0) put(k, k - 1, a.s[k]);
      if (j + 1 < a.nz) put(k, k + 1, a.n[k]);
    }
  }
  return columns;
}

}  // namespace

KluYardstick::KluYardstick(const RingMatrix& a) : f_(std::make_unique<Factors>()) {
  f_->n = a.nt * a.nz;
  f_->start.push_back(0);
  for (const auto& column : columns_of(a)) {
    for (const auto& [row, value] : column) {
      f_->row.push_back(row);
      f_->value.push_back(value);
    }
    f_->start.push_back(static_cast<int>(f_->row.size()));
  }
  klu_defaults(&f_->common);
  factor_afresh();
}

KluYardstick::~KluYardstick() {
  klu_free_numeric(&f_->numeric, &f_->common);
  klu_free_symbolic(&f_->symbolic, &f_->common);
}

void KluYardstick::factor_afresh() {
  klu_free_numeric(&f_->numeric, &f_->common);
  klu_free_symbolic(&f_->symbolic, &f_->common);
  f_->symbolic = klu_analyze(f_->n, f_->start.data(), f_->row.data(), &f_->common);
  f_->numeric =
      klu_factor(f_->start.data(), f_->row.data(), f_->value.data(), f_->symbolic, &f_->common);
  if (!f_->numeric) throw std::runtime_error("KLU found the yardstick's matrix singular");
}

void KluYardstick::refactor() {
  if (!klu_refactor(f_->start.data(), f_->row.data(), f_->value.data(), f_->symbolic, f_->numeric,
                    &f_->common)) {
    throw std::runtime_error("KLU refactorisation failed");
  }
}

}  // namespace shellback::bench
