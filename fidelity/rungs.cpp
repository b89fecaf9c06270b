#include "fidelity/rungs.hpp"

#include <cmath>

#include "fidelity/coarse_solution.hpp"

namespace shellback::fidelity {
namespace {

constexpr std::size_t kKept = 3;

/// Value of a quantity of one rung for fine cells around.
GridLimit film_limit_of(const Rung& rung, const std::string& name) {
  const double V = value_in(rung.whole, name);
  const bool of_film = !name.starts_with("T_") && !name.starts_with("heat");
  return film_limit(V, of_film ? value_in(rung.refined, name) : NAN, rung.grid[0],
                    film_grid(rung.grid)[0]);
}

}  // namespace

Grid film_grid(Grid grid) {
  constexpr int kStillCoarse = 40;
  return {grid[0] * (grid[0] <= kStillCoarse ? 3 : 2), grid[1]};  // on fine grids a smaller step
}

void Rungs::push(Rung rung) {
  list_.push_back(std::move(rung));
  if (list_.size() > kKept) list_.erase(list_.begin());
}

GridLimit Rungs::limit(const std::string& name) const {
  const Rung& fine = list_.back();
  const double V = value_in(fine.whole, name);
  if (list_.size() < 2) return {V, NAN, 0.0};
  const Rung& coarse = list_[list_.size() - 2];
  const double V0 = value_in(coarse.whole, name);
  if (!std::isfinite(V0)) return {V, NAN, 0.0};
  if (fine.grid == kFineGrid && !given_) return fine_limit(V0, V, coarse.grid[0]);
  const GridLimit L0 = film_limit_of(coarse, name);
  const double before =
      list_.size() > 2 ? L0.value - film_limit_of(list_.front(), name).value : NAN;
  const GridLimit l =
      grid_limit(L0, film_limit_of(fine, name), coarse.grid[1], fine.grid[1], before);
  if (given_) return {V, full_bar(l) + std::abs(l.value - V), 0.0};
  return l;
}

}  // namespace shellback::fidelity
