#pragma once
/// Where the residual of a heat balance changes its sign over temperature.
///
/// r(T) = temperature that the heat made at T would give the oil, minus T: positive where more heat
/// is made than leaves. Between two roots of opposite stability r bends back; a scan that is too
/// coarse sees neither. The temperatures are therefore spaced by what moves the film: from one to
/// the next the viscosity changes by no more than a factor of sqrt(2) (power and flow of a film
/// change by no more than its viscosity does), and never more than 50 K. Where |r| has a dip that
/// points towards zero, the scan is halved about it until the dip is told or a viscosity step of
/// 1 % is reached: two roots nearer to each other than that are one for every purpose.
#include <functional>
#include <optional>
#include <vector>

#include "rheology/oil.hpp"

namespace shellback::bearing {

/// A temperature that was tried; no residual: no film was found there, which is no sign.
struct HeatSample {
  double T = 0.0;                  ///< [K]
  std::optional<double> residual;  ///< r [K]
};

/// Residual at a temperature [K]; none: no film.
using HeatResidual = std::function<std::optional<double>(double)>;

/// Temperatures of the scan from `low` to at most `high` [K], no farther than the laws of the oil
/// give a viscosity, a density and a heat capacity that are positive numbers.
[[nodiscard]] std::vector<double> scan_temperatures(const rheology::Oil& oil, double low,
                                                    double high);

/// The samples, rising in T.
[[nodiscard]] std::vector<HeatSample> scan_heat_balance(const HeatResidual& residual,
                                                        const std::vector<double>& temperatures);

/// Index of the lower sample of each pair of neighbours between which r changes its sign.
[[nodiscard]] std::vector<std::size_t> sign_changes(const std::vector<HeatSample>& samples);

}  // namespace shellback::bearing
