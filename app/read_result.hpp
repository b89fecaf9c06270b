#pragma once
/// A result file of `run` (write_hdf5.hpp, write_cycle_hdf5.hpp) as it stands there: what `report`
/// and `export` are made of. SI throughout, angles of the grid in radians; nothing is judged again.
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/provenance.hpp"
#include "bearing/quantities.hpp"
#include "core/grid.hpp"

namespace shellback::app {

/// A dataset with what it says of itself.
struct StoredValues {
  std::string name, units, long_name;
  std::string axes;  ///< "phi z", "t phi z", ...; empty: a list
  std::vector<double> values;
};

/// Of a load cycle with the instant of an extreme, in `at_unit`; not a number: none.
struct StoredQuantity {
  bearing::Quantity quantity;
  double at = std::numeric_limits<double>::quiet_NaN();
  std::string at_unit;
};

struct StoredEffect {
  std::string name, meaning;
  bool included = false;
  double indicator = 0.0;
};

struct StoredResult {
  std::string title, scene, changes;
  std::string tier, status, reason, place, cure;
  bool converged = false;
  double crank_speed = 0.0;  ///< of a load cycle over crank angle [rad/s]
  std::vector<StoredQuantity> quantities;
  std::vector<std::pair<std::string, double>> audit, cost;
  FilmGrid grid;                     ///< no cells: the tier solves no film
  std::vector<double> s, r;          ///< y/h across the film [-], radius of the solids [m]
  std::vector<StoredValues> fields;  ///< of a load cycle extremes and means
  std::vector<StoredValues> series;  ///< over a load cycle, `t` and, with a crank, `angle` in it
  std::vector<StoredValues> frames;  ///< films at instants of a load cycle, with their `t`
  std::vector<std::string> warnings, assumptions, limiters;
  std::vector<StoredEffect> effects;
  Provenance provenance;
  std::string verbatim;  ///< the case's text

  /// The field, or null.
  [[nodiscard]] const StoredValues* field(const std::string& name) const;
};

/// Throws FileError where the file cannot be read, InputError where it is no result of `run`.
[[nodiscard]] StoredResult read_result(const std::string& path);

}  // namespace shellback::app
