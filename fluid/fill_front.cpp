#include "fluid/fill_front.hpp"

#include <algorithm>

namespace shellback::fluid {
namespace {

/// Harmonic mean of two slopes of one sign, else zero (van Leer).
double limited_slope(double a, double b) { return a * b > 0.0 ? 2.0 * a * b / (a + b) : 0.0; }

/// A cell, the one from which its oil comes, and the one to which it goes.
struct Along {
  int cell, behind, ahead;
  double length;               ///< of the cell [rad]
  double to_behind, to_ahead;  ///< from middle to middle [rad]
  bool fed;                    ///< a supply, or a line of one, lies at one of its ends
};

Along along(const FilmScene& s, int i, int j) {
  const FilmGrid& g = s.grid;
  const bool forward = s.speed > 0.0;
  const int up = forward ? g.previous(i) : g.next(i);
  const int down = forward ? g.next(i) : g.previous(i);
  Along a{g.index(i, j),
          g.index(up, j),
          g.index(down, j),
          g.dphi[i],
          0.5 * (g.dphi[up] + g.dphi[i]),
          0.5 * (g.dphi[down] + g.dphi[i]),
          false};
  for (const int k : {a.behind, a.ahead}) a.fed = a.fed || s.supply.cell[k] >= 0;
  for (const int face : {a.cell, forward ? a.ahead : a.behind}) {
    a.fed = a.fed || s.supply.line[face] >= 0;
  }
  return a;
}

}  // namespace

Field fill_fronts(const FilmScene& scene, const FilmState& film, const FilmFlow& flow) {
  constexpr double kFlattest = -0.5;  // (3): 1 + f of two, and of a half
  constexpr double kSteepest = 1.0;
  const FilmGrid& g = scene.grid;
  Field front(g.cells(), 0.0);
  if (scene.speed == 0.0 || flow.stored_by_theta.size() != front.size()) return front;
  Field room = flow.stored_by_theta;  // rho hT, in units of the step that it was stored in
  for (int k = 0; k < g.cells(); ++k) room[k] /= g.area(k);
  const auto oil = [&](int k) { return room[k] * film.theta[k]; };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const Along a = along(scene, i, j);
      const double theta = film.theta[a.cell];
      if (film.full[a.cell] || scene.supply.cell[a.cell] >= 0) continue;
      if (!(theta > 0.0 && theta < 1.0 && room[a.ahead] > 0.0)) continue;
      const double M = oil(a.cell);
      const double slope =
          a.fed ? 0.0
                : limited_slope((M - oil(a.behind)) / a.to_behind, (oil(a.ahead) - M) / a.to_ahead);
      const double share = 0.5 * a.length / a.to_ahead;  // of the way ahead: the face
      const double room_at_face = room[a.cell] + share * (room[a.ahead] - room[a.cell]);
      const double at_face = (M + 0.5 * a.length * slope) / room_at_face;
      if (!(at_face > 0.0)) continue;
      front[a.cell] = std::clamp((theta / at_face - 1.0) / (1.0 - theta), kFlattest, kSteepest);
    }
  }
  return front;
}

}  // namespace shellback::fluid
