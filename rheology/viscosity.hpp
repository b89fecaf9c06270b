#pragma once
/// Viscosity of one oil under its chosen laws, at a point and over a whole field of nodes.
///
///   eta(T, p, rate) = eta(T, p) f(rate)      temperature.hpp, pressure.hpp, shear.hpp
///
/// T [K], p gauge [Pa], rate >= 0 [1/s], eta [Pa s]. The laws are evaluated as they stand also
/// outside Oil::range; whoever presents a result compares with the range and warns.
///
/// The field functions visit the law once, outside the loop; their loops (viscosity_field.cpp)
/// run on the vector unit. Spans of one call have equal sizes and do not overlap. A node whose
/// input is not a number gets a viscosity that is not one; no other node is affected.
#include <span>

#include "rheology/oil.hpp"

namespace shellback::rheology {

/// Viscosity at low shear rate [Pa s].
[[nodiscard]] double viscosity(const Oil& oil, double T, double p);

/// Viscosity at a shear rate, and its logarithmic slopes, each with the other two held.
struct ViscositySlopes {
  double eta;          ///< [Pa s]
  double dln_dT;       ///< d ln eta / d T [1/K]
  double dln_dp;       ///< d ln eta / d p [1/Pa]
  double dln_dlnrate;  ///< d ln eta / d ln rate [-], from -1 (limit) to 0
};
[[nodiscard]] ViscositySlopes viscosity_slopes(const Oil& oil, double T, double p, double rate);

/// d ln eta / d p at constant T [1/Pa]; the same at every shear rate.
[[nodiscard]] double pressure_slope(const Oil& oil, double T, double p);

/// Viscosity at low shear rate of every node.
void viscosity(const Oil& oil, std::span<const double> T, std::span<const double> p,
               std::span<double> eta);

/// d ln eta / d p of every node [1/Pa].
void pressure_slope(const Oil& oil, std::span<const double> T, std::span<const double> p,
                    std::span<double> slope);

/// f(rate) [-] and its logarithmic slope d ln f / d ln rate [-] (shear.hpp) of every node, rate >=
/// 0 [1/s].
void shear_factors(const Oil& oil, std::span<const double> rate, std::span<double> factor,
                   std::span<double> slope);

/// The same oil with an effect switched off. Houpert's law also sets the temperature slope: its
/// place is then taken by the Reynolds slope with Houpert's beta through eta(at), which has the
/// same value and slope at T = at, p = 0.
[[nodiscard]] Oil without_pressure_effect(Oil oil);
[[nodiscard]] Oil without_shear_thinning(Oil oil);
/// True if the viscosity follows the shear rate.
[[nodiscard]] bool thins(const Oil& oil);

}  // namespace shellback::rheology
