#pragma once
/// The oil across the film: viscosity at every node and the Dowson integrals of every column.
///
/// With the fluidity f = 1/eta at the Gauss-Lobatto nodes s = y/h of a column:
///   g0 = int f ds = F0/h,  centre = int s f ds / g0 = F1/(h F0),
///   g  = int f (s - centre)^2 ds = F2/h^3                                             (1)
/// Shear stress across the film (methods 3.1):
///   tau_x = dp/dx h (s - centre) + U/(h g0),   tau_z = dp/dz h (s - centre)           (2)
/// The viscosity at a node is that at its T, p and shear rate; for shear-thinning oil (1), (2) and
///   eta = eta(T, p) f(|tau|/eta)                                                      (3)
/// are solved together to the tolerance asked for, by Newton's method in ln eta. A column's nodes
/// meet in two numbers alone, the drag U/(h g0) and the centre. With a = (1 - m)^-1 of the slope
/// m = -d ln f/d ln rate, phi = f_k/g0 (times its weight) and r = eta(T, p) f/eta - 1,
///   d ln eta = a (r - m d ln tau),   d ln tau = (tau_x U/(h g0) D - h (tau . dp) C)/tau^2,
///   D = sum phi d ln eta,   C = -sum phi (s - centre) d ln eta                        (4)
/// is a system of two unknowns D and C, the changes of ln drag and centre. A step that would take
/// nine tenths of a viscosity goes to eta(T, p) f instead.
#include <vector>

#include "core/gauss_lobatto.hpp"
#include "fluid/film_flux.hpp"
#include "rheology/oil.hpp"

namespace shellback::bearing {

struct OilColumns {
  std::vector<double> T;    ///< node temperatures, index cell * n + k [K]
  std::vector<double> eta;  ///< node viscosities; starting guess of the next call [Pa s]
  Field g0;                 ///< [1/(Pa s)]
  Field centre;             ///< [-]
  Field T_mean;             ///< mean across the film [K]
  double mismatch = 0.0;    ///< largest relative change in the last substitution [-]
};

/// Columns of one temperature everywhere.
[[nodiscard]] OilColumns uniform_columns(int cells, int nodes, double T);

/// Recomputes viscosities, integrals (1) and the film's coefficients for the present state.
/// `h` is the gap for shear [m] (positive), `gradient_*` the pressure gradients at cells [Pa/m].
/// Where `supply` is not negative oil is mixed and has one temperature, that of its inner nodes.
void update_columns(const rheology::Oil& oil, const CrossFilmNodes& gl, double speed,
                    const Field& h, const std::vector<int>& supply, const fluid::FilmState& state,
                    const Field& gradient_x, const Field& gradient_z, double tolerance,
                    OilColumns& columns, fluid::FilmCoefficients& coefficients);

/// Dissipation per volume of film, tau^2/eta at the nodes [W/m3], index cell * n + k.
[[nodiscard]] std::vector<double> dissipation(const CrossFilmNodes& gl, double speed,
                                              const Field& h, const Field& gradient_x,
                                              const Field& gradient_z, const OilColumns& columns);

/// Velocity profiles of unit mean at the nodes of every column: driven by the journal (Couette)
/// and by pressure (Poiseuille).
struct VelocityProfiles {
  std::vector<double> couette;     ///< [-], index cell * n + k
  std::vector<double> poiseuille;  ///< [-]
};
[[nodiscard]] VelocityProfiles velocity_profiles(const CrossFilmNodes& gl,
                                                 const OilColumns& columns);

}  // namespace shellback::bearing
