#include "fidelity/tolerance.hpp"

#include <algorithm>
#include <cmath>

#include "fidelity/grid_error.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

double known(double bar) { return std::isfinite(bar) ? bar : 0.0; }

void propose_grid(const Result& r, bool nodes_stay, Shortfall& s) {
  const std::array<const RelativeBars*, 2> both{&s.friction, &s.h_min};
  const auto allowed = [&](const RelativeBars& b) { return s.tolerance - known(b.model); };
  const auto of_cells = [](const RelativeBars& b) { return known(b.grid - b.nodes); };
  s.more_nodes = !nodes_stay && std::any_of(both.begin(), both.end(), [&](const RelativeBars* b) {
    return b->nodes > kWorthAGrid * allowed(*b);
  });
  const auto of_nodes = [&](const RelativeBars& b) { return s.more_nodes ? 0.0 : b.nodes; };
  double wanted = 1.0;  // refinement of each direction
  for (const RelativeBars* b : both) {
    const double left = allowed(*b) - of_nodes(*b);
    if (!(left > 0.0)) {  // what nodes leave is too much for any cells
      s.expected = std::max(s.friction.total(), s.h_min.total());
      return;
    }
    wanted = std::max(wanted, std::pow(of_cells(*b) / left, 1.0 / b->order));
  }
  const auto cells = [&](int k, int step) {
    const double most = std::max(r.grid[k], kFineGrid[k]);
    return static_cast<int>(std::min(most, step * std::ceil(r.grid[k] * wanted / step)));
  };
  if (wanted > 1.0) s.grid = {cells(0, 10), cells(1, 1)};
  const double refined =
      std::sqrt(static_cast<double>(s.grid[0]) * s.grid[1] / (r.grid[0] * r.grid[1]));
  for (const RelativeBars* b : both) {
    const double cells = of_cells(*b) * std::pow(refined, -b->order);
    s.expected = std::max(s.expected, cells + of_nodes(*b) + known(b->model));
  }
}

}  // namespace

double RelativeBars::total() const { return std::isfinite(grid) ? grid + known(model) : model; }

bool is_laminar(const std::vector<Note>& warnings) {
  return std::none_of(warnings.begin(), warnings.end(),
                      [](const Note& n) { return std::holds_alternative<note::NotLaminar>(n); });
}

RelativeBars relative_bars(const Result& r, const std::string& quantity) {
  for (const Quantity& q : r.quantities) {
    const double size = q.size();
    if (q.name != quantity || size == 0.0) continue;
    return {q.discretisation() / size, q.error_model / size,
            std::isfinite(q.order) ? q.order : kLeastOrder,
            std::min(q.error_nodes, q.error_grid) / size};
  }
  return {NAN, NAN, kLeastOrder, 0.0};
}

Shortfall shortfall(const Result& r, double tolerance, bool nodes_stay) {
  Shortfall s{tolerance, relative_bars(r, "friction_torque"), relative_bars(r, "h_min")};
  s.grid = r.grid;
  s.laminar = is_laminar(r.warnings);
  if (r.choice) {  // of tier auto: held to what it means its values for
    s.met = r.choice->met;
    s.friction.grid = r.choice->bar_friction;
    s.h_min.grid = r.choice->bar_h_min;
    s.friction.model = s.h_min.model = 0.0;
    return s;
  }
  for (const RelativeBars* bars : {&s.friction, &s.h_min}) {
    if (bars->total() > tolerance) s.met = false;
    if (tolerance - known(bars->model) < kWorthAGrid * tolerance) s.physics = true;
  }
  const bool unknown = std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
    return std::holds_alternative<note::RicherNotFound>(n);
  });
  if (!s.laminar || unknown) s.met = false, s.physics = true;
  if (!s.met && !s.physics && r.grid[0] > 0) propose_grid(r, nodes_stay, s);
  return s;
}

bool told_apart(const Quantity& a, const Quantity& b) {
  const double bars = a.discretisation() + b.discretisation();
  return !(std::abs(a.value - b.value) < bars);
}

}  // namespace shellback::fidelity
