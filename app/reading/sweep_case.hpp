#pragma once
/// The cases of a sweep: one text, read anew for every point, so that all judgements hold.
#include <optional>
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "app/study/sweep.hpp"

namespace shellback::app {

/// Reads `text` with the changes `set` and, last, the values of the axes. An InputError tells the
/// point at which it arose. Keeps copies of what it is given.
[[nodiscard]] study::CaseAt case_source(std::string text, std::string path,
                                        std::vector<Override> set, std::vector<study::Axis> axes);

/// The case that stands for the whole sweep: that of the first point, whose text is the file's
/// with `set` and the axes as comments. Throws InputError.
[[nodiscard]] bearing::Case sweep_subject(const std::string& text, const std::string& path,
                                          const std::vector<Override>& set,
                                          const std::vector<study::Axis>& axes);

/// Every file that any point is read from.
[[nodiscard]] std::vector<std::string> files_of_sweep(const std::string& text,
                                                      const std::string& path,
                                                      const std::vector<Override>& set,
                                                      const std::vector<study::Axis>& axes);

/// Throws InputError at `option` where two cases that differ in operation.speed turn alike, as the
/// table of their load cycle has speeds of its own.
void expect_speed_is_free(const bearing::Case& a, const bearing::Case& b,
                          const std::string& option);

/// What the file itself says for the axis's key, in the axis's unit; nothing if it does not say,
/// or not in that unit.
[[nodiscard]] std::optional<double> value_in_file(const std::string& text, const study::Axis& axis);

/// "operation.speed = 50 rpm, operation.load = 4 kN"
[[nodiscard]] std::string position_words(const std::vector<study::Axis>& axes,
                                         const study::Position& at);

/// "operation.speed = 3000 rpm to 50 rpm, 30 values", or the values if they are few.
[[nodiscard]] std::string axis_words(const study::Axis& axis);

}  // namespace shellback::app
