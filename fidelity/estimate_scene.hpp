#pragma once
/// What the estimate makes of a case: lands, one viscosity, Greenwood-Tripp contact on a circle.
///
/// Rigid circular bearing, aligned. A groove all round makes two bearings of half the width. The
/// film is as viscous everywhere as at its temperature, the specific load and the mean shear rate
/// omega R/(c sqrt(1 - eps^2)). Signs: omega without one; torques oppose the motion.
#include <optional>
#include <vector>

#include "bearing/case.hpp"
#include "fidelity/lumped_heat.hpp"
#include "rheology/oil.hpp"
#include "solid/asperity_contact.hpp"

namespace shellback::fidelity {

/// Asperities on the nominal film h = c (1 - eps cos phi).
struct ContactSum {
  double load = 0.0;      ///< towards the widest gap [N]
  double torque = 0.0;    ///< [N m]
  double pressure = 0.0;  ///< largest [Pa]
};

class EstimateScene {
 public:
  /// `c` must outlive the scene.
  explicit EstimateScene(const bearing::Case& c);

  /// Width over diameter of one land [-].
  [[nodiscard]] double b() const { return land_ / (2.0 * c_.bearing.radius); }
  /// Of all lands [m].
  [[nodiscard]] double width() const { return width_; }
  /// D times that [m2].
  [[nodiscard]] double area() const { return 2.0 * c_.bearing.radius * width_; }
  /// Clearance over radius [-].
  [[nodiscard]] double psi() const { return c_.bearing.radial_clearance / c_.bearing.radius; }
  /// A groove all round feeds the lands: what leaves them is what its pressure drives through, on
  /// the mean around whatever the film's own pressure is, since that takes back at the ring what it
  /// presses out there (the axial flow around an aligned land does not depend on z).
  [[nodiscard]] bool has_ring() const;
  /// Rough surfaces that carry.
  [[nodiscard]] bool touches() const { return contact_.has_value(); }

  /// [Pa s]; eps in [0, 1), T [K], load [N].
  [[nodiscard]] double viscosity(double eps, double T, double load, double omega) const;
  /// Zero without contact data.
  [[nodiscard]] ContactSum contact(double eps, double eta, double omega) const;
  /// Its load alone [N]: what a motion asks for at every step.
  [[nodiscard]] double contact_load(double eps) const;
  /// Couette part of the torque [N m]: 2 pi eta omega R^3 B/(c sqrt(1 - eps^2)), with the rule
  /// `filled` times `fill`, the part of the shear that full film feels [-].
  [[nodiscard]] double couette(double eps, double fill, double eta, double omega) const;
  /// Heat that leaves with `side_flow` [m3/s] at T and through the paths [W].
  [[nodiscard]] double heat_away(double T, double side_flow,
                                 const std::vector<HeatPath>& paths) const;

 private:
  const bearing::Case& c_;
  rheology::Oil oil_;  ///< without the effects that are switched off
  double land_ = 0.0;  ///< width of one land [m]
  double width_ = 0.0;
  std::optional<solid::AsperityContact> contact_;
};

/// The paths of the heat through the solids, and between what temperatures the film's is sought.
struct HeatWays {
  std::vector<HeatPath> paths;
  double coldest = 0.0;  ///< of supply and surroundings that cool [K]
  double warmest = 0.0;  ///< of supply and surroundings [K]
};
[[nodiscard]] HeatWays heat_ways(const bearing::Case& c);

}  // namespace shellback::fidelity
