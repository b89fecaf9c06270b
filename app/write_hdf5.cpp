#include "app/write_hdf5.hpp"

#include "app/hdf5_result.hpp"
#include "app/words/effect_words.hpp"

namespace shellback::app {

using namespace hdf5;

namespace {

using bearing::Result;

void write_scalars(hid_t file, const Result& result) {
  const Handle quantities = group(file, "quantities");
  for (const auto& q : result.quantities) {
    attribute(quantities, q.name, q.value);
    attribute(quantities, q.name + "_unit", q.unit);
    write_bars(quantities, q);
  }
  const Handle audit = group(file, "audit");
  attribute(audit, "mass", result.audit.mass);
  attribute(audit, "energy", result.audit.energy);
  attribute(audit, "load", result.audit.load);
  attribute(audit, "moment", result.audit.moment);
  write_cost(file, result.cost);
}

void write_grid(hid_t file, const bearing::Fields& f) {
  const Handle grid = group(file, "grid");
  write_film_grid(grid, f.grid);
  doubles(grid, "s", f.s, "-", "position across the film y/h, 0 shell, 1 journal");
  doubles(grid, "r", f.r, "m", "radius in shell and housing");
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
  cells("layer_depth", f.layer_depth, "m", "lasting depth of the surface layer");
  cells("summit_flow", f.summit_flow, "m", "plastic flow of summits at the hardness");
  cells("theta", f.theta, "-", "fill ratio");
  cells("h", f.h, "m", "nominal gap, depth of supply features included");
  cells("T_mean", f.T_mean, "K", "film temperature, mean across the film");
  cells("T_shell_surface", f.T_shell_surface, "K", "shell temperature at the bore");
  cells("T_shell_back", f.T_shell_back, "K", "shell temperature at its back");
  cells("tau_journal", f.tau_journal, "Pa",
        "shear stress of the oil on the journal, positive against a counter-clockwise one "
        "(asperities "
        "left out)");
  cells("tau_shell", f.tau_shell, "Pa",
        "shear stress of the oil on the shell, positive along a counter-clockwise journal "
        "(asperities "
        "left out)");
  cells("tau_abrasive", f.tau_abrasive, "Pa", "asperity shear stress, abrasive part");
  cells("tau_adhesive", f.tau_adhesive, "Pa", "asperity shear stress, adhesive part");
  cells("tau_micro_hydrodynamic", f.tau_micro_hydrodynamic, "Pa",
        "asperity shear stress, micro-hydrodynamic part");
  cells("elastic", f.elastic, "m", "elastic widening of the gap");
  cells("growth", f.thermal_deformation, "m", "thermal widening of the gap");
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

}  // namespace

std::string result_hdf5(const bearing::Case& c, const Result& result) {
  return file_bytes([&](hid_t file) {
    write_head(file, result);
    write_scalars(file, result);
    write_grid(file, result.fields);
    write_fields(file, result);
    write_history(file, result);
    write_effects(file, result);
    write_notes(file, result);
    write_origin(file, c);
  });
}

}  // namespace shellback::app
