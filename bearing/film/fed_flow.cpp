#include "bearing/film/fed_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Along a side edge the gap changes: about as much of it is taken together [rad].
constexpr double kPiece = kPi / 6.0;

enum Side { upstream, downstream, low_z, high_z };

/// Oil on its way out over one side of a patch, or a piece of it.
struct Outflow {
  double m = 0.0;         ///< pressed out [kg/s]
  double section = 0.0;   ///< sum of rho h w [kg/m]
  double width = 0.0;     ///< [m]
  double fluidity = 0.0;  ///< sum of fluidity times width
  double most = 0.0;      ///< of a face [kg/s]
  int cell = -1;          ///< there
};

/// The sides of all patches, over which oil leaves.
class Outflows {
 public:
  Outflows(const fluid::FilmScene& scene, const Evaluation& film) : scene_(scene), film_(film) {}

  /// A face between a patch and the film cell `k`: `pressed` of the `net` mass flow out of it
  /// [kg/s] is driven by pressure. What the journal drags in again is not pressed out.
  void add(int patch, Side side, int k, double pressed, double net, double width) {
    const fluid::SupplyPatch& p = scene_.supply.patches[patch];
    const double m = std::max(std::min(pressed, net), 0.0);
    const bool along = side == low_z || side == high_z;
    const double from = std::remainder(scene_.grid.phi[k / scene_.grid.nz] - p.phi, 2.0 * kPi);
    Outflow& o = by_side_[{patch, side, along ? piece_of(p.arc, from) : 0}];
    o.m += m;
    o.section += film_.oil.density[k] * film_.shear_gap[k] * width;
    o.width += width;
    o.fluidity += film_.oil.fluidity[k] * width;
    if (m <= o.most) return;
    o.most = m;
    o.cell = k;
  }

  [[nodiscard]] note::FedFlow worst() const {
    note::FedFlow most;
    for (const auto& [where, o] : by_side_) {
      const fluid::SupplyPatch& p = scene_.supply.patches[where[0]];
      const double drive = p.pressure - scene_.p_cavitation;
      if (o.cell < 0 || !(drive > 0.0)) continue;
      const double u = o.m / o.section;
      const double rho = film_.oil.density[o.cell];
      const double head = 0.5 * rho * u * u;
      const double reynolds = 12.0 * o.fluidity * o.m / (o.width * o.width);
      most = worse(most, {u, head, head / drive, reynolds, fluid::place_of(scene_.grid, o.cell)});
    }
    return most;
  }

 private:
  /// Of the equal pieces, about kPiece long, of an arc, `from` its middle [rad].
  static int piece_of(double arc, double from) {
    const double whole = std::min(arc, 2.0 * kPi);
    const long pieces = std::max(1L, std::lround(whole / kPiece));
    const double part = (from + 0.5 * whole) / whole * static_cast<double>(pieces);
    return static_cast<int>(std::clamp(part, 0.0, static_cast<double>(pieces) - 0.5));
  }

  const fluid::FilmScene& scene_;
  const Evaluation& film_;
  std::map<std::array<int, 3>, Outflow> by_side_;  ///< patch, side, piece
};

}  // namespace

note::FedFlow worse(note::FedFlow a, const note::FedFlow& b) {
  const double reynolds = larger(a.reynolds, b.reynolds);
  if (b.part > a.part) a = b;
  a.reynolds = reynolds;
  return a;
}

note::FedFlow fed_flow(const fluid::FilmScene& scene, const Evaluation& film) {
  const FilmGrid& g = scene.grid;
  const fluid::SupplyMap& supply = scene.supply;
  Outflows out(scene, film);
  const auto look = [&](int before, int after, Side low, Side high, double pressed, double net,
                        double width) {
    const int from = supply.cell[before], into = supply.cell[after];
    if (from >= 0 && into < 0) out.add(from, high, after, pressed, net, width);
    if (into >= 0 && from < 0) out.add(into, low, before, -pressed, -net, width);
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int west = g.index((i + g.nt - 1) % g.nt, j), k = g.index(i, j);
      const fluid::FaceFlow& f = film.flow.phi[k];
      if (supply.line[k] >= 0) {
        out.add(supply.line[k], downstream, k, f.m - f.carried, f.m, g.dz[j]);
      } else {
        look(west, k, upstream, downstream, f.m - f.carried, f.m, g.dz[j]);
      }
      if (j == 0) continue;
      const double m = film.flow.z[i * (g.nz + 1) + j].m;
      look(g.index(i, j - 1), k, low_z, high_z, m, m, g.radius * g.dphi[i]);
    }
  }
  for (const fluid::LineFace& l : film.flow.lines) {
    const int j = l.face % g.nz, west = g.index((l.face / g.nz + g.nt - 1) % g.nt, j);
    out.add(l.patch, upstream, west, l.west.carried - l.west.m, -l.west.m, g.dz[j]);
  }
  return out.worst();
}

void add_fed_flow(const note::FedFlow& flow, std::vector<Note>& notes) {
  if (flow.part > kHeadThatCounts || flow.reynolds > kTurbulentFlow) notes.push_back(flow);
}

}  // namespace shellback::bearing
