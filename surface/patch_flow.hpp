#pragma once
/// The film between a rough patch and a smooth wall: Reynolds' equation on the map.
///
/// Local gap h(x, y), 0 where the surfaces touch; both problems with unit viscosity:
///   pressure flow   div(h^3/12 grad P) = 0,                      mean of grad P = (1, 0)      (1)
///   sliding         div(h^3/12 grad p - h/2 e_x) = 0,            mean of grad p = 0           (2)
/// (2) is a rough wall at rest under a smooth one with unit speed along x.
///
/// Ends. patch: P and p given at both ends in x, no flow over the sides (as Patir and Cheng);
/// the same as a patch mirrored again and again. periodic: the patch repeats itself both ways.
///
/// Discretisation. Finite volumes, the gap even within a cell; the two halves on a face are in
/// series, for pressure flow and for sliding. Grooves across and along are exact then: the
/// harmonic and the arithmetic mean of h^3. A cell of no gap lets nothing through; where such
/// cells enclose others the pressure of the enclosed is held at one cell, which changes no flow.
/// Whether oil passes at all is found from the open cells' neighbours: where it does not, the
/// conductance is exactly zero, whatever the solution's round-off says.
/// (1) and (2) have one matrix and are adjoint: couette = pressure_shear to round-off, which is
/// h phi_fp = hT - sigma Phi_s of fluid/flow_factors.hpp (Onsager; momentum).
#include <vector>

namespace shellback::surface {

enum class PatchEnds { patch, periodic };

/// Gap per cell, index j * nx + i, in any unit of length; h > 0 or exactly 0 (contact).
struct PatchGap {
  int nx = 0, ny = 0;
  double dx = 1.0, dy = 1.0;  ///< in any unit of length
  std::vector<double> h;
};

/// Means over the patch, in the unit of h.
struct PatchMeans {
  double conductance = 0.0;       ///< <h^3 dP/dx> of (1): phi_x h^3; 0: closed
  double pressure_shear = 0.0;    ///< <h dP/dx> of (1): h phi_fp; 0: closed
  double couette = 0.0;           ///< 2 <flow> of (2): hT - sigma Phi_s
  double sliding_pressure = 0.0;  ///< <h/2 dp/dx> of (2): Phi_fs/h, per unit of h
};

/// Solves (1) and (2). Throws std::runtime_error if the factorisation fails.
[[nodiscard]] PatchMeans patch_flow(const PatchGap& gap, PatchEnds ends);

/// The same without (2): conductance only.
[[nodiscard]] double patch_conductance(const PatchGap& gap, PatchEnds ends);

/// The patch with x and y exchanged.
[[nodiscard]] PatchGap exchanged(const PatchGap& gap);

}  // namespace shellback::surface
