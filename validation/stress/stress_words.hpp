#pragma once
/// Words of the stability map that page, lists, picture and terminal share.
#include <array>
#include <string>

#include "validation/stress/stress_map.hpp"

namespace shellback::validation {

/// All that a cell can end as, in the order of the tables.
inline constexpr std::array kStressClasses{
    StressClass::converged,     StressClass::no_steady_state, StressClass::refused_input,
    StressClass::not_found,     StressClass::by_convention,   StressClass::missed,
    StressClass::wrong_refusal, StressClass::wrong,           StressClass::not_a_number,
    StressClass::crashed,       StressClass::timed_out};

/// For a cell of a Markdown table.
[[nodiscard]] const char* stress_mark(StressClass c);

/// The `shellback run` command line that repeats a cell.
[[nodiscard]] std::string repeat_command(const StressScene& scene, const StressStep& step,
                                         const StressMethod& method);

/// What ended the row: the reason of the first refusal or fault of the default, in a few words.
[[nodiscard]] std::string end_of_row(const StressRow& row);

/// Reason without its numbers and asides, at most `most` characters.
[[nodiscard]] std::string in_short(const std::string& why, std::size_t most);

/// "Shellback as shipped: 0 wrong, 0 wrong refusal, 0 hang, 0 crash, 0 not a number; ..." with what
/// it missed and how many solves were asked beside its refusals.
[[nodiscard]] std::string faults_in_words(const StressMap& map);

}  // namespace shellback::validation
