#pragma once
/// One function per section of the case file; app/reading/read_case.cpp calls them in turn.
///
/// Each takes the whole file's Section (or its own) and returns a finished part of the Case in
/// SI units. What a single value can be is checked here; what values are to one another in
/// bearing/judge/judge_case.hpp. All throw InputError with place, reason and cure.
#include <optional>
#include <string>
#include <vector>

#include "app/reading/toml_reader.hpp"
#include "bearing/case.hpp"
#include "bearing/crank.hpp"

namespace shellback::app {

[[nodiscard]] bearing::Bearing read_bearing(const Section& file);

/// The path of the file that the key names, which lies beside the case; it goes on record.
[[nodiscard]] std::string table_beside(const Section& section, const std::string& key);

/// Measured profile from a table phi, z, height with units in its header line.
/// `not_finished`: receives what the table says of a run that wrote it and was not finished.
[[nodiscard]] bearing::Profile read_profile(const std::string& path,
                                            std::string* not_finished = nullptr);

/// [[supply]]; `oil_temperature` stands in for a temperature that is not given, `omega` turns crank
/// angles into times [rad/s].
[[nodiscard]] std::vector<bearing::Supply> read_supplies(
    const Section& file, double radius, const std::optional<double>& oil_temperature, double omega);

/// `text` of the key: a time, or a crank angle that the crank's speed `omega` [rad/s] turns into
/// time [s].
[[nodiscard]] double read_instant(const Section& section, const std::string& key,
                                  const std::string& text, double omega);

/// Where the case has a load cycle, the load is still to come.
[[nodiscard]] bearing::Operation read_operation(const Section& file);

/// [load_cycle], of a table or of [crank]; nothing if the case has neither. `omega` turns crank
/// angles into times [rad/s].
[[nodiscard]] std::optional<bearing::LoadCycle> read_load_cycle(const Section& file, double omega);

/// [crank]; `period`: what load_cycle.period says [rad], else the pressure's table does.
[[nodiscard]] bearing::Crank read_crank(const Section& crank, const std::optional<double>& period,
                                        bearing::CrankFrame frame);

[[nodiscard]] rheology::Oil read_oil(const Section& file);
[[nodiscard]] std::optional<double> read_oil_temperature(const Section& file);
/// `density`: of the same oil, for laws of its kinematic viscosity.
[[nodiscard]] rheology::TemperatureLaw read_temperature_law(const Section& law,
                                                            const rheology::DensityLaw& density);
[[nodiscard]] rheology::PressureLaw read_pressure_law(const Section& law);
[[nodiscard]] rheology::ShearLaw read_shear_law(const Section& law);

/// A shipped name, a table of its values, or a table with a shipped name and the values that
/// differ.
[[nodiscard]] solid::Material read_material(const Section& section, const std::string& key);

[[nodiscard]] std::optional<bearing::Shell> read_shell(const Section& file);
[[nodiscard]] std::optional<bearing::Shaft> read_shaft(const Section& file);
/// Roughness of one surface; `what` names the section.
/// `by_table`: its flow factors stand in a table, and its orientation serves for nothing.
[[nodiscard]] solid::RoughSurface read_surface(const Section& section, const std::string& what,
                                               bool by_table);
[[nodiscard]] std::optional<bearing::RunningIn> read_running_in(const Section& file);
[[nodiscard]] bearing::Surfaces read_surfaces(const Section& file);
/// A table of flow factors, as `shellback surface --csv` writes it.
[[nodiscard]] fluid::FactorTable read_flow_factors(const std::string& path);
[[nodiscard]] bearing::Model read_model(const Section& file);
/// `omega` of the operating point: a torque may have its sign.
[[nodiscard]] bearing::Measured read_measured(const Section& file, double omega);

}  // namespace shellback::app
