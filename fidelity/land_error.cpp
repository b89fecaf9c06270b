#include "fidelity/land_error.hpp"

#include <algorithm>

#include "bearing/bearing.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"

namespace shellback::fidelity {

namespace {

constexpr double kPad = 20.0;  // (1)
constexpr double kSide = 0.1;  // (2)
constexpr double kHole = 0.2;  // (3)

struct Land {
  int cells = 0;
  double arc = 0.0;  ///< [rad]
};

/// The longest run of film around in line j.
Land widest_land(const FilmGrid& g, const fluid::SupplyMap& supply, int j) {
  Land widest, run;
  for (int k = 0; k < 2 * g.nt; ++k) {  // twice round: a land may lie across phi = 0
    const int i = k % g.nt;
    run = supply.cell[g.index(i, j)] < 0 ? Land{run.cells + 1, run.arc + g.dphi[i]} : Land{};
    if (run.arc > widest.arc) widest = run;
  }
  return widest;
}

/// True if line j has film on less than half a turn.
bool is_mostly_supply(const FilmGrid& g, const fluid::SupplyMap& supply, int j) {
  double film = 0.0;
  for (int i = 0; i < g.nt; ++i) film += supply.cell[g.index(i, j)] < 0 ? g.dphi[i] : 0.0;
  return film > 0.0 && film < kPi * (1.0 - kRoundOff);
}

/// Cells from the side edge at the line `edge`, inwards, to the first of a supply; none: 0.
int cells_to_supply(const FilmGrid& g, const fluid::SupplyMap& supply, int i, int edge,
                    int inwards) {
  for (int n = 0; n < g.nz; ++n) {
    if (supply.cell[g.index(i, edge + n * inwards)] >= 0) return n;
  }
  return 0;
}

/// Rows of cells along the bearing that patch k takes.
int rows_of(const FilmGrid& g, const fluid::SupplyMap& supply, int k) {
  int rows = 0;
  bool in_middle = false;
  for (int j = 0; j < g.nz; ++j) {
    bool takes = false;
    for (int i = 0; i < g.nt && !takes; ++i) takes = supply.cell[g.index(i, j)] == k;
    rows += takes ? 1 : 0;
    in_middle = in_middle || (j == 0 && takes);
  }
  if (!g.half || !in_middle) return rows;
  return g.z[0] == 0.0 ? 2 * rows - 1 : 2 * rows;
}

}  // namespace

LandError land_error(const FilmGrid& g, const fluid::SupplyMap& supply) {
  LandError out;
  for (std::size_t k = 0; k < supply.patches.size(); ++k) {
    if (!supply.patches[k].round || supply.patches[k].moving) continue;
    const int rows = rows_of(g, supply, static_cast<int>(k));
    if (rows > 0) out.holes = std::max(out.holes, kHole / (rows * rows));
  }
  const double width = g.z_face.back() - g.z_face.front();
  for (int j = 0; j < g.nz; ++j) {
    if (!is_mostly_supply(g, supply, j)) continue;
    const int n = widest_land(g, supply, j).cells;
    out.pads += g.dz[j] / width * kPad / (n * n);
  }
  if (out.pads == 0.0) return out;
  double film = 0.0;
  for (int c = 0; c < g.cells(); ++c) film += supply.cell[c] < 0 ? g.area(c) : 0.0;
  for (int i = 0; i < g.nt && film > 0.0; ++i) {
    for (const bool low : {true, false}) {
      if (low && g.half) continue;
      const int edge = low ? 0 : g.nz - 1;
      const int inwards = low ? 1 : -1;
      const int m = cells_to_supply(g, supply, i, edge, inwards);
      for (int n = 0; n < m; ++n) out.sides += kSide / m * g.area(i, edge + n * inwards) / film;
    }
  }
  return out;
}

LandError land_error(const bearing::Case& c) {
  return land_error(bearing::film_grid(c, c.model.grid), bearing::supply_map(c, c.model.grid));
}

double open_by_lands(const LandError& lands, std::string_view name) {
  const bool friction = name.starts_with("friction_") || name == "power_loss";
  const bool flow = name == "side_flow" || name == "supply_flow" || name == "pump_power";
  return std::max({lands.pads, friction ? lands.sides : 0.0, flow ? lands.holes : 0.0});
}

}  // namespace shellback::fidelity
