#pragma once
/// The layered ring whose displacements a finite-element program recomputes.
///
/// A soft layer on the bore of a steel ring (2 mm shell and housing, one material), half of the
/// width (z = 0 is a plane of symmetry), end faces free. Two kinds of load:
///
///   pressure  p = p0 cos^8(2 phi) for |z| < 0.6 B/2, else 0: four equal patches around the bore,
///             harmonics 0, 4, .. 16; the sector 0 .. 45 degrees has two planes of symmetry
///   heat      T = T0, and T = T0 (1 + cos phi)/2 (1 - (r - a)/(2 (b - a))) (1 - (2 z/B)^2/2):
///             harmonics 0 and 1; half a ring
///
/// with a the bore radius and b that of the outer surface.
#include <iosfwd>

#include "validation/calculix/brick_mesh.hpp"

namespace shellback::calculix {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double kBore = 23.9e-3;      ///< radius a [m]
inline constexpr double kOuter = 47.8e-3;     ///< radius b [m]
inline constexpr double kWidth = 17.2e-3;     ///< B [m]
inline constexpr double kPatchEnd = 5.16e-3;  ///< 0.6 B/2: an edge of 20 and of 25 film cells [m]
inline constexpr double kPressure = 10e6;     ///< p0 [Pa]
inline constexpr double kHeating = 50.0;      ///< T0 [K]

struct Elastic {
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
  double expansion;       ///< [1/K]
};
inline constexpr Elastic kSteel{210e9, 0.3, 11e-6};
inline constexpr double kLayerModulus = 2e9;      ///< [Pa]
inline constexpr double kLayerExpansion = 60e-6;  ///< [1/K]

enum class Load { pressure, heat };

struct Ring {
  double thickness = 0.0;      ///< of the layer [m]
  double poisson_ratio = 0.0;  ///< of the layer [-]
  Load load = Load::pressure;
  bool fine = false;     ///< mesh
  bool reduced = false;  ///< C3D20R in place of C3D20
};

[[nodiscard]] double sector(Load load);                            ///< [rad]
[[nodiscard]] double patch(double phi, double z);                  ///< [Pa]
[[nodiscard]] double uneven_heat(double r, double phi, double z);  ///< [K]

/// Corner lines of the mesh: finest across the layer and along z at the edge of the patch and the
/// end face, where the displacement of the layer changes over its thickness.
[[nodiscard]] Lines mesh_lines(const Ring& ring);
/// Radial bricks of the layer.
[[nodiscard]] int layer_bricks(const Ring& ring);

/// Input deck of CalculiX (units m, N, K) on standard output.
void write_deck(const Ring& ring);

/// Reads what CalculiX printed for that deck and writes rows of expected.csv.
void write_rows(const Ring& ring, std::istream& answer);

}  // namespace shellback::calculix
