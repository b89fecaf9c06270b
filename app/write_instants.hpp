#pragma once
/// Instants of a warm-up or a course, with their bars, in tables, JSON and pictures.
#include <string>
#include <vector>

#include "app/followed.hpp"
#include "app/json_parts.hpp"
#include "app/pictures/svg_lines.hpp"
#include "fidelity/march_bars.hpp"

namespace shellback::app {

/// Two lines above those of instants, `first` above what each begins with.
[[nodiscard]] std::string instant_heading(const std::string& first);

/// `first`, torque, smallest film, temperatures (film and shell largest, back and shaft mean), with
/// the bars of the first two and the longest of the temperatures; "-" what is not known. `bar`:
/// half-widths, grid and time together.
[[nodiscard]] std::string instant_line(const std::string& first, const bearing::Instant& i,
                                       const bearing::Instant& bar);

/// Half-widths at the instant `k`, grid and time together; not a number where unknown.
[[nodiscard]] bearing::Instant bar_at(const fidelity::MarchBars& bars, std::size_t k);

/// When and why a march ended that found no further film.
[[nodiscard]] std::string end_words(const bearing::MarchEnd& end, const fidelity::MarchBars& bars);

/// That time in JSON, with its bars where they are known.
[[nodiscard]] json_parts::Json end_json(const bearing::MarchEnd& end,
                                        const fidelity::MarchBars& bars);

/// What a march in time begins with in JSON: how it ended, the case, T_start [K].
[[nodiscard]] json_parts::Json march_json(const bearing::Case& c, const Verdict& verdict,
                                          double T_start);

/// `time`, and in `quantities` what is followed over it as {unit, values, error_grid, error_time};
/// without the bars where none are known.
void add_instants(json_parts::Json& json, const std::vector<bearing::Instant>& instants,
                  const fidelity::MarchBars& bars);

/// That heat in, out and stored close to more than 1 % of what is made, `imbalance` [-].
[[nodiscard]] std::vector<std::string> heat_words(double imbalance);

/// Torque and smallest film of the instants `ends`.
[[nodiscard]] KnownAtEnds known_of_march(const bearing::Case& c,
                                         const std::vector<bearing::Instant>& instants,
                                         const fidelity::MarchBars& bars,
                                         const std::vector<std::size_t>& ends);

/// factor times the value less zero over `x`, with its bars.
[[nodiscard]] Series over_instants(const std::vector<double>& x,
                                   const std::vector<bearing::Instant>& instants,
                                   const fidelity::MarchBars& bars, double bearing::Instant::*value,
                                   double factor, double zero);

}  // namespace shellback::app
