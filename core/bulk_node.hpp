#pragma once
/// One temperature across the film: walls and the mean of the oil between them.
///
/// Nodes 0 and 1 hold the walls, the middle node holds the mean temperature T_m with which the oil
/// flows and its viscosity is taken. Heat passes to the walls as through the parabola with that
/// mean and those ends:
///   q_shell = k/h (6 T_m - 4 T_shell - 2 T_shaft),  q_shaft likewise,
/// that is Nu = h q/(k (T_m - T_w)) = 6 for dissipation between walls of one temperature and
/// k (T_shell - T_shaft)/h for pure conduction. Source: textbook (bulk-flow energy equation with
/// parabolic profile). Valid for a film that convects little across: no thermal boundary layers.
#include "core/cross_film_nodes.hpp"

namespace shellback {

[[nodiscard]] CrossFilmNodes bulk_node();

}  // namespace shellback
