#include "core/not_a_number.hpp"

#include <algorithm>
#include <cmath>

namespace shellback {

const char* to_string(FieldName name) {
  switch (name) {
    case FieldName::journal_position:
      return "journal position";
    case FieldName::thermal_deformation:
      return "thermal growth";
    case FieldName::elastic_opening:
      return "elastic opening";
    case FieldName::gap:
      return "gap";
    case FieldName::film_pressure:
      return "film pressure";
    case FieldName::fill_ratio:
      return "fill ratio";
    case FieldName::film_temperature:
      return "film temperature";
    case FieldName::viscosity:
      return "viscosity";
    case FieldName::contact_pressure:
      return "contact pressure";
    case FieldName::film_flow:
      return "film flow";
  }
  return "unknown field";
}

std::optional<NotANumber> find_not_a_number(FieldName name, std::span<const double> field,
                                            int per_cell) {
  const auto bad =
      std::find_if(field.begin(), field.end(), [](double x) { return !std::isfinite(x); });
  if (bad == field.end()) return std::nullopt;
  return NotANumber{name, static_cast<int>(bad - field.begin()) / per_cell};
}

Verdict ended_by(const NotANumber& found, const std::string& place) {
  return {Status::invalid_number, std::string("not a number in ") + to_string(found.field), place,
          "report it with the case: this is a defect of the program, not of the bearing"};
}

}  // namespace shellback
