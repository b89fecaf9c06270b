#pragma once
/// How a file shows that Shellback wrote it: a result may be replaced by a newer one, any other
/// file may not (app/output_rules.hpp).
///
///   HDF5      attribute `format` of the file, "shellback ..." (app/hdf5_parts.hpp)
///   JSON      first key, `generator`
///   CSV       last column, `shellback`: the version in every row
///   HTML      line above the title, "Shellback ..." (class `kicker`)
///   SVG, Markdown   comment at the very top
///   VTK       comment below the first line
///   PNG       text chunk `Software`, first after the header
///
/// A table of coefficients has no room for a mark, since rotordynamics programs take each of its
/// columns for a parameter; it is known by its header and by how its one row is written.
#include <string>

namespace shellback::app {

enum class Format { hdf5, json, csv, coefficients, html, svg, png, markdown, toml, vtk };

/// What is to be written to a file or to standard output: `content` with the mark of its format.
/// HDF5 and HTML carry theirs already; a case has none, for it belongs to the user.
[[nodiscard]] std::string marked(Format format, std::string content);

/// Whether the file carries one of these marks. A file that cannot be read does not.
[[nodiscard]] bool is_result(const std::string& path);

}  // namespace shellback::app
