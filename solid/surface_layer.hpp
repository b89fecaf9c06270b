#pragma once
/// Elasto-plastic surface layer: a soft coating, column by column.
///
/// Under the total pressure P the layer gives way by r = r_e + r_p, an elastic and a plastic part:
///   p(r_e) = c r_e,   c = E/s (1 + r_e/(s - r_e))^N                              [Pa]  (1)
///   delta c dr_e/dt = P - c r_e,  dr_p/dt = 0     while c r_e < p_plast                (2)
///   delta c dr_p/dt = P - p_plast, dr_e/dt = 0    while c r_e = p_plast and P > p_plast (3)
/// s: thickness, E: Young's modulus, N: progression rate (0: linear), p_plast: hardness, delta: the
/// ratio of damping to stiffness. A layer is not pulled: P < 0 counts as 0. Over a stage of length
/// `own` from r_e*, r_p* backward Euler gives, with lambda = delta/own,
///   c ((1 + lambda) r_e - lambda r_e*) = P,  r_p = r_p*       if that leaves c r_e <= p_plast  (4)
///   r_e = r_y,  r_p = r_p* + own (P - p_plast)/(delta c_y) - (r_y - r_e*)   otherwise (5)
/// where c_y r_y = p_plast. (5) continues (4) without a jump, r_p never falls, and what P does on
/// the layer is never less than what it stores. Valid for layers thin against the width of what
/// presses upon them; shear within the layer, and what flows out beside the contact, are left out.
/// Source: seed 001 Eq. 6-12, there with explicit steps; implicit after methods 2.5.

namespace shellback::solid {

struct SurfaceLayer {
  double thickness = 0.0;       ///< s [m]
  double youngs_modulus = 0.0;  ///< E [Pa]
  double hardness = 0.0;        ///< p_plast [Pa]
  double progression = 0.0;     ///< N [-]
  double damping_ratio = 0.0;   ///< delta [s]

  /// c of (1) [Pa/m]; r_e below s.
  [[nodiscard]] double stiffness(double elastic) const;
  /// r_y of (5) [m].
  [[nodiscard]] double yield_depth() const;
};

/// A column of the layer at an instant.
struct LayerColumn {
  double elastic = 0.0;  ///< r_e [m]
  double plastic = 0.0;  ///< r_p [m]
  [[nodiscard]] double sum() const { return elastic + plastic; }
};

/// A column at the end of a stage.
struct PressedColumn {
  LayerColumn now;
  double by_pressure = 0.0;  ///< d(r_e + r_p)/dP [m/Pa], not negative
};

/// (4) and (5) from `before` under P [Pa] over `own` [s]; all positive but P. P that is not a
/// number gives no number.
[[nodiscard]] PressedColumn press(const SurfaceLayer& layer, double P, double own,
                                  const LayerColumn& before);

/// Power that a column turns into heat, P dr/dt - c r_e dr_e/dt, at rates [m/s] of its parts; not
/// negative [W/m2].
[[nodiscard]] double layer_loss(const SurfaceLayer& layer, double P, const LayerColumn& now,
                                const LayerColumn& rate);

}  // namespace shellback::solid
