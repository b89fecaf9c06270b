#include "fluid/fill_front.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fluid {
namespace {

/// Harmonic mean of two slopes of one sign, else zero (van Leer).
double limited(double a, double b) { return a * b > 0.0 ? 2.0 * a * b / (a + b) : 0.0; }

/// The smaller of two numbers of one sign, else zero.
double smaller(double a, double b) {
  if (!(a * b > 0.0)) return 0.0;
  return std::abs(a) < std::abs(b) ? a : b;
}

/// What every cell would lose if each carried its own fill ratio [kg/s].
Field loss(const FilmScene& scene, const FilmState& film, const FilmFlow& flow) {
  const FilmGrid& g = scene.grid;
  Field lost = net_outflow(scene, flow);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int east = g.index(i, j);
      const int west = g.index(g.previous(i), j);
      if (scene.supply.line[east] >= 0) continue;
      const FaceFlow& f = flow.phi[east];
      const double more = f.couette * film.theta[scene.speed > 0.0 ? west : east] - f.carried;
      lost[west] += more;
      lost[east] -= more;
    }
  }
  return lost;
}

}  // namespace

Field fill_fronts(const FilmScene& scene, const FilmState& film, const FilmFlow& flow) {
  const FilmGrid& g = scene.grid;
  Field front(g.cells(), 0.0);
  if (scene.speed == 0.0 || flow.phi.size() != front.size()) return front;
  const bool forward = scene.speed > 0.0;
  const Field lost = loss(scene, film, flow);
  for (int i = 0; i < g.nt; ++i) {
    const int up = forward ? g.previous(i) : g.next(i);
    const int down = forward ? g.next(i) : g.previous(i);
    const double to_up = 0.5 * (g.dphi[up] + g.dphi[i]);
    const double to_down = 0.5 * (g.dphi[down] + g.dphi[i]);
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const int behind = g.index(up, j);
      const int ahead = g.index(down, j);
      const double theta = film.theta[k];
      const double room = theta * (1.0 - theta);
      const double couette = std::abs(flow.phi[forward ? ahead : k].couette);
      if (film.full[k] || scene.supply.cell[k] >= 0 || !(room > 0.0) || couette == 0.0) continue;
      const double of_fill =
          limited((theta - film.theta[behind]) / to_up, (film.theta[ahead] - theta) / to_down);
      const double of_loss = limited(lost[k] / g.dphi[i], lost[ahead] / g.dphi[down]) / couette;
      front[k] = std::clamp(-0.5 * g.dphi[i] * smaller(of_fill, of_loss) / room, -1.0, 1.0);
    }
  }
  return front;
}

}  // namespace shellback::fluid
