#include "app/write_hdf5.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "app/pending_file.hpp"
#include "app/provenance.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using coupling::Result;

/// Owns one HDF5 identifier; a negative one is the library's way to say no.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
    if (id < 0) throw FileError(fmt::format("HDF5 refused to create {}", what));
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: an identifier is what the C interface takes

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void check(herr_t outcome, const std::string& what) {
  if (outcome < 0) throw FileError("HDF5 could not write " + what);
}

/// The C library prints its error stack by default; our exception says what is needed.
class QuietErrors {
 public:
  QuietErrors() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

Handle group(hid_t parent, const char* name) {
  return {H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name};
}

/// UTF-8 strings of any length; readers in Python and MATLAB take these as plain text.
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

/// What a reader must know of a dataset.
struct Meaning {
  std::string units;
  std::string long_name;
  std::string axes;   ///< coordinates of its dimensions, "phi z s"
  std::string state;  ///< empty: converged
};

using Shape = std::vector<hsize_t>;

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
           const char* long_name) {
  std::vector<const char*> pointers;
  for (const auto& line : lines) pointers.push_back(line.c_str());
  dataset(parent, name, text_type(), pointers.data(), {lines.size()}, {"-", long_name, "", ""});
}

void doubles(hid_t parent, const char* name, const std::vector<double>& values, const char* units,
             const char* long_name) {
  dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), {values.size()},
          {units, long_name, "", ""});
}

/// One member of each entry of `list`, in a vector.
template <class T, class List, class Member>
std::vector<T> column(const List& list, Member member) {
  std::vector<T> values;
  for (const auto& entry : list) values.push_back(static_cast<T>(std::invoke(member, entry)));
  return values;
}

void write_head(hid_t file, const Result& result) {
  attribute(file, "format", std::string("shellback result"));
  attribute(file, "format_version", 1);
  attribute(file, "title", result.title);
  attribute(file, "tier", std::string(to_string(result.tier)));
  attribute(file, "status", std::string(to_string(result.verdict.status)));
  attribute(file, "converged", result.verdict.good() ? 1 : 0);
  attribute(file, "reason", result.verdict.reason);
  attribute(file, "place", result.verdict.place);
  attribute(file, "cure", result.verdict.cure);
}

void write_scalars(hid_t file, const Result& result) {
  const Handle quantities = group(file, "quantities");
  for (const auto& q : result.quantities) {
    attribute(quantities, q.name, q.value);
    attribute(quantities, q.name + "_unit", q.unit);
    const auto bar = [&](const char* suffix, double value) {  // what is not known is not there
      if (std::isfinite(value)) attribute(quantities, q.name + suffix, value);
    };
    bar("_error", q.error());
    bar("_error_grid", q.error_grid);
    bar("_error_model", q.error_model);
  }
  const Handle audit = group(file, "audit");
  attribute(audit, "mass", result.audit.mass);
  attribute(audit, "energy", result.audit.energy);
  attribute(audit, "load", result.audit.load);
  attribute(audit, "moment", result.audit.moment);
  const Handle cost = group(file, "cost");
  attribute(cost, "wall_s", result.cost.wall_s);
  attribute(cost, "setup_s", result.cost.setup_s);
  attribute(cost, "factorizations", result.cost.factorizations);
  attribute(cost, "newton_iterations", result.cost.newton_iterations);
  attribute(cost, "outer_iterations", result.cost.outer_iterations);
}

void write_grid(hid_t file, const coupling::Fields& f) {
  const Handle grid = group(file, "grid");
  attribute(grid, "radius", f.grid.radius);
  attribute(grid, "radius_unit", std::string("m"));
  attribute(grid, "width", f.grid.width);
  attribute(grid, "width_unit", std::string("m"));
  doubles(grid, "phi", f.grid.phi, "rad",
          "circumferential cell position, counter-clockwise from X");
  doubles(grid, "dphi", f.grid.dphi, "rad", "circumferential cell width");
  doubles(grid, "phi_face", f.grid.phi_face, "rad", "circumferential face position");
  doubles(grid, "z", f.grid.z, "m", "axial cell position, 0 at mid-width");
  doubles(grid, "dz", f.grid.dz, "m", "axial cell width");
  doubles(grid, "z_face", f.grid.z_face, "m", "axial face position");
  doubles(grid, "s", f.s, "-", "position across the film y/h, 0 shell, 1 journal");
  doubles(grid, "r", f.r, "m", "radius in shell and housing");
}

/// One field with its expected size; an empty one is not part of the tier and stays out.
void field(hid_t parent, const char* name, const std::vector<double>& values, const Shape& shape,
           const Meaning& meaning) {
  if (values.empty()) return;
  [[maybe_unused]] const auto size =
      std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
  EXPECTS(size == values.size());
  dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), shape, meaning);
}

void write_fields(hid_t file, const Result& result) {
  const auto& f = result.fields;
  const Handle fields = group(file, "fields");
  const Shape film{static_cast<hsize_t>(f.grid.nt), static_cast<hsize_t>(f.grid.nz)};
  const Shape across{film[0], film[1], f.s.size()};
  const std::string state =
      result.verdict.good() ? "" : "not converged: last iterate, not a result";
  const auto cells = [&](const char* name, const Field& values, const char* units,
                         const char* long_name) {
    field(fields, name, values, film, {units, long_name, "phi z", state});
  };
  cells("p", f.p, "Pa", "film pressure, gauge");
  cells("p_asperity", f.p_asperity, "Pa", "asperity contact pressure");
  cells("theta", f.theta, "-", "fill ratio");
  cells("h", f.h, "m", "nominal gap, depth of supply features included");
  cells("T_mean", f.T_mean, "K", "film temperature, mean across the film");
  cells("T_shell_surface", f.T_shell_surface, "K", "shell temperature at the bore");
  cells("T_shell_back", f.T_shell_back, "K", "shell temperature at its back");
  cells("tau_journal", f.tau_journal, "Pa", "shear stress on the journal, against its motion");
  cells("tau_shell", f.tau_shell, "Pa", "shear stress on the shell, along the motion");
  cells("elastic", f.elastic, "m", "elastic widening of the gap");
  cells("growth", f.growth, "m", "thermal widening of the gap");
  field(fields, "T", f.T, across, {"K", "film temperature", "phi z s", state});
  field(fields, "T_shaft", f.T_shaft, {film[1]}, {"K", "shaft surface temperature", "z", state});
  field(fields, "T_solid", f.T_solid, {film[0], f.r.size()},
        {"K", "shell and housing temperature at mid-width", "phi r", state});
  if (!f.supplied.empty()) {
    dataset(fields, "supplied", H5T_NATIVE_CHAR, f.supplied.data(), film,
            {"-", "1 inside a supply feature", "phi z", state});
  }
}

void write_history(hid_t file, const Result& result) {
  using coupling::HistoryEntry;
  const auto& all = result.history;
  const Handle history = group(file, "history");
  texts(history, "stage", column<std::string>(all, &HistoryEntry::stage), "stage of the solve");
  doubles(history, "residual", column<double>(all, &HistoryEntry::residual), "-",
          "relative change of the iterate");
  doubles(history, "friction_torque", column<double>(all, &HistoryEntry::friction_torque), "N m",
          "friction torque on the journal");
  doubles(history, "h_min", column<double>(all, &HistoryEntry::h_min), "m", "smallest film");
}

void write_notes(hid_t file, const Result& result) {
  using coupling::Effect;
  using coupling::LimiterCount;
  const Handle effects = group(file, "effects");
  texts(effects, "name", column<std::string>(result.effects, &Effect::name), "effect");
  doubles(effects, "included", column<double>(result.effects, &Effect::included), "-",
          "1: part of the model, 0: left out");
  doubles(effects, "indicator", column<double>(result.effects, &Effect::indicator), "-",
          "indicator number of the effect");
  texts(effects, "meaning", column<std::string>(result.effects, &Effect::meaning),
        "what the indicator is");
  const Handle limiters = group(file, "limiters");
  texts(limiters, "what", column<std::string>(result.limiters, &LimiterCount::what), "limiter");
  doubles(limiters, "count", column<double>(result.limiters, &LimiterCount::count), "-",
          "how often it acted");
  const Handle notes = group(file, "notes");
  texts(notes, "warnings", result.warnings, "warnings");
  texts(notes, "assumptions", result.assumptions, "defaults and assumed data relied on");
}

void write_origin(hid_t file, const coupling::Case& c) {
  const Handle input = group(file, "case");
  attribute(input, "path", c.path);
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

}  // namespace

void write_hdf5(const std::string& path, const coupling::Case& c, const Result& result) {
  const QuietErrors quiet;
  PendingFile pending(path);
  try {
    const Handle file(
        H5Fcreate(pending.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
        "the file");
    write_head(file, result);
    write_scalars(file, result);
    write_grid(file, result.fields);
    write_fields(file, result);
    write_history(file, result);
    write_notes(file, result);
    write_origin(file, c);
    // A full disk shows only now; closing cannot report it.
    check(H5Fflush(file, H5F_SCOPE_LOCAL), "the file");
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("cannot write {}: {}; choose another place or name", path, error.what()));
  }
  pending.commit();
}

}  // namespace shellback::app
