#pragma once
/// A warm-up as JSON and as a picture.
#include <string>
#include <vector>

#include "bearing/over_time/warm_up.hpp"
#include "fidelity/march_bars.hpp"

namespace shellback::app {

/// What the steady state that was solved for itself is warned of, the case where there is none, and
/// the warm-up.
[[nodiscard]] std::vector<std::string> warm_up_warnings(const bearing::Case& c,
                                                        const bearing::WarmUp& run,
                                                        const fidelity::MarchBars& bars,
                                                        const bearing::Result& steady);
/// What that state assumes, or the case.
[[nodiscard]] std::vector<std::string> warm_up_assumptions(const bearing::Case& c,
                                                           const bearing::Result& steady);

/// status, [reason, place, cure], title, tier, grid, `start` (temperature of the walls), `end` {t,
/// at_rest}, `time` and every quantity over time as {unit, values, error_grid, error_time},
/// `steady`: the steady state solved for itself, with the bars of its grid, `audit` {energy:
/// largest imbalance over the heat made}, warnings, assumptions, provenance, `changes` and `case`.
[[nodiscard]] std::string warm_up_json(const bearing::Case& c, const bearing::WarmUp& run,
                                       const bearing::WarmUpOptions& options,
                                       const fidelity::MarchBars& bars,
                                       const bearing::Result& steady);

/// Temperatures, friction and smallest film over time (1200 x 780, white background) with bands of
/// their bars, the steady state beside them; where the bearing seizes, when.
[[nodiscard]] std::string warm_up_svg(const bearing::Case& c, const bearing::WarmUp& run,
                                      const fidelity::MarchBars& bars,
                                      const bearing::Result& steady);

}  // namespace shellback::app
