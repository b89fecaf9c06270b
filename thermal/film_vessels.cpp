/// Supplies of the film as mixing vessels: (2) and (6) of thermal/film_energy.hpp.
#include <algorithm>
#include <cmath>

#include "core/round_off.hpp"
#include "thermal/film_energy.hpp"

namespace shellback::thermal {

std::vector<FilmEnergy::VesselFlow> FilmEnergy::vessel_flows(const std::vector<double>& T) const {
  std::vector<VesselFlow> flows(p_.vessels.size());
  for (const int cell : shore_) {
    Inflow faces[4];
    const int count = faces_of(cell / p_.grid->nz, cell % p_.grid->nz, faces);
    for (int f = 0; f < count; ++f) {
      if (faces[f].source >= 0 || faces[f].source == kEdge) continue;
      VesselFlow& v = flows[-1 - faces[f].source];
      for (int k = 0; k < n_; ++k) {
        const double in = p_.gl->w[k] * faces[f].sign * faces[f].flow[k];
        if (in > 0.0) {
          v.out += in;
        } else {
          const std::size_t at = static_cast<std::size_t>(cell) * n_ + k;
          v.in -= in;
          v.in_heat -= in * p_.cp[at] * (T[at] - p_.T_reference);
        }
      }
    }
  }
  add_flows_over_edges(T, flows);
  return flows;
}

void FilmEnergy::add_flows_over_edges(const std::vector<double>& T,
                                      std::vector<VesselFlow>& flows) const {
  for (const int cell : brink_) {
    VesselFlow& v = flows[p_.patch[cell]];
    Inflow faces[4];
    const int count = faces_of(cell / p_.grid->nz, cell % p_.grid->nz, faces);
    for (int f = 0; f < count; ++f) {
      if (faces[f].source != kEdge) continue;
      for (int k = 0; k < n_; ++k) {
        const double in = p_.gl->w[k] * faces[f].sign * faces[f].flow[k];
        if (in > 0.0) {
          const double heat = in * source_enthalpy(faces[f], k, T);
          v.in += in;
          v.in_heat += heat;
          v.edge_heat += heat;
        } else {
          v.out -= in;
          v.over_edge -= in;
        }
      }
    }
  }
}

double FilmEnergy::vessel_transfer(int cell) const {
  const int patch = p_.patch[cell];
  return patch < 0 ? 0.0 : p_.vessels[patch].heat_transfer;
}

FilmEnergy::VesselWalls FilmEnergy::vessel_walls(int cell, const std::vector<double>& T) const {
  const FilmGrid& g = *p_.grid;
  const std::size_t at = static_cast<std::size_t>(cell) * n_;
  const double h = vessel_transfer(cell), hA = h * g.area(cell);
  VesselWalls w{hA, hA, T[at] - p_.T_reference, T[at + n_ - 1] - p_.T_reference};
  if (!p_.shell) return w;
  const YieldingShell& shell = *p_.shell;  // (5) with q = h (T_mix - T_shell)
  w.shell = hA / (1.0 + h * shell.impedance);
  w.T_shell = shell.free[cell] + shell.impedance * shell.rubbed[cell] - p_.T_reference;
  return w;
}

void FilmEnergy::fill_vessels(std::vector<double>& T) const {
  for (int c = 0; c < p_.grid->cells(); ++c) {
    if (p_.patch[c] < 0) continue;
    const double mixed = T_mix_[p_.patch[c]];
    double* node = &T[static_cast<std::size_t>(c) * n_];
    if (!(vessel_transfer(c) > 0.0)) {
      std::fill_n(node, n_, mixed);
      continue;
    }
    if (p_.shell) {
      const VesselWalls w = vessel_walls(c, T);
      const double part = p_.shell->impedance / p_.grid->area(c / p_.grid->nz, c % p_.grid->nz);
      node[0] = p_.T_reference + w.T_shell + part * w.shell * (mixed - p_.T_reference - w.T_shell);
    }
    std::fill_n(node + 1, n_ - 2, mixed);
  }
}

void FilmEnergy::mix(std::vector<double>& T) {
  const auto flows = vessel_flows(T);
  std::vector<double> by_walls(flows.size(), 0.0), of_walls(flows.size(), 0.0);  // [W/K], [W]
  for (int c = 0; c < p_.grid->cells(); ++c) {
    if (!(vessel_transfer(c) > 0.0)) continue;
    const VesselWalls w = vessel_walls(c, T);
    by_walls[p_.patch[c]] += w.shell + w.shaft;
    of_walls[p_.patch[c]] += w.shell * w.T_shell + w.shaft * w.T_shaft;
  }
  for (std::size_t v = 0; v < flows.size(); ++v) {
    const SupplyVessel& s = p_.vessels[v];
    const double returned = s.carry_over * flows[v].in;
    const double fresh = flows[v].out - returned;
    double brought = s.carry_over * flows[v].in_heat + of_walls[v];
    if (fresh > 0.0) brought += fresh * s.cp_supply * (s.T_supply - p_.T_reference);
    const double taken = std::max(flows[v].out, returned) * s.cp_mix + by_walls[v];
    T_mix_[v] = taken > 0.0 ? mixed(s, brought, taken) : s.T_supply;
  }
  fill_vessels(T);
}

double FilmEnergy::mixed(const SupplyVessel& s, double brought, double taken) const {
  const auto without = [&](double heat) { return p_.T_reference + (brought + heat) / taken; };
  if (!(s.thinning > 0.0)) return without(s.heat);
  // What T takes less what it makes rises with T, bent downwards: from the cold side Newton's steps
  // stay there.
  double T = without(s.heat - s.sheared);
  for (int k = 0; k < kMostIterations; ++k) {
    const double made = s.heat_at(T);
    const double slope = taken + s.thinning * (made - s.heat + s.sheared);
    const double more = (brought + made - taken * (T - p_.T_reference)) / slope;
    T += more;
    if (!(std::abs(more) > kRoundOff)) break;
  }
  return T;
}

double FilmEnergy::heat_of_thinning() const {
  double more = 0.0;
  for (std::size_t v = 0; v < T_mix_.size(); ++v) {
    more += p_.vessels[v].heat_at(T_mix_[v]) - p_.vessels[v].heat;
  }
  return more;
}

}  // namespace shellback::thermal
