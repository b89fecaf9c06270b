#pragma once
/// The journal's motion under a load cycle by Booker's mobility method.
///
///   de/dt = c |F| psi^2/(eta B D) M(eps, alpha; B/D) + omega/2 x e   [m/s]                (1)
///   F = W(t) - F_contact e/|e|                                       [N]                  (2)
///
/// The film carries F, what the asperities leave of the load W; M is that of mobility_table.hpp,
/// the viscosity eta that of estimate_scene.hpp at one temperature, which the caller sets. The
/// shell stands still; the oil goes round with omega/2, the mean of the two surfaces. The journal
/// has no mass: where no load acts it goes round with the oil. Frame and signs:
/// bearing/over_time/cycle.hpp.
#include "bearing/over_time/cycle.hpp"
#include "core/smooth_motion.hpp"
#include "fidelity/bearing_table.hpp"
#include "fidelity/estimate_scene.hpp"
#include "fidelity/mobility_table.hpp"

namespace shellback::fidelity {

class MobilityMotion {
 public:
  /// Case and course must outlive the motion.
  MobilityMotion(const bearing::Case& c, const bearing::LoadCourse& course);

  void set_temperature(double T) { T_ = T; }  ///< [K]
  [[nodiscard]] const EstimateScene& scene() const { return scene_; }

  /// (1) over the clearance [1/s] at x = e/c; false where |x| is no eccentricity. At a jump of the
  /// load what holds behind it, or before it.
  [[nodiscard]] bool rate(double t, bool before_jump, const Pair& x, Pair& out) const;
  /// All that the mobility tells of the bearing there; what it does not tell is not a number.
  [[nodiscard]] bearing::CycleInstant instant(double t, bool before_jump, const Pair& x) const;
  /// Share of the load that the asperities carry there [-].
  [[nodiscard]] double asperity_share(double t, bool before_jump, const Pair& x) const;

 private:
  /// Place, load and what follows from them.
  struct Now {
    bearing::LoadNow load;
    double eps = 0.0;
    double eta = 0.0;  ///< [Pa s]
    Pair film{};       ///< F [N]
    Mobility m;
    Pair seen{};  ///< velocity over the clearance as the oil sees it [1/s]
  };
  [[nodiscard]] Now look(double t, bool before_jump, const Pair& x) const;
  /// Friction, with the asperities' part and their pressure.
  void add_torque(const Now& now, bearing::CycleInstant& i) const;

  const bearing::Case& c_;
  const bearing::LoadCourse& course_;
  EstimateScene scene_;
  MobilityMap map_;
  BearingCurve curve_;
  bool drilled_ = false;  ///< some oil comes through the journal
  double T_ = 0.0;
};

}  // namespace shellback::fidelity
