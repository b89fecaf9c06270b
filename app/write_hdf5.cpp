#include "app/write_hdf5.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "app/hdf5_parts.hpp"
#include "core/contract.hpp"

namespace shellback::app {

using namespace hdf5;

namespace {

using bearing::Result;

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

void write_grid(hid_t file, const bearing::Fields& f) {
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
  using bearing::HistoryEntry;
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
  using bearing::Effect;
  using bearing::LimiterCount;
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

}  // namespace

std::string result_hdf5(const bearing::Case& c, const Result& result) {
  return file_bytes([&](hid_t file) {
    write_head(file, result);
    write_scalars(file, result);
    write_grid(file, result.fields);
    write_fields(file, result);
    write_history(file, result);
    write_notes(file, result);
    write_origin(file, c);
  });
}

}  // namespace shellback::app
