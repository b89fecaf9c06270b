#pragma once
/// What the smallest film may still fall by between the last cells and an edge of the film: a side
/// edge, or that of a supply along the bearing.
///
/// The gap on a side edge is the rigid one and the displacement, continued by the straight line
/// through the last two cells (fluid/gap.hpp). Beside a sharp edge that is pressed, elastic
/// surfaces fall off as h = h_edge + A s^a, s being the distance from the edge; a = 1/2 beside a
/// flat rigid punch (textbook), nearer to 1 where the pressure ends softly. With the middles s1 <
/// s2 < s3 of the last three cells and their gaps
///   (h3 - h2)/(h2 - h1) = (s3^a - s2^a)/(s2^a - s1^a),   1/2 <= a <= 1,                      (1)
///   A = (h2 - h1)/(s2^a - s1^a),
///   left = A s1^a - (h2 - h1) s1/(s2 - s1)                                                  (2)
/// is what the straight line leaves. It is zero for a = 1, for gaps that open towards the edge, and
/// where the smallest film stands elsewhere. Lands beside a supply, where the pressure ends, fall
/// off alike; no gap is told on that edge, and what is left is all of the fall from the smallest
/// one told to the edge's. Grids of one family leave it in all their differences: it comes on top
/// of the bar of those (decision 040).
#include "bearing/film/solution.hpp"
#include "fluid/gap.hpp"

namespace shellback::fidelity {

/// (2) [m]: `h` gap of all cells [m], `least` the smallest film, `in_supply` not 0 in supplies,
/// where there is no film that could be least.
[[nodiscard]] double edge_error(const FilmGrid& grid, const Field& h, const Field& in_supply,
                                const fluid::SmallestGap& least);
[[nodiscard]] double edge_error(const bearing::Solution& s);
/// (2) as a part of the smallest film [-]; 0 where no film is open.
[[nodiscard]] double part_hidden_at_edge(const bearing::Solution& s);

/// The same for the smallest gap of each place over a load cycle: full-width, from where its line
/// through the last two cells is least on an edge, if no cell has less.
[[nodiscard]] double edge_error(const FilmGrid& grid, const Field& h, const Field& in_supply);

/// (2) of three gaps at distances s from the edge, nearest first.
[[nodiscard]] double left_of_edge(const std::array<double, 3>& s, const std::array<double, 3>& h);

}  // namespace shellback::fidelity
