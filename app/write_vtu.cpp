#include "app/write_vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr int kQuadrilateral = 9;  ///< VTK's number of the cell type
constexpr const char* kHeadVtk = "<?xml version=\"1.0\"?>\n";

/// Names and units are our own, but a reader of XML does not know.
std::string in_xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return out;
}

void add_array(std::string& xml, const std::string& name, int components, const double* values,
               std::size_t size) {
  fmt::format_to(std::back_inserter(xml),
                 "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" "
                 "format=\"ascii\">\n",
                 in_xml(name), components);
  for (std::size_t k = 0; k < size; ++k) {
    fmt::format_to(std::back_inserter(xml), "{}{}", values[k],
                   (k + 1) % static_cast<std::size_t>(components) == 0 ? '\n' : ' ');
  }
  xml += "</DataArray>\n";
}

/// Corners of the cells on the bore; the last face around is the first.
std::string corners_xml(const FilmGrid& g) {
  std::vector<double> at;
  for (int i = 0; i < g.nt; ++i) {
    for (const double z : g.z_face) {
      const double phi = g.phi_face[static_cast<std::size_t>(i)];
      at.insert(at.end(), {g.radius * std::cos(phi), g.radius * std::sin(phi), z});
    }
  }
  std::string xml = "<Points>\n";
  add_array(xml, "corners [m]", 3, at.data(), at.size());
  return xml + "</Points>\n";
}

std::string cells_xml(const FilmGrid& g) {
  constexpr int kCorners = 4;
  std::string connectivity, offsets, types;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int here = i * (g.nz + 1) + j, there = g.next(i) * (g.nz + 1) + j;
      connectivity += fmt::format("{} {} {} {}\n", here, there, there + 1, here + 1);
      offsets += fmt::format("{}\n", kCorners * (g.index(i, j) + 1));
      types += fmt::format("{}\n", kQuadrilateral);
    }
  }
  const auto list = [](const char* type, const char* name, const std::string& numbers) {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n{}</DataArray>\n",
                       type, name, numbers);
  };
  return "<Cells>\n" + list("Int64", "connectivity", connectivity) +
         list("Int64", "offsets", offsets) + list("UInt8", "types", types) + "</Cells>\n";
}

std::string grid_xml(const StoredResult& result, const std::string& values) {
  const FilmGrid& g = result.grid;
  const int points = g.nt * (g.nz + 1);
  return fmt::format(
      "{}<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n<FieldData>\n<DataArray type=\"Int32\" Name=\"converged\" "
      "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n</FieldData>\n<Piece "
      "NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n{}{}"
      "<CellData>\n{}</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
      kHeadVtk, result.converged ? 1 : 0, points, g.cells(), corners_xml(g), cells_xml(g), values);
}

std::string unit_name(const StoredValues& field) {
  return fmt::format("{} [{}]", field.name, field.units);
}

std::string fields_xml(const StoredResult& result) {
  std::string xml;
  for (const StoredValues& field : result.fields) {
    const bool film = field.axes == "phi z", across = field.axes == "phi z s";
    if (!film && !across) continue;
    const int components = across ? static_cast<int>(result.s.size()) : 1;
    add_array(xml, unit_name(field), components, field.values.data(), field.values.size());
  }
  return xml;
}

/// The films at the instants, and the list of them with their times.
void add_frames(const StoredResult& result, std::vector<VtuFile>& files) {
  const auto t = std::find_if(result.frames.begin(), result.frames.end(),
                              [](const StoredValues& f) { return f.name == "t"; });
  if (t == result.frames.end()) return;
  const auto cells = static_cast<std::size_t>(result.grid.cells());
  std::string list;
  for (std::size_t k = 0; k < t->values.size(); ++k) {
    std::string values;
    for (const StoredValues& field : result.frames) {
      if (field.axes != "t phi z") continue;
      add_array(values, unit_name(field), 1, field.values.data() + k * cells, cells);
    }
    files.push_back({fmt::format("film_{:04}.vtu", k), grid_xml(result, values)});
    list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", t->values[k],
                        files.back().name);
  }
  files.push_back({"film.pvd", fmt::format("{}<VTKFile type=\"Collection\" version=\"1.0\" "
                                           "byte_order=\"LittleEndian\">\n<Collection>\n{}"
                                           "</Collection>\n</VTKFile>\n",
                                           kHeadVtk, list)});
}

}  // namespace

std::vector<VtuFile> film_vtu(const StoredResult& result) {
  if (result.grid.cells() == 0) {
    throw InputError("tier " + result.tier +
                     " solves no film that could be exported; run the case in another tier");
  }
  std::vector<VtuFile> files{{"film.vtu", grid_xml(result, fields_xml(result))}};
  add_frames(result, files);
  return files;
}

}  // namespace shellback::app
