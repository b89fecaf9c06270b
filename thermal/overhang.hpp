#pragma once
/// One end of the shaft beyond the bearing, eliminated from its tip: (2)-(4) of thermal/shaft_fin.
///
///   heat that leaves the end cell = conductance (T - T_ambient) - returned                  (1)
///
/// With a_i the heat lost and stored at node i per kelvin and b_i what its temperature before gives
/// back, the tip draws link (a T - b) / (link + a) from its neighbour, to whose a and b this is
/// added, and so on to the bearing's edge: nothing is subtracted, all digits stay [textbook:
/// Thomas' algorithm].
#include <vector>

namespace shellback::thermal {

struct ShaftFin {
  double conductivity = 0.0;   ///< k [W/(m K)]
  double overhang = 0.0;       ///< L, length beyond the bearing on each side [m]
  double heat_transfer = 0.0;  ///< h of the overhang's surface [W/(m2 K)]
  double ambient = 0.0;        ///< temperature around the overhang [K]
  double capacity = 0.0;       ///< rho c [J/(m3 K)]; for time steps
  int spaces = 16;             ///< between the nodes of an overhang [-]; second order, time only
};

/// Nodes of an overhang, edge and tip included; 0 without length.
[[nodiscard]] int overhang_nodes(const ShaftFin& shaft);

struct OverhangHeat {
  std::vector<double> temperature;  ///< of the nodes [K]
  double lost = 0.0;                ///< to the ambient [W]
  double stored = 0.0;              ///< mean over the time step [W]
};

class Overhang {
 public:
  /// No overhang: insulated.
  Overhang() = default;
  /// `to_edge` [m]: from the centre of the end cell to the bearing's edge. `before` [K]: of the
  /// nodes, for finite dt [s].
  Overhang(double radius, const ShaftFin& shaft, double to_edge, double dt,
           const std::vector<double>& before);

  [[nodiscard]] double conductance() const { return conductance_; }  ///< [W/K]
  [[nodiscard]] double returned() const { return returned_; }        ///< [W]
  /// Temperatures and heat for an end cell that is `rise` [K] above ambient.
  [[nodiscard]] OverhangHeat solve(double rise) const;

 private:
  struct Node {
    double link = 0.0;    ///< to the node before it, nearer to the bearing [W/K]
    double loss = 0.0;    ///< [W/K]
    double store = 0.0;   ///< [W/K]
    double before = 0.0;  ///< rise before the step [K]
    double a = 0.0;       ///< loss and store of all from here to the tip, as seen here [W/K]
    double b = 0.0;       ///< [W]
  };
  std::vector<Node> nodes_;
  double ambient_ = 0.0;
  double conductance_ = 0.0;
  double returned_ = 0.0;
};

}  // namespace shellback::thermal
