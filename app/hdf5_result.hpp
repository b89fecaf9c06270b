#pragma once
/// The groups that the file of a result and that of a load cycle have in common.
#include <string>
#include <vector>

#include "app/hdf5_parts.hpp"
#include "bearing/result.hpp"

namespace shellback::app::hdf5 {

/// One member of each entry of `list`, in a vector.
template <class T, class List, class Member>
std::vector<T> column(const List& list, Member member) {
  std::vector<T> values;
  for (const auto& entry : list) values.push_back(static_cast<T>(std::invoke(member, entry)));
  return values;
}

/// Attributes format to cure.
void write_head(hid_t file, const bearing::Result& result);

/// What is known of the bars of a quantity, of each kind and together, beside its value.
void write_bars(hid_t quantities, const bearing::Quantity& q);

/// Group cost.
void write_cost(hid_t file, const bearing::Cost& k);

/// Positions and widths of the cells, into the group `grid`.
void write_film_grid(hid_t grid, const FilmGrid& g);

/// One field with its expected size; an empty one is not part of the tier and stays out.
void field(hid_t parent, const char* name, const std::vector<double>& values, const Shape& shape,
           const Meaning& meaning);

/// Group effects: indicator numbers.
void write_effects(hid_t file, const bearing::Result& result);

/// Groups limiters and notes.
void write_notes(hid_t file, const bearing::Result& result);

}  // namespace shellback::app::hdf5
