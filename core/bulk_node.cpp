#include "core/bulk_node.hpp"

#include "core/gauss_lobatto.hpp"

namespace shellback {

CrossFilmNodes bulk_node() {
  CrossFilmNodes set = gauss_lobatto(3);  // Simpson's rule: exact for the fluidity integrals
  set.w = {0.0, 1.0, 0.0};
  set.D.assign(9, 0.0);  // no flow across: one temperature
  set.S = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  set.A = {4.0, -6.0, 2.0, -6.0, 12.0, -6.0, 2.0, -6.0, 4.0};
  set.one_temperature = true;
  return set;
}

}  // namespace shellback
