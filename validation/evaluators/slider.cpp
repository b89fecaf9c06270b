#include "validation/evaluators/slider.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/make_grid.hpp"

namespace shellback::validation {
namespace {

using namespace fluid;

constexpr double kRing = 1.25;         ///< circumference over L [-]
constexpr double kEndlessly = 1000.0;  ///< width over radius: side flow is 1e-6 of the flow along
constexpr double kTurn = 2.0 * kPi;    ///< [rad]
constexpr double kOnTheFace = 1e-12;   ///< puts a face on the side it begins [rad]

class Scene {
 public:
  explicit Scene(const Slider& slider) : s_(slider) {
    const double R = kRing * s_.length / kTurn;
    const bool wide = s_.width <= 0.0;
    const double width = wide ? kEndlessly * R : s_.width;
    SupplyPatch rest;
    rest.arc = (kRing - 1.0) / kRing * kTurn;
    rest.phi = -0.5 * rest.arc;
    rest.length = width;
    rest.pressure = s_.p_ambient;
    GridEdges phi = phi_edges({rest});
    phi.push_back(s_.pocket_from / R);
    phi.push_back(s_.pocket_to / R);
    GridEdges z;
    if (!wide) z = {-0.5 * s_.pocket_width, 0.5 * s_.pocket_width};
    scene.grid = make_grid(R, width, static_cast<int>(std::lround(kRing * s_.cells)),
                           wide ? 1 : s_.cells_across, !wide, phi, z);
    scene.angles = Angles(scene.grid);
    scene.supply = map_supplies(scene.grid, {rest});
    scene.speed = s_.speed;
    scene.p_edge = s_.p_ambient;
    scene.edges = wide ? SideEdges::dry : SideEdges::flooded;
    add_pocket();
    add_wedge();
  }

  /// Position on the slider [m]; beyond L on the rest of the ring.
  [[nodiscard]] double x_of(double phi) const {
    return scene.grid.radius * (phi - kTurn * std::floor(phi / kTurn));
  }

  FilmScene scene;
  Field step;
  Gap gap;

 private:
  void add_pocket() {
    const FilmGrid& g = scene.grid;
    step.assign(g.cells(), 0.0);
    for (int i = 0; i < g.nt; ++i) {
      const double x = x_of(g.phi[i]);
      if (x < s_.pocket_from || x > s_.pocket_to) continue;
      for (int j = 0; j < g.nz; ++j) {
        if (s_.width <= 0.0 || std::abs(g.z[j]) < 0.5 * s_.pocket_width) {
          step[g.index(i, j)] = s_.depth;
        }
      }
    }
  }

  /// The smooth part of the gap, exactly at cells and faces.
  void add_wedge() {
    const FilmGrid& g = scene.grid;
    gap = film_gap(g, scene.angles, s_.h_out, {}, {}, step);
    const auto wedge = [this](double x) {
      return x < s_.length ? (s_.h_in - s_.h_out) * (1.0 - x / s_.length) : 0.0;
    };
    for (int i = 0; i < g.nt; ++i) {
      const double at_cell = wedge(x_of(g.phi[i]));
      for (int j = 0; j < g.nz; ++j) {
        gap.phi_face[g.index(i, j)] += wedge(x_of(g.phi_face[i] + kOnTheFace));
        gap.cell[g.index(i, j)] += at_cell;
      }
      for (int j = 0; j <= g.nz; ++j) gap.z_face[i * (g.nz + 1) + j] += at_cell;
    }
  }

  const Slider& s_;
};

struct Cell {
  int i;
  double x;  ///< [m]
};

/// The slider's cells in order along x.
std::vector<Cell> cells_along(const Scene& scene) {
  std::vector<Cell> cells;
  const FilmGrid& g = scene.scene.grid;
  for (int i = 0; i < g.nt; ++i) {
    if (scene.scene.supply.cell[g.index(i, 0)] < 0) cells.push_back({i, scene.x_of(g.phi[i])});
  }
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.x < b.x; });
  return cells;
}

}  // namespace

SliderFilm solve_slider(const Slider& slider, const OilLaw& oil, double density) {
  const Scene scene(slider);
  const FilmGrid& g = scene.scene.grid;
  const auto film = solve_reynolds(scene.scene, scene.gap, scene.step, oil, cold_film(scene.scene));
  SliderFilm out;
  out.verdict = film.verdict;
  if (!film.good()) return out;
  const std::vector<Cell> cells = cells_along(scene);
  const FilmState& state = film.value.state;
  const double strip = g.multiplicity() * g.dz[0] / (g.half ? 2.0 : 1.0);  // width of row j = 0
  out.reformation = -1.0;
  out.x.push_back(0.0);
  out.p.push_back(slider.p_ambient);
  bool empty = false;
  for (const Cell& cell : cells) {
    const int k = g.index(cell.i, 0);
    const double dx = g.radius * g.dphi[cell.i];
    out.x.push_back(cell.x);
    out.p.push_back(state.p[k]);
    out.p_max = std::max(out.p_max, state.p[k]);
    out.load_per_width += (state.p[k] - slider.p_ambient) * dx;
    out.flow_per_width +=
        film.value.flow.phi[k].m / (density * strip * static_cast<double>(cells.size()));
    if (empty && state.theta[k] == 1.0) out.reformation = cell.x - 0.5 * dx;
    empty = state.theta[k] < 1.0;
  }
  out.x.push_back(slider.length);
  out.p.push_back(slider.p_ambient);
  return out;
}

double pressure_at(const SliderFilm& film, double x) {
  const auto above = std::upper_bound(film.x.begin(), film.x.end(), x);
  if (above == film.x.begin()) return film.p.front();
  if (above == film.x.end()) return film.p.back();
  const auto k = static_cast<std::size_t>(above - film.x.begin());
  const double u = (x - film.x[k - 1]) / (film.x[k] - film.x[k - 1]);
  return (1.0 - u) * film.p[k - 1] + u * film.p[k];
}

}  // namespace shellback::validation
