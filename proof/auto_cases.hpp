#pragma once
/// Random bearings on which tier `auto` is judged.
///
/// Plain bearings as built for engines and machines, with all data that tier tehd needs: radius 10
/// to 100 mm, B/D 0.25 to 1, c/R 0.8 to 2 per mille, surface speed 0.5 to 30 m/s, specific load 0.2
/// to 15 MPa, oils of 0.5 to 3 times the viscosity of a 0W20, axial groove or hole, AlSn on steel
/// in a steel or aluminium housing, half of them rough with contact, seven in ten piezoviscous,
/// four in ten shear-thinning. The clearance is that of a bearing up to 30 K colder than the oil.
/// Lengths, speeds, loads, viscosities and heat transfers are spread evenly in logarithms.
#include "coupling/case.hpp"

namespace shellback::proof {

/// The same seed gives the same case on every machine. Tier tehd, 200 x 25 cells.
[[nodiscard]] coupling::Case auto_case(int seed);

}  // namespace shellback::proof
