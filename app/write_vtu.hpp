#pragma once
/// The film of a result file for ParaView: VTK XML of unstructured grids, in text.
///
/// Film cells are quadrilaterals on the bore (x = R cos phi, y = R sin phi, z), their values cell
/// data named "NAME [unit]", SI; temperatures across the film are components from shell to journal.
/// Source: VTK file formats, kitware ("XML file formats", unstructured grid).
#include <string>
#include <vector>

#include "app/read_result.hpp"

namespace shellback::app {

struct VtuFile {
  std::string name;
  std::string content;
};

/// film.vtu with all fields; of a load cycle film_0000.vtu ... with the film at its instants too,
/// and film.pvd, which gives each its time [s]. Throws InputError where there is no film.
[[nodiscard]] std::vector<VtuFile> film_vtu(const StoredResult& result);

}  // namespace shellback::app
