#pragma once
/// The keys to be identified, and the cases that the search solves.
#include <string>
#include <vector>

#include "app/reading/measured_table.hpp"

namespace shellback::app {

/// A key with its value and bounds in the unit that the case has it in.
struct FittedKey {
  std::string key;  ///< surfaces.contact.friction_law.b
  std::string unit;
  study::FitParameter value;
  bool usual_bounds = false;  ///< a decade to each side of the start, 50 K: nobody gave others
  [[nodiscard]] std::string words(double x) const;  ///< "2.5 um", as --set takes it
};

/// `fit` are keys, each perhaps with its bounds, KEY=FROM..TO, several parted by commas; `bounds`
/// are KEY=LOW:HIGH. The value in the case, changed by `set`, is the start. Throws InputError: a
/// key that is no number of the case or named twice, reversed bounds, none of an angle or of a
/// start at zero, a start on or outside them, bounds of nothing, a key that the table of
/// measurements sets.
[[nodiscard]] std::vector<FittedKey> fitted_keys(const std::string& text, const std::string& path,
                                                 const std::vector<Override>& set,
                                                 const std::vector<std::string>& fit,
                                                 const std::vector<std::string>& bounds,
                                                 const MeasuredTable& table);

/// The file's text with `set`, the point and the keys. Keeps copies of what it is given.
[[nodiscard]] study::MeasuredCase measured_case(std::string text, std::string path,
                                                std::vector<Override> set, MeasuredTable table,
                                                std::vector<FittedKey> keys);

/// Names of the keys with which cells of the film move, from one of their bounds to the other, the
/// rest as in `x`: those of supplies and of openings at the ends. What is computed jumps where a
/// cell comes or goes.
[[nodiscard]] std::vector<std::string> keys_that_move_cells(const study::MeasuredCase& case_at,
                                                            const std::vector<FittedKey>& keys,
                                                            const std::vector<double>& x);

}  // namespace shellback::app
