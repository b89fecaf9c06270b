#include "app/read_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/hdf5_parts.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace hdf5;

/// Names of what a group holds, in the order in which it was written where the file keeps it.
template <class Visit>
std::vector<std::string> names_of(hid_t group, unsigned order, const Visit& visit) {
  std::vector<std::string> names;
  const H5_index_t index =
      (order & H5P_CRT_ORDER_TRACKED) != 0U ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  check(visit(group, index, &names), "its names");
  return names;
}

std::vector<std::string> attributes_of(hid_t group) {
  const Handle how(H5Gget_create_plist(group), H5Pclose, "a group");
  unsigned order = 0;
  check(H5Pget_attr_creation_order(how, &order), "a group");
  return names_of(group, order, [](hid_t of, H5_index_t index, void* names) {
    const auto note = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
      return 0;
    };
    return H5Aiterate2(of, index, H5_ITER_INC, nullptr, note, names);
  });
}

std::vector<std::string> links_of(hid_t group) {
  const Handle how(H5Gget_create_plist(group), H5Pclose, "a group");
  unsigned order = 0;
  check(H5Pget_link_creation_order(how, &order), "a group");
  return names_of(group, order, [](hid_t of, H5_index_t index, void* names) {
    const auto note = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
      return 0;
    };
    return H5Literate(of, index, H5_ITER_INC, nullptr, note, names);
  });
}

/// The text attributes and the numbers of an object.
struct Attributes {
  std::vector<std::pair<std::string, double>> numbers;
  std::map<std::string, std::string> texts;

  explicit Attributes(hid_t owner, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const Handle id(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose, name.c_str());
      const Handle space(H5Aget_space(id), H5Sclose, name.c_str());
      check(H5Sget_simple_extent_npoints(space) == 1 ? 0 : -1, name);
      const Handle type(H5Aget_type(id), H5Tclose, name.c_str());
      if (H5Tget_class(type) == H5T_STRING) {
        texts[name] = text_attribute(owner, name.c_str());
      } else {
        double value = 0.0;
        check(H5Aread(id, H5T_NATIVE_DOUBLE, &value), name);
        numbers.emplace_back(name, value);
      }
    }
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    const auto at = texts.find(name);
    return at == texts.end() ? "" : at->second;
  }
  [[nodiscard]] double number(const std::string& name) const {
    const auto at = std::find_if(numbers.begin(), numbers.end(),
                                 [&](const auto& entry) { return entry.first == name; });
    return at == numbers.end() ? std::numeric_limits<double>::quiet_NaN() : at->second;
  }
};

Attributes attributes_in(hid_t file, const char* name) {
  if (H5Lexists(file, name, H5P_DEFAULT) <= 0) return Attributes(file, {});
  const Handle id(H5Gopen2(file, name, H5P_DEFAULT), H5Gclose, name);
  return Attributes(id, attributes_of(id));
}

Handle opened(hid_t parent, const std::string& name) {
  return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str()};
}

hsize_t points_of(hid_t data, const std::string& name) {
  const Handle space(H5Dget_space(data), H5Sclose, name.c_str());
  const hssize_t size = H5Sget_simple_extent_npoints(space);
  check(size < 0 ? -1 : 0, name);
  return static_cast<hsize_t>(size);
}

std::vector<double> numbers_in(hid_t parent, const std::string& name) {
  const Handle id = opened(parent, name);
  std::vector<double> values(points_of(id, name));
  if (!values.empty()) {
    check(H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  }
  return values;
}

std::vector<std::string> texts_in(hid_t parent, const std::string& name) {
  const Handle id = opened(parent, name);
  std::vector<char*> pointers(points_of(id, name));
  std::vector<std::string> lines;
  if (pointers.empty()) return lines;
  check(H5Dread(id, text_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), name);
  for (char* text : pointers) {
    lines.emplace_back(text == nullptr ? "" : text);
    H5free_memory(text);
  }
  return lines;
}

/// All datasets of numbers in a group; none if there is no such group.
std::vector<StoredValues> values_in(hid_t file, const char* name) {
  std::vector<StoredValues> all;
  if (H5Lexists(file, name, H5P_DEFAULT) <= 0) return all;
  const Handle parent(H5Gopen2(file, name, H5P_DEFAULT), H5Gclose, name);
  for (const std::string& link : links_of(parent)) {
    const Handle id = opened(parent, link);
    const auto told = [&](const char* of) {
      return H5Aexists(id, of) > 0 ? text_attribute(id, of) : std::string();
    };
    all.push_back({link, told("units"), told("long_name"), told("axes"), numbers_in(parent, link)});
  }
  return all;
}

std::vector<StoredQuantity> quantities_in(hid_t file) {
  const Attributes all = attributes_in(file, "quantities");
  std::vector<StoredQuantity> out;
  for (const auto& [name, value] : all.numbers) {
    const bool whole = all.texts.contains(name + "_unit");  // else a bar, a limit
    if (!whole || name.ends_with("_at")) continue;          // the instant of another
    StoredQuantity q;
    q.quantity.name = name;
    q.quantity.value = value;
    q.quantity.unit = all.text(name + "_unit");
    q.quantity.error_grid = all.number(name + "_error_grid");
    q.quantity.error_time = all.number(name + "_error_time");
    q.quantity.error_model = all.number(name + "_error_model");
    q.quantity.limit = all.number(name + "_limit");
    q.at = all.number(name + "_at");
    q.at_unit = all.text(name + "_at_unit");
    out.push_back(q);
  }
  return out;
}

FilmGrid grid_in(hid_t file) {
  FilmGrid g;
  const Attributes sizes = attributes_in(file, "grid");
  g.radius = sizes.number("radius");
  g.width = sizes.number("width");
  const Handle grid(H5Gopen2(file, "grid", H5P_DEFAULT), H5Gclose, "grid");
  g.phi = numbers_in(grid, "phi");
  g.dphi = numbers_in(grid, "dphi");
  g.phi_face = numbers_in(grid, "phi_face");
  g.z = numbers_in(grid, "z");
  g.dz = numbers_in(grid, "dz");
  g.z_face = numbers_in(grid, "z_face");
  g.nt = static_cast<int>(g.phi.size());
  g.nz = static_cast<int>(g.z.size());
  return g;
}

std::vector<StoredEffect> effects_in(hid_t file) {
  std::vector<StoredEffect> all;
  if (H5Lexists(file, "effects", H5P_DEFAULT) <= 0) return all;
  const Handle parent(H5Gopen2(file, "effects", H5P_DEFAULT), H5Gclose, "effects");
  const auto names = texts_in(parent, "name"), meanings = texts_in(parent, "meaning");
  const auto included = numbers_in(parent, "included"), weights = numbers_in(parent, "indicator");
  const bool alike = meanings.size() == names.size() && included.size() == names.size() &&
                     weights.size() == names.size();
  check(alike ? 0 : -1, "effects");
  for (std::size_t k = 0; k < names.size(); ++k) {
    all.push_back({names[k], meanings[k], included[k] != 0.0, weights[k]});
  }
  return all;
}

void read_notes(hid_t file, StoredResult& result) {
  const Handle notes(H5Gopen2(file, "notes", H5P_DEFAULT), H5Gclose, "notes");
  result.warnings = texts_in(notes, "warnings");
  result.assumptions = texts_in(notes, "assumptions");
  const Handle limiters(H5Gopen2(file, "limiters", H5P_DEFAULT), H5Gclose, "limiters");
  const auto what = texts_in(limiters, "what");
  const auto count = numbers_in(limiters, "count");
  check(what.size() == count.size() ? 0 : -1, "limiters");
  for (std::size_t k = 0; k < what.size(); ++k) {
    result.limiters.push_back(fmt::format("{}, {} times", what[k], count[k]));
  }
}

/// Fails where a list is not as long as its axes say.
void expect_shapes(const StoredResult& result) {
  const FilmGrid& g = result.grid;
  const auto nt = static_cast<std::size_t>(g.nt), nz = static_cast<std::size_t>(g.nz);
  const auto as_long = [](std::size_t is, std::size_t wanted, const std::string& name) {
    check(is == wanted ? 0 : -1, name);
  };
  if (g.cells() > 0) {
    as_long(g.dphi.size(), nt, "dphi");
    as_long(g.dz.size(), nz, "dz");
    as_long(g.phi_face.size(), nt + 1, "phi_face");
    as_long(g.z_face.size(), nz + 1, "z_face");
  }
  std::size_t instants = 0;
  for (const StoredValues& v : result.frames) {
    if (v.name == "t") instants = v.values.size();
  }
  const std::map<std::string, std::size_t> lengths{{"phi z", nt * nz},
                                                   {"phi z s", nt * nz * result.s.size()},
                                                   {"phi r", nt * result.r.size()},
                                                   {"t phi z", instants * nt * nz}};
  for (const auto* group : {&result.fields, &result.frames}) {
    for (const StoredValues& v : *group) {
      const auto wanted = lengths.find(v.axes);
      if (wanted != lengths.end()) as_long(v.values.size(), wanted->second, v.name);
    }
  }
  for (const StoredValues& v : result.series) {
    as_long(v.values.size(), result.series.front().values.size(), v.name);
  }
}

void expect_version(hid_t file) {
  int version = 0;
  const Handle id(H5Aopen(file, "format_version", H5P_DEFAULT), H5Aclose, "format_version");
  check(H5Aread(id, H5T_NATIVE_INT, &version), "format_version");
  if (version == hdf5::kFormatVersion) return;
  throw InputError(
      fmt::format("its format is version {}, and this program reads version {}; read it with "
                  "the program that wrote it, or run the case again",
                  version, hdf5::kFormatVersion));
}

void read_head(hid_t file, StoredResult& result) {
  const auto text = [&](const char* name) { return text_attribute(file, name); };
  result.title = text("title");
  result.tier = text("tier");
  result.status = text("status");
  result.reason = text("reason");
  result.place = text("place");
  result.cure = text("cure");
  int converged = 0;
  const Handle id(H5Aopen(file, "converged", H5P_DEFAULT), H5Aclose, "converged");
  check(H5Aread(id, H5T_NATIVE_INT, &converged), "converged");
  result.converged = converged != 0;
  const Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "/");
  const double crank = Attributes(root, attributes_of(root)).number("crank_speed");
  if (std::isfinite(crank)) result.crank_speed = crank;
}

void read_origin(hid_t file, StoredResult& result) {
  const Attributes from = attributes_in(file, "provenance");
  result.provenance = {
      from.text("version"), from.text("git"), from.text("input"), from.text("input_fnv1a64"), {}};
  for (const auto& [name, version] : from.texts) {
    constexpr std::string_view kLibrary = "library_";
    if (name.starts_with(kLibrary)) {
      result.provenance.libraries.emplace_back(name.substr(kLibrary.size()), version);
    }
  }
  const Attributes of_case = attributes_in(file, "case");
  result.scene = of_case.text("scene");
  result.changes = of_case.text("changes");
  const Handle input(H5Gopen2(file, "case", H5P_DEFAULT), H5Gclose, "case");
  const auto lines = texts_in(input, "verbatim");
  if (!lines.empty()) result.verbatim = lines.front();
}

StoredResult read_all(hid_t file) {
  expect_version(file);
  StoredResult result;
  read_head(file, result);
  result.quantities = quantities_in(file);
  result.audit = attributes_in(file, "audit").numbers;
  result.cost = attributes_in(file, "cost").numbers;
  result.grid = grid_in(file);
  for (const StoredValues& axis : values_in(file, "grid")) {
    if (axis.name == "s") result.s = axis.values;
    if (axis.name == "r") result.r = axis.values;
  }
  result.fields = values_in(file, "fields");
  result.series = values_in(file, "series");
  result.frames = values_in(file, "frames");
  result.effects = effects_in(file);
  read_notes(file, result);
  read_origin(file, result);
  expect_shapes(result);
  return result;
}

}  // namespace

const StoredValues* StoredResult::field(const std::string& name) const {
  const auto at = std::find_if(fields.begin(), fields.end(),
                               [&](const StoredValues& f) { return f.name == name; });
  return at == fields.end() ? nullptr : &*at;
}

StoredResult read_result(const std::string& path) {
  if (!std::filesystem::exists(path)) {
    throw FileError(path + ": there is no such file");
  }
  const std::string format = format_of(path);
  if (format != "shellback result") {
    throw InputError(path,
                     (format.empty() ? std::string("this is no result file of shellback")
                                     : "this is a " + format + ", not the result of one run") +
                         "; shellback run CASE -o FILE.h5 writes one");
  }
  const QuietErrors quiet;
  try {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    return read_all(file);
  } catch (const InputError& error) {
    throw InputError(path, error.what());
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("{}: it cannot be read whole ({}); write it again", path, error.what()));
  }
}

}  // namespace shellback::app
