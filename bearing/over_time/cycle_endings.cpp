#include "bearing/over_time/cycle_endings.hpp"

#include <algorithm>
#include <utility>

namespace shellback::bearing {

void Closure::add(double difference) {
  earlier = before;
  before = last;
  last = difference;
}

namespace {

constexpr double kSlowest = 0.99;  ///< slower is not seen from noise

/// One difference tells no rate: it may be the slowest.
double rate_of(const Closure& c) {
  if (!std::isfinite(c.before)) return kSlowest;
  const double of_two = std::isfinite(c.earlier) ? std::sqrt(c.last / c.earlier) : 0.0;
  return std::clamp(std::max(of_two, c.last / c.before), c.rate, kSlowest);
}

}  // namespace

void Closure::lead_on() {
  rate = 0.0;  // that of these cycles counts, not that of earlier ones
  *this = {NAN, NAN, NAN, rate_of(*this)};
}

double Closure::left() const {
  const double rho = rate_of(*this);
  return last * std::max(std::isfinite(earlier) ? 0.0 : 1.0, rho / (1.0 - rho));
}

double left_after(double apart, int cycles) { return apart * kSlowest / (1.0 - kSlowest) / cycles; }

Verdict at_instant(Verdict v, const ending::NoStep& where) {
  // What is to be reported as a defect, or was stopped, is nothing of the step's.
  if (v.status == Status::interrupted || v.status == Status::invalid_number) return v;
  const FilmPlace place = v.place;
  return {Status::iteration_limit, where, place, {std::move(v)}};
}

}  // namespace shellback::bearing
