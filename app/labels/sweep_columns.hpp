#pragma once
/// What a table of a sweep holds: its points in reading order and the quantities that occur.
#include <functional>
#include <string>
#include <vector>

#include "app/labels/quantity_label.hpp"
#include "app/study/sweep.hpp"

namespace shellback::app {

/// A quantity that at least one point has.
struct SweepQuantity {
  std::string name;
  std::string unit;         ///< as in the JSON: SI, angles in degrees
  double factor = 1.0;      ///< from the solver's unit to `unit` [-]
  bool with_error = false;  ///< at least one point knows its error bar
};

/// All quantities of all solved points, in the order in which they first appear.
[[nodiscard]] std::vector<SweepQuantity> sweep_quantities(const study::Sweep& sweep);

/// Value of `q` at the point, and its error bar; not-a-number if the point is not solved, or its
/// tier does not know them.
[[nodiscard]] double value_at(const study::SweepPoint& point, const SweepQuantity& q);
[[nodiscard]] double error_at(const study::SweepPoint& point, const SweepQuantity& q);

/// One of the bars of a quantity, not-a-number where it is not known.
using Bar = std::function<double(const bearing::Quantity&)>;
/// That bar of `q` at the point, as error_at; whether some point knows it.
[[nodiscard]] double bar_at(const study::SweepPoint& point, const SweepQuantity& q, const Bar& bar);
[[nodiscard]] bool known_somewhere(const study::Sweep& sweep, const SweepQuantity& q,
                                   const Bar& bar);

/// Indices on all axes of point `index` of Sweep::points.
[[nodiscard]] std::vector<int> indices_of(const study::Sweep& sweep, int index);

/// Points in reading order: curve after curve, along each.
[[nodiscard]] std::vector<int> reading_order(const study::Sweep& sweep);

/// "converged", "iteration limit", ...; "not started" for what an interrupt left undone.
[[nodiscard]] std::string status_word(const study::SweepPoint& point);

/// "60 points, 58 converged, 2 not (marked)", and the interrupt if there was one.
[[nodiscard]] std::string count_words(const study::Sweep& sweep);

/// Bearing and operating point without what is swept.
[[nodiscard]] std::string describe_subject(const bearing::Case& c, const study::Sweep& sweep,
                                           Writing writing);

/// All warnings of the points, each once.
[[nodiscard]] std::vector<std::string> sweep_warnings(const study::Sweep& sweep);

}  // namespace shellback::app
