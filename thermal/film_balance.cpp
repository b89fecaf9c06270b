/// What a film temperature field adds up to: responses to the walls, and the balance of heat.
#include <algorithm>
#include <array>

#include "thermal/film_energy.hpp"

namespace shellback::thermal {

WallResponse FilmEnergy::wall_response(int laps) const {
  const FilmGrid& g = *p_.grid;
  FilmEnergy film = *this;  // the same flow without any heat of its own
  const double cold = p_.T_reference;
  std::fill(film.p_.heat.begin(), film.p_.heat.end(), 0.0);
  std::fill(film.brought_.begin(), film.brought_.end(), 0.0);
  std::fill(film.base_.begin(), film.base_.end(), 0.0);
  for (SupplyVessel& v : film.p_.vessels) {
    v.T_supply = cold;
    v.heat = v.sheared = 0.0;
  }
  film.p_.T_edge = cold;
  // Mean heat into both walls per kelvin of one wall.
  const auto per_kelvin = [&](int wall_node) {
    std::vector<double> T(film.p_.heat.size(), cold);
    std::fill(film.T_mix_.begin(), film.T_mix_.end(), cold);
    for (int c = 0; c < g.cells(); ++c) T[static_cast<std::size_t>(c) * n_ + wall_node] += 1.0;
    for (int k = 0; k < laps; ++k) film.sweep(T);
    const WallHeat q = film.wall_heat(T);
    std::array<double, 2> sum{};
    double area = 0.0;
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int c = g.index(i, j);
        if (p_.patch[c] >= 0 && !(vessel_transfer(c) > 0.0)) continue;
        sum[0] += q.shell[c];
        sum[1] += q.shaft[c];
        area += g.area(i, j);
      }
    }
    return std::array<double, 2>{sum[0] / area, sum[1] / area};
  };
  const auto by_shell = per_kelvin(0);
  const auto by_shaft = per_kelvin(n_ - 1);
  return {-by_shell[0],
          -by_shaft[1],
          by_shaft[0],
          by_shell[1],
          shell_local_,
          *std::max_element(shell_ring_.begin(), shell_ring_.end()),
          *std::max_element(shaft_ring_.begin(), shaft_ring_.end())};
}

EnergyBalance FilmEnergy::balance(const std::vector<double>& T) const {
  const FilmGrid& g = *p_.grid;
  EnergyBalance b;
  const WallHeat q = wall_heat(T);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int cell = g.index(i, j);
      b.to_shell += q.shell[cell];
      b.to_shaft += q.shaft[cell];
      if (p_.patch[cell] >= 0) continue;
      for (int k = 0; k < n_; ++k) {
        const std::size_t at = static_cast<std::size_t>(cell) * n_ + k;
        b.heat += p_.heat[at];
        if (!p_.thinning.empty()) b.heat -= p_.thinning[at] * (T[at] - p_.T_reference);
        if (!p_.storage) continue;
        const double after = p_.storage->mass[cell] * p_.cp[at] * (T[at] - p_.T_reference);
        b.stored += p_.gl->w[k] * after / p_.storage->dt - brought_[at];
      }
      Inflow faces[4];
      const int count = faces_of(i, j, faces);
      for (int f = 0; f < count; ++f) {
        if (faces[f].source != kEdge) continue;
        for (int k = 0; k < n_; ++k) {
          const double in = p_.gl->w[k] * faces[f].sign * faces[f].flow[k];
          const std::size_t at = static_cast<std::size_t>(cell) * n_ + k;
          if (in > 0.0) {
            b.carried_in += in * source_enthalpy(faces[f], k, T);
          } else {
            b.carried_out -= in * p_.cp[at] * (T[at] - p_.T_reference);
          }
        }
      }
    }
  }
  b.heat -= fed_heat_;
  b.carried_in += fed_heat_;
  for (const FedOil& f : p_.fed) {
    for (int k = 0; k < n_ && f.flow < 0.0; ++k) {
      const std::size_t at = static_cast<std::size_t>(f.cell) * n_ + k;
      b.carried_out -= p_.gl->w[k] * f.flow * p_.cp[at] * (T[at] - p_.T_reference);
    }
  }
  b.heat += p_.throttled;
  b.carried_out += p_.throttled;
  const auto flows = vessel_flows(T);
  for (std::size_t v = 0; v < flows.size(); ++v) {
    const SupplyVessel& s = p_.vessels[v];
    const double fresh = flows[v].out - s.carry_over * flows[v].in;
    b.heat += s.heat_at(T_mix_[v]);
    b.carried_in += flows[v].edge_heat;
    b.carried_out += flows[v].over_edge * s.cp_mix * (T_mix_[v] - p_.T_reference);
    b.carried_out += (1.0 - s.carry_over) * flows[v].in_heat;
    if (fresh > 0.0) {
      b.carried_in += fresh * s.cp_supply * (s.T_supply - p_.T_reference);
    } else {
      b.carried_out -= fresh * s.cp_mix * (T_mix_[v] - p_.T_reference);
    }
  }
  return b;
}

}  // namespace shellback::thermal
