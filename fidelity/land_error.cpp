#include "fidelity/land_error.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/bearing.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

namespace {

constexpr double kPad = 20.0;        // (1)
constexpr double kSide = 0.1;        // (2)
constexpr double kHole = 0.2;        // (3)
constexpr double kPast = 0.1;        // (4)
constexpr double kPastHeat = 0.04;   // (4)
constexpr double kPastFilm = 0.012;  // (4)

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

bool is_flow(std::string_view name) {
  return name == "side_flow" || name == "supply_flow" || name == "pump_power";
}
bool is_friction(std::string_view name) {
  return name.starts_with("friction_") || name == "power_loss";
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

int cells_of_side_lands(const FilmGrid& g, const fluid::SupplyMap& supply) {
  int least = 0;
  const auto meet = [&](int m) {
    if (m > 0) least = least == 0 ? m : std::min(least, m);
  };
  for (int i = 0; i < g.nt; ++i) {
    meet(cells_to_supply(g, supply, i, g.nz - 1, -1));
    if (!g.half) meet(cells_to_supply(g, supply, i, 0, 1));
  }
  return least;
}

int rows_of_holes(const FilmGrid& g, const fluid::SupplyMap& supply) {
  int least = 0;
  for (std::size_t k = 0; k < supply.patches.size(); ++k) {
    if (!supply.patches[k].round || supply.patches[k].moving) continue;
    const int rows = rows_of(g, supply, static_cast<int>(k));
    if (rows > 0) least = least == 0 ? rows : std::min(least, rows);
  }
  return least;
}

}  // namespace

LandError land_error(const FilmGrid& g, const fluid::SupplyMap& supply) {
  LandError out;
  if (const int rows = rows_of_holes(g, supply); rows > 0) out.holes = kHole / (rows * rows);
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

CellsOfSupplies cells_of_supplies(const FilmGrid& g, const fluid::SupplyMap& supply) {
  return {cells_of_side_lands(g, supply), rows_of_holes(g, supply)};
}

CellsOfSupplies cells_of_supplies(const bearing::Case& c, const std::array<int, 2>& cells) {
  return cells_of_supplies(bearing::film_grid(c, cells), bearing::supply_map(c, cells));
}

std::array<int, 2> with_lands_cut(const bearing::Case& c, std::array<int, 2> cells, int most) {
  constexpr int kCut = 3;
  for (std::array<int, 2> finer = cells; finer[1] <= most; ++finer[1]) {
    const int lands = cells_of_supplies(c, finer).lands;
    if (lands == 0 || lands >= kCut) return finer;
  }
  return cells;
}

double open_past_lands(int m, bool heated, bool torn, const std::string& name) {
  if (m == 0) return 0.0;
  const bool of_heat = heated && (is_friction(name) || is_of_heat(name));
  const double part = is_flow(name)               ? kPast
                      : of_heat                   ? kPastHeat
                      : is_friction(name) && torn ? kPastFilm
                                                  : 0.0;
  return part / std::pow(m, 1.5);
}

double open_by_lands(const LandError& lands, std::string_view name) {
  return std::max(
      {lands.pads, is_friction(name) ? lands.sides : 0.0, is_flow(name) ? lands.holes : 0.0});
}

}  // namespace shellback::fidelity
