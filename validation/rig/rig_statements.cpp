#include "validation/rig/rig_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rheology/viscosity.hpp"

namespace shellback::validation {
namespace {

constexpr double kHigh = 80e3;  ///< 100 MPa [N]
constexpr double kLow = 40e3;   ///< 50 MPa [N]
constexpr double kSlowest = 1000.0;
constexpr double kFastest = 7000.0;
constexpr double kStands = 1e-6;  ///< of the largest speed: as much as tables have [-]
constexpr double kFast = 5000.0;  ///< "above 5000 rpm"

/// Within [low, high]; not known if the value is none.
Met within(double value, double low, double high) {
  if (std::isnan(value)) return Met::unknown;
  return value >= low && value <= high ? Met::yes : Met::no;
}

/// Words of a value, or that there is none.
std::string told(double value, std::string words) {
  return std::isnan(value) ? "not solved" : std::move(words);
}

std::string told_full_film(double t) {
  return std::isnan(t) ? "asperities rub to the end" : fmt::format("{:.3g} s", t);
}

/// Smallest and largest of what is known.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  int count = 0;
  int missing = 0;
  void take(double v) {
    if (std::isnan(v)) {
      ++missing;
      return;
    }
    low = std::min(low, v);
    high = std::max(high, v);
    ++count;
  }
  [[nodiscard]] bool known() const { return count > 0 && missing == 0; }
  [[nodiscard]] std::string words(const char* unit, double factor = 1.0) const {
    const std::string gaps = missing > 0 ? fmt::format(" ({} not solved)", missing) : "";
    return count == 0
               ? "not solved"
               : fmt::format("{:.3g} to {:.3g}{}{}", factor * low, factor * high, unit, gaps);
  }
  [[nodiscard]] Met in(double a, double b) const {
    if (count > 0 && (low < a || high > b)) return Met::no;
    return known() ? Met::yes : Met::unknown;
  }
};

class Judge {
 public:
  explicit Judge(const RigStudy& study) : s_(study) {}

  std::vector<RigStatement> all() {
    pressures();
    shear();
    effects();
    hysteresis();
    starts();
    return std::move(list_);
  }

 private:
  void add(const char* section, const char* words, const char* range, std::string ours, Met met) {
    list_.push_back({section, words, range, std::move(ours), met});
  }
  [[nodiscard]] double torque(double peak, double rpm, OilModel oil, double warmer = 0.0) const {
    const RigPoint* p = s_.point(peak, rpm, oil, warmer);
    return p == nullptr ? NAN : p->torque();
  }
  /// Of the test bearing, full oil; 0 where it was not solved: none.
  [[nodiscard]] double test(double peak, double rpm, double RigCycle::*value) const {
    const RigPoint* p = s_.point(peak, rpm, OilModel::full);
    return p == nullptr || !p->cycle[0].verdict.good() ? NAN : p->cycle[0].*value;
  }
  /// a - b over the plan's speeds above `above`.
  [[nodiscard]] Range differences(double peak, OilModel a, OilModel b, double above) const {
    Range range;
    for (const double rpm : s_.plan.rpm) {
      if (rpm > above) range.take(torque(peak, rpm, a) - torque(peak, rpm, b));
    }
    return range;
  }

  void pressures();
  void shear();
  void effects();
  void hysteresis();
  void starts();

  const RigStudy& s_;
  std::vector<RigStatement> list_;
};

void Judge::pressures() {
  Range p;
  for (const double rpm : s_.plan.rpm) p.take(test(kHigh, rpm, &RigCycle::p_max));
  const double specific = kHigh / s_.specific_area;
  Range over;
  if (p.count > 0) {
    over.take(p.low / specific);
    over.take(p.high / specific);
  }
  over.missing = p.missing;
  add("4.1.2", "peak film pressure around 200 MPa at 100 MPa: twice the specific load",
      "1.8 to 2.2 at every speed (\"around\": 10 %)", over.words("") + ", " + p.words(" MPa", 1e-6),
      over.in(1.8, 2.2));
  const double spread = p.count > 0 ? p.high / p.low - 1.0 : NAN;
  add("4.1.2", "peak film pressure independent of the speed", "largest over smallest below 1.10",
      told(spread, fmt::format("{:.3g}", 1.0 + spread)),
      p.missing > 0 ? Met::unknown : within(spread, 0.0, 0.1));
  const bearing::Case c =
      rig_isothermal_case(RigBearing::test, {kHigh, kFastest, s_.plan.grid, nullptr, 0},
                          OilModel::pressure, s_.plan.T_start);
  const auto thicker = [&](double pressure) {
    return rheology::viscosity(c.oil, s_.plan.T_start, pressure) /
           rheology::viscosity(c.oil, s_.plan.T_start, 0.0);
  };
  Range factor;
  if (p.count > 0) factor.take(thicker(p.high));
  factor.missing = p.missing + (p.count > 0 ? 0 : 1);
  add("4.1.2", "viscosity there nearly seven times that at ambient pressure", "6.3 to 7.7 (10 %)",
      factor.words(" times at our peak") + fmt::format("; {:.3g} at 200 MPa", thicker(200e6)),
      factor.in(6.3, 7.7));
}

void Judge::shear() {
  const double fast = test(kHigh, kFastest, &RigCycle::shear);
  const double slow = test(kHigh, kSlowest, &RigCycle::shear);
  add("4.1.2", "largest shear rate 2.2e7 1/s at 7000 rpm", "1.8e7 to 2.6e7 1/s (20 %)",
      told(fast,
           fmt::format("{:.2e} 1/s (mid-width: the worn edges of theirs are not in ours)", fast)),
      within(fast, 1.8e7, 2.6e7));
  add("4.1.2", "ten times smaller at 1000 rpm", "7 to 14 times (told without digits)",
      told(fast / slow, fmt::format("{:.3g} times", fast / slow)), within(fast / slow, 7.0, 14.0));
  const double T = test(kHigh, kFastest, &RigCycle::T);
  double lost = NAN;
  if (!std::isnan(fast)) {
    const bearing::Case c = rig_isothermal_case(
        RigBearing::test, {kHigh, kFastest, s_.plan.grid, nullptr, 0}, OilModel::full, T);
    lost = 1.0 -
           rheology::viscosity_slopes(c.oil, T, 0.0, fast).eta / rheology::viscosity(c.oil, T, 0.0);
  }
  add("4.1.2", "viscosity lost at the largest shear rate: 25 %", "20 to 30 %",
      told(lost, fmt::format("{:.3g} %", 100.0 * lost)), within(lost, 0.2, 0.3));
}

void Judge::effects() {
  const auto high = differences(kHigh, OilModel::pressure, OilModel::temperature, 0.0);
  const auto low = differences(kLow, OilModel::pressure, OilModel::temperature, 0.0);
  Range both = high;
  if (low.count > 0) {
    both.take(low.low);
    both.take(low.high);
  }
  both.missing += low.missing;
  add("4.1.2", "pressure dependence raises the torque everywhere", "above 0 at every point",
      both.words(" N m"), both.in(0.0, 1e9));
  Range larger;
  for (const double rpm : s_.plan.rpm) {
    const auto by = [&](double peak) {
      return torque(peak, rpm, OilModel::pressure) / torque(peak, rpm, OilModel::temperature) - 1.0;
    };
    larger.take(by(kHigh) / by(kLow));
  }
  add("4.1.2", "its effect is larger at 80 kN than at 40 kN", "relative effects: ratio above 1",
      larger.words(" times"), larger.in(1.0, 1e9));
  for (const double peak : {kHigh, kLow}) {
    const auto thin = differences(peak, OilModel::pressure, OilModel::full, kFast);
    add("4.1.2",
        peak == kHigh ? "above 5000 rpm shear thinning takes about 0.15 N m, at 80 kN"
                      : "the same at 40 kN",
        "0.10 to 0.20 N m at 6000 and 7000 rpm (one digit and a half)", thin.words(" N m"),
        thin.in(0.10, 0.20));
  }
  const double slow =
      torque(kHigh, kSlowest, OilModel::pressure) - torque(kHigh, kSlowest, OilModel::full);
  add("4.1.2", "shear thinning is almost negligible at 1000 rpm", "below 0.05 N m, a third of that",
      told(slow, fmt::format("{:.3g} N m", slow)), within(slow, -0.05, 0.05));
  Range neither;
  for (const double rpm : s_.plan.rpm) {
    neither.take(std::abs(
        torque(kHigh, rpm, OilModel::temperature) / torque(kHigh, rpm, OilModel::full) - 1.0));
  }
  add("5",
      "neglecting both effects costs up to 15 % (theirs against measurements, ours against the "
      "full model)",
      "largest 10 to 20 %", neither.words(" %", 100.0),
      neither.known() ? within(neither.high, 0.10, 0.20) : Met::unknown);
}

void Judge::hysteresis() {
  const RigCourse* course = s_.course(kHigh);
  Range warmer;
  Range lower;
  for (std::size_t k = 0; course != nullptr && k < course->highest(); ++k) {
    const std::size_t down = course->down_from(k);
    const bearing::Instant* a = course->at(RigBearing::test, k);
    const bearing::Instant* b = course->at(RigBearing::test, down);
    warmer.take(a == nullptr || b == nullptr ? NAN : b->T_shell_back - a->T_shell_back);
    lower.take(course->torque(k) - course->torque(down));
  }
  add("4.1.2", "run-down 3 K warmer than run-up (first principles: bodies in time)", "2 to 4 K",
      warmer.words(" K, test bearing's back"), warmer.in(2.0, 4.0));
  add("4.1.2", "run-down torque about 0.2 N m lower (first principles)", "0.1 to 0.3 N m",
      lower.words(" N m"), lower.in(0.1, 0.3));
  Range warm;
  for (const double rpm : s_.plan.rpm) {
    warm.take(torque(kHigh, rpm, OilModel::full) -
              torque(kHigh, rpm, OilModel::full, s_.plan.warmer));
  }
  add("4.1.2", "3 K warmer means about 0.2 N m less (isothermal, as theirs)", "0.1 to 0.3 N m",
      warm.words(" N m"), warm.in(0.1, 0.3));
}

/// While the journal slows down a smallest torque and a larger one behind it, the two whose ratio
/// is largest: in the end every torque falls, with the friction of summits that stop to slide.
std::array<double, 2> rise_at_stop(const RigStart& s) {
  const auto slower = [](const RigInstant& a, const RigInstant& b) { return a.omega < b.omega; };
  auto i = std::max_element(s.series.begin(), s.series.end(), slower);
  std::array<double, 2> rise{std::numeric_limits<double>::infinity(), 0.0};
  if (i == s.series.end()) return rise;
  rise = {i->torque, i->torque};
  const double stands = kStands * i->omega;
  for (double least = i->torque; i != s.series.end() && i->omega > stands; ++i) {
    least = std::min(least, i->torque);
    if (i->torque * rise[0] > rise[1] * least) rise = {least, i->torque};
  }
  return rise;
}

void Judge::starts() {
  if (s_.starts.size() < 2) return;
  const RigStart& fresh = s_.starts[0];
  const RigStart& worn = s_.starts[1];
  const bool known = !fresh.series.empty() && !worn.series.empty();
  const double ratio = known ? fresh.breakaway / fresh.boundary : NAN;
  add("4.4.2", "breakaway torque is set by the boundary friction coefficient",
      "mu times the sum of F R of three bearings, within 5 %",
      fmt::format("{:.4g} N m, {:.3f} of it", fresh.breakaway, ratio), within(ratio, 0.95, 1.05));
  const double same = known ? worn.breakaway / fresh.breakaway : NAN;
  add("4.4.2", "breakaway torque the same for both roughnesses", "within 1 %",
      fmt::format("worn over new {:.4f}", same), within(same, 0.99, 1.01));
  for (const RigStart* start : {&fresh, &worn}) {
    const double t = start->worn ? 1.5 : 2.0;
    add("4.4.2",
        start->worn ? "full film at 1.5 s with the worn surface"
                    : "full film at 2.0 s with the new surface",
        "+- 0.3 s; asperities below a hundredth of the breakaway torque",
        start->series.empty() ? "not solved" : told_full_film(start->full_film),
        !start->series.empty() && std::isnan(start->full_film)
            ? Met::no
            : within(start->full_film, t - 0.3, t + 0.3));
  }
  const auto a = rise_at_stop(fresh);
  const auto b = rise_at_stop(worn);
  const bool rise = a[1] > 2.0 * a[0] && b[1] > 2.0 * b[0];
  const Met met = !known ? Met::unknown : rise && b[1] < a[1] ? Met::yes : Met::no;
  add("4.4.2", "torque rises before the stop, less with the worn surface",
      "from its smallest while slowing down to more than twice of it before the stop; worn below "
      "new",
      fmt::format("new {:.3g} to {:.3g}, worn {:.3g} to {:.3g} N m", a[0], a[1], b[0], b[1]), met);
}

}  // namespace

const char* to_string(Met met) {
  switch (met) {
    case Met::yes:
      return "met";
    case Met::no:
      return "not met";
    case Met::unknown:
      return "not known";
  }
  return "";
}

std::vector<RigStatement> rig_statements(const RigStudy& study) { return Judge(study).all(); }

}  // namespace shellback::validation
