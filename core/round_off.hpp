#pragma once
/// What is told apart, and how long an iteration may go on.

namespace shellback {

/// Places and times nearer to each other than this, of the bearing's size or the course's length,
/// are one; eccentricities below it have no direction. A case is read with six to nine digits, and
/// sums over it are known to some hundred times the round-off of 1e-16 [-].
inline constexpr double kRoundOff = 1e-9;

/// Iterations after which there is no hope: one that leaves half of its error from step to step has
/// reached round-off after 53, and this is twice as many. Where it acts the search has failed; its
/// exact number decides nothing.
inline constexpr int kMostIterations = 100;

}  // namespace shellback
