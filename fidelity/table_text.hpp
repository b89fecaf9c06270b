#pragma once
/// data/tables/*.csv, built into the program.
namespace shellback::fidelity {

/// Text of data/tables/plain_bearing.csv.
[[nodiscard]] const char* plain_bearing_table();

}  // namespace shellback::fidelity
