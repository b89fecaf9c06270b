#pragma once
/// The scenes of the benchmark, made directly; the numbers are those of the shipped cases of the
/// same names, whose comments tell which are known and which assumed.
#include <array>
#include <string>

#include "bearing/case.hpp"

namespace shellback::bench {

/// "raimondi-boyd", "thd-plain-bearing" or "ks-rig-test-bearing" on nt x nz cells.
[[nodiscard]] bearing::Case scene(const std::string& name, std::array<int, 2> grid);

/// Over two turns: a turning load of 0.15 `pulse` and, in the middle, a pulse downwards, a spline
/// through rows of five degrees; journal of 1 kg.
[[nodiscard]] bearing::LoadCycle pulse_over_two_turns(double omega, double pulse);

}  // namespace shellback::bench
