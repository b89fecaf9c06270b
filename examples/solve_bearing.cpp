/// A plain bearing of 100 mm bore, filled by hand: judged, solved, printed. SI units.
#include <cstdio>

#include "app/words/ending_words.hpp"
#include "bearing/judge/judge_case.hpp"
#include "fidelity/solve_case.hpp"

using namespace shellback::bearing;

int main() {
  Case c;
  c.bearing = {.radius = 0.05, .width = 0.08, .radial_clearance = 145e-6};
  c.supplies = {{.kind = SupplyKind::axial_groove,
                 .angle = 1.571,
                 .arc = 0.314,
                 .length = 0.07,
                 .pressure = 70e3,
                 .temperature = 313.15}};
  c.operation = {.omega = 209.4, .position = LoadGiven{.force = 4e3, .angle = 4.712}};
  c.oil.temperature =
      shellback::rheology::ReynoldsSlope{.eta = 0.0277, .at = 313.15, .beta = 0.0341};
  c.oil_temperature = 321.15;  // of the film where it is not computed
  c.shell = Shell{.layers = {{{"bronze", 250.0, 8800.0, 380.0, 110e9, 0.34, 1.8e-5}, 0.05}},
                  .back = ConvectiveBack{.heat_transfer = 80.0, .ambient = 313.15}};
  c.shaft = Shaft{.material = {"steel", 50.0, 7850.0, 460.0, 210e9, 0.3, 1.2e-5}};
  c.model.grid = {100, 13};
  for (const Tier tier : {Tier::isothermal, Tier::thd}) {
    c.model.tier = tier;
    expect_solvable(c);  // throws with key, reason and cure
    const Result r = shellback::fidelity::solve_case(c);
    const Quantities q = r.values();
    std::printf("%-10s %s: friction torque %.3f N m, smallest film %.1f um\n", to_string(tier),
                to_string(r.verdict.status), q.friction_torque, 1e6 * q.h_min);
    if (!r.verdict.good()) std::puts(shellback::app::reason_of(r.verdict).c_str());
  }
}
