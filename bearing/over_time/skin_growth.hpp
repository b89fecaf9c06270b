#pragma once
/// What the skins of shell and shaft do to the gap as they warm.
///
/// A skin of the bore, thin against radius and wall, that is warmer by T(y) cos(n phi) grows in
/// thickness by S = int (1 + nu)/(1 - nu) alpha T dy, as if the body held it in its plane, and
/// pushes along the surface with N = int E alpha/(1 - nu) T dy. The body gives way to that: with
/// P = N/E_b, E_b and nu_b its own, the surface comes into the gap by
///   u_n = S + (1 - 2 nu_b)(1 + nu_b) P,   n > 1                                           (1)
///   u_1 = S - (1 + nu_b)/2 P                                                              (2)
///   u_0 = S - (1 + nu_b) P - 2 a^2/(b^2 - a^2) int w E/E_b alpha T dy                     (3)
/// of one material 2 (1 + nu) alpha int T dy, a quarter of that over 1 - nu, and nothing but what a
/// ring of the radii a and b widens by. Derivation: Goodier's potential of the skin, whose
/// tractions 2 G S/a (cos n phi, n sin n phi) on the bore are taken off by the stress functions
/// r^-n and r^(2-n) of an infinite plane (Airy, textbook); plane strain, (3) of a ring of free
/// ends. The surface of a shaft, a ring of one temperature, grows by
///   u = 2 int w alpha T dy                                                                (4)
/// A clamped housing counts as endless in (3). Valid while heat has gone less deep than the wall is
/// thick; thin shells bend otherwise.
#include <vector>

#include "bearing/bearing.hpp"
#include "thermal/wall_skin.hpp"

namespace shellback::bearing {

/// Layers of the shell for a skin: `back` is the material that the others lie on.
[[nodiscard]] thermal::SkinLayer skin_of_shell(const solid::Material& m, double thickness,
                                               const solid::Material& back);
/// The shaft to its axis.
[[nodiscard]] thermal::SkinLayer skin_of_shaft(const solid::Material& m, double radius);

/// (1) to (3), cell by cell, from the skins' growth [m]. The case has a shell.
[[nodiscard]] Field narrowed_by_shell(const BearingModel& model,
                                      const std::vector<thermal::SkinGrowth>& skins);
/// (4) [m].
[[nodiscard]] double narrowed_by_shaft(const thermal::SkinGrowth& skin);

}  // namespace shellback::bearing
