#include "app/hdf5_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/provenance.hpp"
#include "core/contract.hpp"

namespace shellback::app::hdf5 {

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
  if (id < 0) throw FileError(fmt::format("HDF5 refused {}", what));
}

void check(herr_t outcome, const std::string& what) {
  if (outcome < 0) throw FileError("HDF5 failed at " + what);
}

QuietErrors::QuietErrors() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle group(hid_t parent, const char* name) {
  const Handle how(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, name);
  check(H5Pset_link_creation_order(how, H5P_CRT_ORDER_TRACKED), name);
  check(H5Pset_attr_creation_order(how, H5P_CRT_ORDER_TRACKED), name);
  return {H5Gcreate2(parent, name, H5P_DEFAULT, how, H5P_DEFAULT), H5Gclose, name};
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
  check(H5Tset_size(type, H5T_VARIABLE), "a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "a text type");
  return {H5Tcopy(type), H5Tclose, "a text type"};
}

void attribute(hid_t owner, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "a scalar");
  const Handle id(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                  name.c_str());
  check(H5Awrite(id, type, value), name);
}
void attribute(hid_t owner, const std::string& name, double value) {
  attribute(owner, name, H5T_NATIVE_DOUBLE, &value);
}
void attribute(hid_t owner, const std::string& name, int value) {
  attribute(owner, name, H5T_NATIVE_INT, &value);
}
void attribute(hid_t owner, const std::string& name, const std::string& value) {
  const char* text = value.c_str();
  attribute(owner, name, text_type(), &text);
}

std::string text_attribute(hid_t owner, const char* name) {
  const Handle id(H5Aopen(owner, name, H5P_DEFAULT), H5Aclose, name);
  char* text = nullptr;
  check(H5Aread(id, text_type(), &text), name);
  const std::string copy = text == nullptr ? "" : text;
  H5free_memory(text);
  return copy;
}

void dataset(hid_t parent, const std::string& name, hid_t type, const void* data,
             const Shape& shape, const Meaning& meaning) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, name.c_str());
  const Handle id(
      H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, name.c_str());
  const bool empty = std::find(shape.begin(), shape.end(), 0U) != shape.end();
  if (!empty) check(H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), name);
  attribute(id, "units", meaning.units);
  attribute(id, "long_name", meaning.long_name);
  if (!meaning.axes.empty()) attribute(id, "axes", meaning.axes);
  if (!meaning.state.empty()) attribute(id, "state", meaning.state);
}

void texts(hid_t parent, const char* name, const std::vector<std::string>& lines,
           const Shape& shape, const Meaning& meaning) {
  std::vector<const char*> pointers;
  for (const auto& line : lines) pointers.push_back(line.c_str());
  dataset(parent, name, text_type(), pointers.data(), shape, meaning);
}

void texts(hid_t parent, const char* name, const std::vector<std::string>& lines,
           const char* long_name) {
  texts(parent, name, lines, {lines.size()}, {"-", long_name, "", ""});
}

void doubles(hid_t parent, const char* name, const std::vector<double>& values, const char* units,
             const char* long_name) {
  dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), {values.size()},
          {units, long_name, "", ""});
}

void write_origin(hid_t file, const bearing::Case& c) {
  const Handle input = group(file, "case");
  attribute(input, "path", c.path);
  attribute(input, "scene", describe_case(c, Writing::plain));
  attribute(input, "changes", describe_changes(c));
  const char* text = c.verbatim.c_str();
  dataset(input, "verbatim", text_type(), &text, {1}, {"-", "text of the case file", "", ""});
  const Provenance p = provenance(c);
  const Handle origin = group(file, "provenance");
  attribute(origin, "version", p.version);
  attribute(origin, "git", p.git);
  attribute(origin, "input", p.input);
  attribute(origin, "input_fnv1a64", p.fingerprint);
  for (const auto& [name, version] : p.libraries) attribute(origin, "library_" + name, version);
}

std::string file_bytes(const std::function<void(hid_t)>& fill) {
  constexpr std::size_t kGrowth = 1 << 20;  // memory is taken in steps of this size [B]
  constexpr hbool_t kNoFile = 0;
  const QuietErrors quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a file in memory");
  check(H5Pset_fapl_core(access, kGrowth, kNoFile), "a file in memory");
  const Handle file(H5Fcreate("result", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "the file");
  fill(file);
  check(H5Fflush(file, H5F_SCOPE_LOCAL), "the file");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  check(size > 0 ? 0 : -1, "the file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(file, bytes.data(), bytes.size()) == size ? 0 : -1, "the file");
  return bytes;
}

std::string format_of(const std::string& path) {
  const QuietErrors quiet;
  try {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    return text_attribute(file, "format");
  } catch (const FileError&) {
    return "";
  }
}

}  // namespace shellback::app::hdf5
