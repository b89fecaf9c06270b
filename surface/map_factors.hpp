#pragma once
/// Flow factors of a measured surface over the gap: surface/patch_flow.hpp solved at every gap.
///
///   h(x, y) = H sigma - z,  sigma = Rq of the map;  H = h/sigma from mean plane to smooth wall
///   average_gap = hT/sigma = <h>/sigma               phi_f  = H sigma <1/h>
///   phi_x = <h^3 dP/dx>/(H sigma)^3                  phi_fp = <h dP/dx>/(H sigma)
///   phi_s = (hT - 2 <flow>)/sigma                    phi_fs = H sigma <h/2 dp/dx>
/// phi_z: phi_x of the map with x and y exchanged. Means are over the whole nominal area.
///
/// Contact. Where the gap is below sigma/100 (the cut-off of Patir and Cheng's phi_f) the surfaces
/// touch: the cell lets nothing through and shears no oil. Nothing deforms: as Patir and Cheng, the
/// map is cut off at the wall.
///
/// Standard errors: of the four quarters of the map, each a map of its own (mean plane, Rq), over
/// sqrt 4. They are those of this surface's own scatter (and of the ends of the quarters), not of
/// the pitch.
///
/// Sources: Patir and Cheng 1978, 1979; Almqvist et al. for the cell problem (textbook).
#include <atomic>
#include <functional>
#include <vector>

#include "fluid/measured_factors.hpp"
#include "surface/height_map.hpp"
#include "surface/patch_flow.hpp"

namespace shellback::surface {

/// The factors at one gap; as the columns of fluid::FactorTable.
struct FactorRow {
  double H = 0.0;            ///< h/sigma [-]
  double contact = 0.0;      ///< part of the area in contact [-]
  double average_gap = 0.0;  ///< hT/sigma [-]
  double phi_x = 0.0, phi_z = 0.0, phi_s = 0.0, phi_f = 0.0, phi_fs = 0.0, phi_fp = 0.0;  ///< [-]
};

/// A factor and what the size of the map leaves open of it.
struct FactorRows {
  std::vector<FactorRow> rows;
  std::vector<FactorRow> errors;  ///< standard errors, same order; H is that of the row
};

struct FactorOptions {
  PatchEnds ends = PatchEnds::patch;
  int threads = 1;
  std::function<void(int done, int of)> progress{};
  const std::atomic<bool>* stop = nullptr;
};

/// Touching gap over sigma [-].
inline constexpr double kTouching = 0.01;

/// One gap. `sigma` > 0; map without holes, mean 0.
[[nodiscard]] FactorRow factors_at(const HeightMap& map, double sigma, double H, PatchEnds ends);

/// All gaps (positive, rising). Empty rows if `stop` was set meanwhile.
[[nodiscard]] FactorRows map_factors(const HeightMap& map, double sigma,
                                     const std::vector<double>& H, const FactorOptions& options);

/// What still counts as flow, over sigma^3 [-]. One channel of a single cell at the touching gap,
/// straight through the largest map (2000 points across), lets 0.01^3/2000 = 5e-10 through; less is
/// not told from round-off (measured: 1e-13 of the largest gap^3 on 1200 x 600 square cells, 1e-9
/// with pitches of 1 to 100).
inline constexpr double kOpen = 1e-10;

/// True if oil passes both ways.
[[nodiscard]] bool is_open(const FactorRow& row);

/// The rows that a case can take: those above the largest gap that is not open. A surface whose
/// factors contradict each other gives a table that fluid::fault_of names.
[[nodiscard]] fluid::FactorTable factor_table(const std::vector<FactorRow>& rows, double sigma);

}  // namespace shellback::surface
