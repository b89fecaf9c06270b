#include "bearing/case.hpp"

namespace shellback::bearing {

const char* to_string(Tier tier) {
  switch (tier) {
    case Tier::estimate:
      return "estimate";
    case Tier::isothermal:
      return "isothermal";
    case Tier::lumped:
      return "lumped";
    case Tier::thd:
      return "thd";
    case Tier::tehd:
      return "tehd";
    case Tier::automatic:
      return "auto";
  }
  return "unknown";
}

}  // namespace shellback::bearing
