#pragma once
/// A bearing through one operation, held for a time: what a warm-up is and a course is made of.
///
/// Shell, housing and shaft come from the stretch before, or start at one temperature; the film,
/// which forgets within milliseconds, begins anew. Under a steady load as in heat_march.hpp, over
/// load cycles as in march_over_cycles.hpp from the orbit of the first cycle on.
#include <functional>
#include <memory>
#include <optional>

#include "bearing/heat/heat_march.hpp"
#include "bearing/over_time/march_over_cycles.hpp"

namespace shellback::bearing {

struct WarmUpOptions {
  double T_start = 293.15;                               ///< of shell, housing and shaft [K]
  double end = std::numeric_limits<double>::infinity();  ///< [s]; infinity: until at rest
  /// Of the wall temperatures in one step, over model.tolerance [K]: 0.2 K at 1 %, where viscosity
  /// changes by 0.5 to 1 % (decision 059).
  double error = 20.0;
  /// Over cycles how far a wall moves until one is passed again, over model.tolerance [K]: 2 K at
  /// 1 % (methods 3.5).
  double move = 200.0;
  std::vector<double> steps{};  ///< to be taken as they are, over `end` [s]; empty: chosen
};

/// What goes from one stretch into the next; empty: there is none before.
struct CarriedOver {
  std::optional<Bodies> bodies;
  std::shared_ptr<const Solids> solids;  ///< operators, under a steady load
};

/// Whether a stretch over load cycles ends early where walls move no more, or is passed to its end
/// in sixteen steps at least: what they leave there is some tenths of a per cent of friction.
enum class StretchEnd { at_rest, in_time };

/// Has each instant, counted from the beginning of the stretch; `stand` puts on a tape all that the
/// next one depends on.
using TellStretch = std::function<void(const Instant&, const std::function<void(Tape&)>& stand)>;

/// Passes `options.end` of the operation of `c` in tier thd or tehd; a cycle must repeat itself.
/// `last` is left at the last instant (over cycles its bearing alone). On from where the tape of
/// `control.kept` stands, if one is under way. Options that are no march in time: InputError.
[[nodiscard]] MarchEnd pass_stretch(const Case& c, Tier tier, const WarmUpOptions& options,
                                    StretchEnd ends, const SolveControl& control,
                                    CarriedOver& carried, Solution& last, const TellStretch& tell);

}  // namespace shellback::bearing
