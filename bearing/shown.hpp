#pragma once
/// Values as engineers read them, for messages.
#include <string>
#include <string_view>

namespace shellback::bearing {

/// An SI value in `unit`, one of the table in shown.cpp, with four digits: 2.39e-5 in "um" is
/// "23.9 um", 373.15 in "degC" is "100 degC".
[[nodiscard]] std::string shown(double value, std::string_view unit);

}  // namespace shellback::bearing
