#pragma once
/// What a cell of the stability map cannot tell by itself: rows are judged by what stands beside.
#include "validation/stress/stress_row.hpp"

namespace shellback::validation {

/// In this order:
/// - a quantity that breaks the scene's trend along the default's cells is wrong;
/// - a refusal beside a steady state is a wrong refusal, or missed
/// (validation/stress/stress_refusal.hpp);
/// - a refusal or a result against the scene's expectation likewise;
/// - a result that differs from the default's by more than is allowed is wrong, unless the
///   difference is one of convention; two others on the same equations that agree with each other
///   against the default make it the default that is wrong.
void judge_row(StressRow& row);

}  // namespace shellback::validation
