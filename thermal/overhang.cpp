#include "thermal/overhang.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::thermal {

int overhang_nodes(const ShaftFin& shaft) { return shaft.overhang > 0.0 ? shaft.spaces + 1 : 0; }

Overhang::Overhang(double radius, const ShaftFin& shaft, double to_edge, double dt,
                   const std::vector<double>& before)
    : nodes_(overhang_nodes(shaft)), ambient_(shaft.ambient) {
  if (nodes_.empty()) return;
  const bool steady = std::isinf(dt);
  EXPECTS(steady || before.size() == nodes_.size());
  const double A = kPi * radius * radius, kA = shaft.conductivity * A;
  const double m = std::sqrt(2.0 * shaft.heat_transfer / (shaft.conductivity * radius));
  const double d = shaft.overhang / shaft.spaces, x = m * d;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double sides = i == 0 || i + 1 == nodes_.size() ? 1.0 : 2.0;
    nodes_[i].link = kA / d * (x > 0.0 ? x / std::sinh(x) : 1.0);
    nodes_[i].loss = sides * kA * m * std::tanh(0.5 * x);
    if (steady) continue;
    nodes_[i].store = sides * 0.5 * d * shaft.capacity * A / dt;
    nodes_[i].before = before[i] - ambient_;
  }
  nodes_[0].link = kA / to_edge;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& n = nodes_[i];
    n.a += n.loss + n.store;
    n.b += n.store * n.before;
    const double part = n.link / (n.link + n.a);
    (i > 0 ? nodes_[i - 1].a : conductance_) += part * n.a;
    (i > 0 ? nodes_[i - 1].b : returned_) += part * n.b;
  }
}

OverhangHeat Overhang::solve(double rise) const {
  OverhangHeat out;
  double T = rise;
  for (const Node& n : nodes_) {
    T = (n.link * T + n.b) / (n.link + n.a);
    out.temperature.push_back(ambient_ + T);
    out.lost += n.loss * T;
    out.stored += n.store * (T - n.before);
  }
  return out;
}

}  // namespace shellback::thermal
