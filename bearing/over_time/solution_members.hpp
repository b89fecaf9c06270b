#pragma once
/// What a solution under a load that stands still is made of, for a tape (core/tape.hpp). The
/// bearing itself is not: it is made anew from its case. A member that is added to one of these
/// types and not here does not compile.
#include "bearing/over_time/running_in_run.hpp"
#include "bearing/over_time/tape_members.hpp"

namespace shellback {

/// A matrix or a column of numbers. Throws FileError where their count is not that of its rows.
template <int kRows, int kColumns>
void members(Tape& tape, Eigen::Matrix<double, kRows, kColumns>& x) {
  auto rows = static_cast<std::int64_t>(x.rows());
  std::vector<double> all(x.data(), x.data() + x.size());
  tape(rows, all);
  const auto size = static_cast<std::int64_t>(all.size());
  const bool whole = rows > 0 ? size % rows == 0 : rows == 0 && size == 0;
  const std::int64_t columns = rows > 0 && whole ? size / rows : (kColumns == 1 ? 1 : 0);
  if (!whole || (kColumns == 1 && columns != 1)) {
    throw FileError("a kept matrix is not whole");
  }
  x = Eigen::Map<const Eigen::Matrix<double, kRows, kColumns>>(all.data(), rows, columns);
}

inline void members(Tape& tape, bearing::HeatState& x) {
  tape(static_cast<bearing::HeatUnknowns&>(x), static_cast<bearing::HeatEvaluation&>(x));
}

/// How the thermal deformation by asperity heat is taken into the film's equations; or not.
inline void members(Tape& tape, std::shared_ptr<const bearing::ContactWidening>& x) {
  auto widening = x ? std::optional(*x) : std::nullopt;
  tape(widening);
  x = widening ? std::make_shared<const bearing::ContactWidening>(*std::move(widening)) : nullptr;
}

/// Without stiffness and damping, which are found anew.
inline void members(Tape& tape, bearing::Solution& x) {
  auto& [model, point, film, heat, T_film, heat_roots, verdict, cost, history, limits, coefficients,
         levels, wall_s] = x;
  tape(film, film.contact_widening, heat, T_film, heat_roots, verdict, cost, history, limits,
       levels, wall_s);
}

}  // namespace shellback
