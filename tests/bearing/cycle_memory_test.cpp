// What a hundred cycles leave in memory.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "bearing/over_time/cycle_search.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Resident memory of this process (proc(5), statm) [B].
double resident() {
  double all = 0.0;
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST_CASE("MemoryIsFlatOverAHundredCycles", "[cycle]") {
  for (const bool elastic : {false, true}) {
    Case c = warm_case();
    c.oil.temperature = rheology::ConstantViscosity{0.015};
    c.oil_temperature = 313.15;
    c.model.switches.elastic_deformation = elastic;
    LoadCycle cycle;
    cycle.period = 4.0 * kPi / c.operation.omega;
    for (int k = 0; k < 24; ++k) {
      cycle.t.push_back(cycle.period * k / 24);
      cycle.x.push_back(1e3 * std::cos(2.0 * kPi * k / 24));
      cycle.y.push_back(1e3 * std::sin(2.0 * kPi * k / 24) - 1e3);
    }
    cycle.journal_mass = 0.5;
    c.cycle = cycle;
    c.model.grid = elastic ? std::array{32, 5} : std::array{48, 8};
    c.model.tolerance = 0.03;  // long steps
    const SolveControl control;
    CycleSearch search(c, Tier::isothermal, control);
    search.begin(313.15);
    const auto pass_until = [&](int cycles) {
      while (search.cycles() < cycles) REQUIRE(search.search(false).good());
      return resident();
    };
    const double after_ten = pass_until(10);
    const double after_hundred = pass_until(100);
    INFO("resident after 10 cycles " << 1e-6 * after_ten << " MB, after 100 "
                                     << 1e-6 * after_hundred << " MB");
#ifndef __SANITIZE_ADDRESS__  // which holds back what is freed
    // One record of a cycle is 0.2 MB here or more; one kept per cycle would be 18 MB.
    CHECK(after_hundred - after_ten < 1e6);
#endif
  }
}
