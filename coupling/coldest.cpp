#include "coupling/coldest.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/solids.hpp"

namespace shellback::coupling {

double coldest_around(const BearingModel& model) {
  double coldest = model.solids->surroundings();
  for (const Supply& supply : model.input.supplies) coldest = std::min(coldest, supply.temperature);
  const auto& shaft = model.input.shaft;
  if (shaft && shaft->overhang > 0.0) coldest = std::min(coldest, shaft->ambient);
  return coldest;
}

}  // namespace shellback::coupling
