#pragma once
/// Which refusals of the stability map are contradicted, and by whom.
///
/// A steady state is found where a solve converges and passes its audits. It contradicts a refusal
/// of
///
/// - any ground, if it solves the same equations of the same tier at the same point, by another
///   method or on another grid;
/// - heat ("thermal runaway"), if its heat is richer and its film the same: thd beside lumped, the
///   temperature resolved beside one temperature across the film.
///
/// Less physics contradicts nothing: one temperature across the film, or oil that is not conserved
/// (Swift-Stieber), may well find what is not there. Nor does an elastic film contradict a rigid
/// one: it has another gap, and the limit of Barus' oil between rigid surfaces stays what it is.
/// Nor does a coarser grid where the finer one refuses, too, or meets a bound of the equations: a
/// tilted film presses within a few tenths of a millimetre of its edge, and cells wider than that
/// do not see the pressure that has its bound.
#include "validation/stress/stress_row.hpp"

namespace shellback::validation {

/// On what a refusal rests, read from its reason.
enum class RefusalGround { heat, other };
[[nodiscard]] RefusalGround ground_of(const std::string& reason);

/// Turns contradicted refusals of all methods into wrong refusals ("no steady state") or missed
/// ones ("not found").
void find_contradicted(StressRow& row);

/// The same for what the scene expects; converging where it expects nothing is wrong.
void find_unexpected(StressRow& row);

/// The coarser grid that converges where the default and the finer grid refuse; "" if none.
[[nodiscard]] std::string overruled_by_finer(const StressRow& row, std::size_t step);

/// The solves that spoke on the refusal of the default at a step.
struct Witnesses {
  int silent = 0;                   ///< refused likewise
  std::vector<std::string> faulty;  ///< "a grid of 180x23: hang": they say nothing
};
[[nodiscard]] Witnesses witnesses_of(const StressRow& row, std::size_t step);

}  // namespace shellback::validation
