#pragma once
/// A page made of a result file alone: neither the case nor the tables that it names are asked for.
#include <string>

#include "app/read_result.hpp"

namespace shellback::app {

/// Quantities with their bars, notes, curves over the cycle, every field on the unrolled bearing,
/// temperatures across the film and in the solids at mid-width, audit and cost, effects,
/// provenance, the case's text. Of a load cycle the journal's path and the film in motion, without
/// the outlines of supplies.
[[nodiscard]] std::string report_html(const StoredResult& result);

}  // namespace shellback::app
