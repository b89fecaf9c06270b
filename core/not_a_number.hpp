#pragma once
/// A value that is no finite number, by the field in which it stands and its node. It is a defect
/// of the program or of the numbers it was given, never physics.
#include <optional>
#include <span>

namespace shellback {

/// Fields in which such a value may show first.
enum class FieldName {
  journal_position,
  thermal_deformation,
  elastic_opening,
  gap,
  film_pressure,
  fill_ratio,
  film_temperature,
  viscosity,
  contact_pressure,
  film_flow,
};

struct NotANumber {
  FieldName field = FieldName::film_pressure;
  int cell = -1;  ///< of the film's grid; -1: it has no place in the film
};

/// The first of `field` that is no finite number; it holds `per_cell` values of every cell.
[[nodiscard]] std::optional<NotANumber> find_not_a_number(FieldName name,
                                                          std::span<const double> field,
                                                          int per_cell = 1);

}  // namespace shellback
