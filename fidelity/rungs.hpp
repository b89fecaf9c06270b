#pragma once
/// The grids that tier `auto` has climbed, and what they say of the fine grid.
#include <string>
#include <vector>

#include "coupling/solve.hpp"
#include "fidelity/grid_limit.hpp"

namespace shellback::fidelity {

/// Cells around and along the full width.
using Grid = std::array<int, 2>;

/// Grid of the film alone that follows a full solution on `grid`: more cells around.
[[nodiscard]] Grid film_grid(Grid grid);

/// One full solution and the film on the next grid under its temperatures and deformation.
struct Rung {
  Grid grid{0, 0};
  coupling::Solution solution;
  std::vector<coupling::Quantity> whole{};    ///< V of grid_limit.hpp
  std::vector<coupling::Quantity> refined{};  ///< F; empty: not solved
};

/// The three finest full solutions of the climb.
class Rungs {
 public:
  /// `given`: the user's own grid, whose values are not led on to the fine one.
  explicit Rungs(bool given) : given_(given) {}
  void push(Rung rung);
  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  [[nodiscard]] const Rung& finest() const { return list_.back(); }

  /// A quantity of the fine grid by (2) of grid_limit.hpp, from the finest rungs; the value of the
  /// last with an unknown bar where there is but one. On the user's own grid: its value, and a bar
  /// that holds the distance to the limit.
  [[nodiscard]] GridLimit limit(const std::string& name) const;

 private:
  bool given_;
  std::vector<Rung> list_;  ///< from the coarsest to the finest
};

}  // namespace shellback::fidelity
