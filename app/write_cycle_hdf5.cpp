#include "app/write_cycle_hdf5.hpp"

#include <cmath>

#include "app/hdf5_result.hpp"
#include "app/labels/cycle_shown.hpp"
#include "core/contract.hpp"

namespace shellback::app {

using namespace hdf5;

namespace {

using bearing::CycleFrame;
using bearing::CycleInstant;
using bearing::CycleResult;

void write_course(hid_t file, const CycleResult& cycle) {
  attribute(file, "period", cycle.period);
  attribute(file, "period_unit", std::string("s"));
  attribute(file, "crank_speed", cycle.crank_speed);
  attribute(file, "crank_speed_unit", std::string("rad/s"));
  attribute(file, "cycles", cycle.cycles);
  attribute(file, "closure", cycle.closure);
  attribute(file, "steps", cycle.steps);
  attribute(file, "rejected_steps", cycle.rejected_steps);
}

void write_scalars(hid_t file, const CycleResult& cycle) {
  const Handle quantities = group(file, "quantities");
  for (const auto& q : cycle.quantities) {
    const std::string& name = q.quantity.name;
    attribute(quantities, name, q.quantity.value);
    attribute(quantities, name + "_unit", q.quantity.unit);
    if (std::isfinite(q.at)) {
      attribute(quantities, name + "_at", shown_instant(cycle, q.at));
      attribute(quantities, name + "_at_unit", told_unit(cycle));
    }
    write_bars(quantities, q.quantity);
  }
  const Handle audit = group(file, "audit");
  for (const AuditFigure& a : audit_of(cycle)) attribute(audit, a.name, a.value);
}

/// Times, and crank angles if there is a crank.
void write_instants(hid_t parent, const CycleResult& cycle, const std::vector<double>& t) {
  doubles(parent, "t", t, "s", "time within the cycle");
  if (!has_crank(cycle)) return;
  std::vector<double> angle;
  for (const double each : t) angle.push_back(shown_instant(cycle, each));
  doubles(parent, "angle", angle, "deg", "crank angle");
}

void write_series(hid_t file, const bearing::Case& c, const CycleResult& cycle) {
  const Handle parent = group(file, "series");
  write_instants(parent, cycle, column<double>(cycle.instants, &CycleInstant::t));
  for (const CycleSeries& series : followed(c, cycle)) {
    doubles(parent, series.name.c_str(), series.values, series.unit.c_str(),
            series.long_name.c_str());
  }
}

void write_fields(hid_t file, const CycleResult& cycle, const std::string& state) {
  const auto& f = cycle.fields;
  const Shape film{static_cast<hsize_t>(f.grid.nt), static_cast<hsize_t>(f.grid.nz)};
  const Handle fields = group(file, "fields");
  const auto cells = [&](const char* name, const Field& values, const char* units,
                         const char* long_name) {
    field(fields, name, values, film, {units, long_name, "phi z", state});
  };
  cells("p_max", f.p_max, "Pa", "largest film pressure over the cycle, gauge");
  cells("p_asperity_max", f.p_asperity_max, "Pa", "largest contact pressure over the cycle");
  cells("h_min", f.h_min, "m", "smallest gap over the cycle");
  cells("supplied", f.in_supply, "-", "1 inside a supply feature");
  cells("friction_power", f.friction_power, "W/m2", "friction power, mean over the cycle");
  cells("layer_depth", f.layer_depth, "m", "lasting depth of the surface layer at the end");
  cells("T_shell", f.T_shell, "K", "temperature of the bore, mean over the cycle");
  cells("T_shell_max", f.T_shell_max, "K", "temperature of the bore, largest over the cycle");
  cells("heat_to_shell", f.heat_to_shell, "W/m2", "heat into the bore, mean over the cycle");
  cells("growth", f.thermal_deformation, "m", "thermal widening of the gap");
}

/// A member of all frames, one after another.
std::vector<double> stacked(const CycleResult& cycle, Field CycleFrame::*member) {
  std::vector<double> all;
  for (const CycleFrame& frame : cycle.frames) {
    EXPECTS((frame.*member).size() == static_cast<std::size_t>(cycle.fields.grid.cells()));
    all.insert(all.end(), (frame.*member).begin(), (frame.*member).end());
  }
  return all;
}

void write_frames(hid_t file, const CycleResult& cycle, const std::string& state) {
  const Handle frames = group(file, "frames");
  write_instants(frames, cycle, column<double>(cycle.frames, &CycleFrame::t));
  const Shape film{cycle.frames.size(), static_cast<hsize_t>(cycle.fields.grid.nt),
                   static_cast<hsize_t>(cycle.fields.grid.nz)};
  const auto cells = [&](const char* name, Field CycleFrame::*member, const char* units,
                         const char* long_name) {
    field(frames, name, stacked(cycle, member), film, {units, long_name, "t phi z", state});
  };
  cells("p", &CycleFrame::p, "Pa", "film pressure, gauge");
  cells("theta", &CycleFrame::theta, "-", "fill ratio");
  cells("h", &CycleFrame::h, "m", "gap");
}

}  // namespace

std::string cycle_hdf5(const bearing::Case& c, const CycleResult& cycle) {
  const bearing::Result head = head_of(cycle);
  const std::string state = head.verdict.good() ? "" : "not converged: what was found before";
  return file_bytes([&](hid_t file) {
    write_head(file, head);
    write_course(file, cycle);
    write_scalars(file, cycle);
    write_cost(file, cycle.cost);
    write_series(file, c, cycle);
    const Handle grid = group(file, "grid");
    write_film_grid(grid, cycle.fields.grid);
    write_fields(file, cycle, state);
    write_frames(file, cycle, state);
    write_effects(file, head);
    write_notes(file, head);
    write_origin(file, c);
  });
}

}  // namespace shellback::app
