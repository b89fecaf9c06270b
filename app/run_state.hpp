#pragma once
/// The state of a run over load cycles, of a running-in, a warm-up or a course as a file, HDF5:
/// what bearing/over_time/kept_run.hpp keeps, the case as it was solved and the program that solved
/// it.
///
/// A state is gone on with only by the same program with the same case: anything else would end
/// with numbers that no single run gives.
#include <string>
#include <utility>
#include <vector>

#include "bearing/case.hpp"
#include "core/tape.hpp"

namespace shellback::app {

/// What is run.
enum class RunOf { load_cycle, running_in, warm_up, course, comparison };

/// What the command line says of the run beside the case: option, values [SI].
using RunOptions = std::vector<std::pair<std::string, std::vector<double>>>;

/// The bytes of the file.
[[nodiscard]] std::string run_state(const bearing::Case& c, RunOf run, const Tape::Content& kept,
                                    const RunOptions& options = {});

/// What the file keeps for the case `c`. Throws InputError where it is of another case, run or
/// program (and says what differs), FileError where it is damaged or no such file.
[[nodiscard]] Tape::Content read_run_state(const std::string& path, const bearing::Case& c,
                                           RunOf run, const RunOptions& options = {});

}  // namespace shellback::app
