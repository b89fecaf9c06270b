#include "fidelity/levels.hpp"

#include <algorithm>

namespace shellback::fidelity {

using namespace coupling;

namespace {

constexpr std::size_t kEnough = 3;  ///< grids: their order can be observed

bool stopped(const SolveControl& control) {
  return control.stop != nullptr && control.stop->load();
}

int cells(const std::array<int, 2>& grid) { return grid[0] * grid[1]; }

std::optional<CoarseSolution> beside(const Solution& s, Tier tier, std::array<int, 2> grid,
                                     const SolveControl& control, KeptSolids* kept) {
  auto found =
      solve_beside(s, tier, grid, kept ? kept->find(s.model.input, grid) : nullptr, control);
  if (found && kept) kept->keep(*found);
  return found;
}

/// On a coarse grid, the quick way first where many near solutions are judged.
std::optional<CoarseSolution> on_coarse(const Solution& s, Tier tier, std::array<int, 2> grid,
                                        const SolveControl& control, KeptSolids* kept) {
  auto found = kept ? beside(s, tier, grid, control, kept)
                    : solve_coarse(s.model.input, tier, grid, control);
  if (found || stopped(control)) return found;
  return kept ? solve_coarse(s.model.input, tier, grid, control)
              : beside(s, tier, grid, control, kept);
}

/// The result's own grid in the place of a coarse one, and a finer one above it.
void take_finer(const Solution& s, Tier tier, const SolveControl& control, KeptSolids* kept,
                Levels& levels) {
  constexpr int kMostCells = 400 * 50;  // beyond, one grid finer takes longer than all else
  const auto own = s.model.input.model.grid;
  if (cells(own) > kMostCells || stopped(control)) return;
  const auto finer = beside(s, tier, next_finer(own), control, kept);
  if (!finer) return;
  levels.all = {{own, quantities_of(s, tier)}, {finer->input.model.grid, finer->quantities}};
  levels.coarse = CoarseSolution{s.model.input, tier, s, quantities_of(s, tier)};
}

}  // namespace

std::shared_ptr<const Solids> KeptSolids::find(const Case& c, std::array<int, 2> grid) const {
  const std::lock_guard lock(guard_);
  const auto fits = [&](const Entry& e) {
    return e.grid == grid && e.shell == c.shell && e.shaft == c.shaft;
  };
  const auto it = std::find_if(entries_.rbegin(), entries_.rend(), fits);
  return it == entries_.rend() ? nullptr : it->solids;
}

void KeptSolids::keep(const CoarseSolution& s) {
  constexpr std::size_t kMost = 16;  // bodies times grids: those of eight materials at a time
  const Case& c = s.input;
  const auto known = find(c, c.model.grid);
  const auto& solids = s.solution.model.solids;
  if (!solids || solids == known) return;
  const std::lock_guard lock(guard_);
  std::erase_if(entries_, [&](const Entry& e) { return e.solids == known; });
  entries_.push_back({c.shell, c.shaft, c.model.grid, solids});
  if (entries_.size() > kMost) entries_.erase(entries_.begin());
}

Levels levels_around(const Solution& s, Tier tier, const SolveControl& control, KeptSolids* kept) {
  Levels out;
  out.all = s.levels;
  for (const auto& grid : coarse_grids(s.model.input)) {
    if (stopped(control)) return out;
    const auto known =
        std::find_if(out.all.begin(), out.all.end(), [&](auto& l) { return l.grid == grid; });
    if (out.coarse && (known != out.all.end() || out.all.size() >= kEnough)) continue;
    auto coarse = on_coarse(s, tier, grid, control, kept);
    if (!coarse) continue;
    if (known != out.all.end()) {
      known->quantities = coarse->quantities;  // to the end, where the ladder stopped early
    } else {
      out.all.push_back({grid, coarse->quantities});
    }
    if (!out.coarse) out.coarse = std::move(coarse);
  }
  if (!out.coarse) take_finer(s, tier, control, kept, out);
  std::sort(out.all.begin(), out.all.end(),
            [](const auto& a, const auto& b) { return cells(a.grid) < cells(b.grid); });
  return out;
}

}  // namespace shellback::fidelity
