#pragma once
/// All that `shellback surface` finds out about one height map.
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/reading/read_height_map.hpp"
#include "surface/contact_curve.hpp"
#include "surface/correlation.hpp"
#include "surface/form.hpp"
#include "surface/height_statistics.hpp"
#include "surface/holes.hpp"
#include "surface/map_factors.hpp"
#include "surface/summits.hpp"

namespace shellback::app {

struct SurfaceOptions {
  std::string path;
  Motion motion = Motion::x;
  int form = 2;           ///< degree of the form that is removed
  bool fill = false;      ///< holes by harmonic interpolation; else they are refused
  double error = 0.1;     ///< largest relative standard error of Rq that is allowed [-]
  bool periodic = false;  ///< the map repeats itself at its sides
  std::vector<double> gaps{0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5,
                           3.0, 4.0,  5.0, 6.0,  8.0, 10.0};  ///< h/sigma [-]
  std::optional<double> modulus{};                            ///< E* [Pa]
  std::optional<double> hardness{};                           ///< of the softer surface [Pa]
  int threads = 1;
  std::function<void(int, int)> progress{};
  const std::atomic<bool>* stop = nullptr;
};

struct SurfaceReport {
  SurfaceOptions options;
  surface::HeightMap map;  ///< without form, holes filled, mean 0; x along the motion
  surface::Holes holes;
  surface::Form form;
  surface::HeightStatistics heights;
  surface::Correlation correlation;
  surface::SpectralMoments moments;
  surface::SummitStatistics by_moments, counted;
  std::size_t summits = 0;  ///< counted
  std::vector<surface::ContactRow> contact;
  surface::FactorRows factors;     ///< rows empty: interrupted
  fluid::FactorTable table;        ///< the rows that a case can take
  fluid::FactorFault fault;        ///< why it cannot
  std::vector<std::string> notes;  ///< what the numbers do not tell of themselves
};

inline constexpr double kRound = 1.5;  ///< longest over shortest length: hardly a lay below [-]

/// Whether heights are longer one way than another by so much that they have a lay.
[[nodiscard]] inline bool has_lay(const surface::Correlation& c) {
  return (c.longest.at_least && !c.shortest.at_least) ||
         c.longest.length > kRound * c.shortest.length;
}

/// Reads, judges and solves. Throws FileError and InputError (app/reading/read_height_map.hpp):
/// holes without `fill` or more than a tenth of them, a form that the map does not determine,
/// heights that are nothing but form, slopes that no machined surface has, a patch too small for
/// its own correlation lengths.
[[nodiscard]] SurfaceReport describe_surface(const SurfaceOptions& options);

}  // namespace shellback::app
