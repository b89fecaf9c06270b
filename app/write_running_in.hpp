#pragma once
/// A running-in as JSON, as a picture and as the shape that it leaves.
#include <string>
#include <vector>

#include "fidelity/running_in_bars.hpp"

namespace shellback::app {

/// status, [reason, cure], title, tier, grid, `time` and every quantity over time as {unit,
/// values, error_grid, error_time} (time null: worn in, whenever that is), `rejected_steps`,
/// `complementarity` (null: not asked for), `tolerance` {asked, met, bars of the last state over
/// its values}, assumptions, provenance, `changes`, `case`. Over a load cycle p_asperity_max and
/// h_min are its extremes and friction_torque is its mean; `cycles` passed for each state, and
/// `cycle`, that of the last one: closure, audit {mass, energy, walls}, quantities {value, unit,
/// [at]}, limiters, warnings. Under a standing load `warnings` and `limiters` are those of the last
/// state. `surface`, of a shell that becomes [running_in].worn: {value, unit} of its keys at the
/// end.
[[nodiscard]] std::string running_in_json(const bearing::Case& c, const bearing::RunningInRun& run,
                                          const fidelity::RunningInBars& bars);

/// What is to be said of the bars: that they are not known, or not within model.tolerance at the
/// end.
[[nodiscard]] std::vector<std::string> words_of_bars(const bearing::Case& c,
                                                     const bearing::RunningInRun& run,
                                                     const fidelity::RunningInBars& bars);

/// What the last state has to say: warnings of its range, and limiters that acted in it, by name
/// and number of times. Over a load cycle those of the cycle.
[[nodiscard]] std::vector<std::string> words_of_last_state(const bearing::RunningInRun& run);

/// The surface of the last state as options, "--set 'surfaces.shell.roughness=...'" and so on;
/// empty if it does not change.
[[nodiscard]] std::string worn_surface_keys(const bearing::Case& c,
                                            const bearing::RunningInRun& run);

/// Greatest wear and worn volume, contact pressure and friction over time with bands of their
/// bars, the worn shape on the unrolled bearing and in the section of the greatest depth (1200 x
/// 780, white background).
[[nodiscard]] std::string running_in_svg(const bearing::Case& c, const bearing::RunningInRun& run,
                                         const fidelity::RunningInBars& bars);

/// phi [deg], z [mm], height [um]: what bearing.shape of a case takes; the shape that the case had
/// before is in it. A comment at the end tells worn_surface_keys.
[[nodiscard]] std::string worn_shape_csv(const bearing::Case& c, const bearing::RunningInRun& run);

}  // namespace shellback::app
