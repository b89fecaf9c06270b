#include "bearing/over_time/led_oil.hpp"

#include <utility>

namespace shellback::bearing {
namespace {

constexpr int kOrbits = 3;  ///< cycles in which the journal finds its orbit
/// Behind each time that oil is led on: cycles in which the film follows, and those that count.
constexpr int kFollowing = 2;
constexpr int kCounted = 3;
constexpr std::size_t kLeading = 8;  ///< last cycles that lead on

}  // namespace

void LedOil::begin(std::vector<double> oil) {
  counted_.clear();
  begun_ = std::move(oil);
}

std::optional<std::vector<double>> LedOil::after(std::vector<double> oil, int cycles) {
  const bool followed = plain_ > kFollowing && cycles > kOrbits;
  if (followed) counted_.push_back({std::move(begun_), oil});
  if (counted_.size() > kLeading) counted_.erase(counted_.begin());
  begun_ = std::move(oil);
  const bool enough =
      plain_ >= kFollowing + kCounted && static_cast<int>(counted_.size()) >= kCounted;
  return enough ? extrapolated(counted_) : std::nullopt;
}

void LedOil::led_to(std::vector<double> oil) {
  begun_ = std::move(oil);
  plain_ = 0;
}

}  // namespace shellback::bearing
