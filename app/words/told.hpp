#pragma once
/// Reason and cure of an ending, and cures that several share.
#include <string>

#include "core/outcome.hpp"

namespace shellback::app::told {

struct Told {
  std::string reason;
  std::string cure;
};

/// What an ending's words may need beside its data.
struct About {
  const Verdict& verdict;
  Told within;  ///< of its cause; empty: it has none
};

inline constexpr const char* kBeyondBarus =
    "switch on elastic deformation where it is off, use the Roelands law instead of Barus', or "
    "lower the load";
/// Why a rigid film's pressure has a bound, whatever the law.
inline constexpr const char* kBoundOfPressure =
    "with rigid surfaces the reduced pressure, the integral of eta(0)/eta(p) over p, has a bound, "
    "of Barus' law 1/alpha";
inline constexpr const char* kContactElseLoad =
    "lower the load or the tilt, or, where they are missing, give roughness and contact data";
inline constexpr const char* kContactElseElastic =
    "give roughness and contact data, switch on elastic deformation where it is off, or lower the "
    "load, or the moment or tilt";
inline constexpr const char* kFinerElseTighter = "try a finer grid or a tighter range of operation";
inline constexpr const char* kFinerElseIsothermal = "a finer grid, or tier isothermal";
inline constexpr const char* kFinerElseLess = "try a finer grid or a lower load";
inline constexpr const char* kLessHeat =
    "lower speed or load, feed more or cooler oil, or improve the cooling of the shell";

}  // namespace shellback::app::told
