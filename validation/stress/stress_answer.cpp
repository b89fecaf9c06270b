#include "validation/stress/stress_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "bearing/bearing.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

constexpr double kMassBound = 1e-8;
constexpr double kEnergyBound = 1e-4;
constexpr double kLoadBound = 1e-6;
constexpr double kMomentBound = 0.05;
constexpr double kCycleLoadBound = 2e-5;  ///< twice what a step is solved to at 1 % tolerance [-]
constexpr double kThetaSlack = 1e-6;      ///< of the solve's tolerance [-]
constexpr double kPressureSlack = 1.0;    ///< [Pa]
/// What the discretisation may undershoot, where the solver itself refuses a little earlier.
constexpr double kRippleLeast = 3.0;      ///< [K]
constexpr double kRippleShare = 0.1;      ///< of the span of temperatures [-]
constexpr double kNoOilAnyMore = 2000.0;  ///< [K]: no oil is a liquid anywhere near it
/// Mirror images differ by where the solves stop, and by a grid that is uniform from phi = 0 on but
/// for the supply's edges [-].
constexpr double kMirrorBound = 1e-3;

void add_range(const char* what, const Field& x, double low, double high, StressAnswer& a) {
  if (x.empty()) return;
  if (!std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); })) {
    a.faults.push_back(fmt::format("{} is not a number somewhere", what));
    a.not_a_number = true;
    return;
  }
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  if (*least < low) a.faults.push_back(fmt::format("{} falls to {:.4g}", what, *least));
  if (*most > high) a.faults.push_back(fmt::format("{} rises to {:.4g}", what, *most));
}

/// The energy imbalance over the largest heat stream instead of the friction power: at tiny speed
/// nearly all heat comes with the oil and goes into the walls, and friction is no measure.
double energy_over_largest_stream(const Result& r) {
  const double power = std::abs(r.value("power_loss"));
  double largest = power;
  for (const char* name : {"heat_by_oil", "heat_to_shell", "heat_to_shaft"}) {
    if (r.has(name)) largest = std::max(largest, std::abs(r.value(name)));
  }
  return largest > 0.0 ? r.audit.energy * power / largest : r.audit.energy;
}

/// `applies`: whether the tier has this balance at all; only then a missing number is a fault.
void add_bound(const char* what, double value, double bound, bool applies, StressAnswer& a) {
  if (!std::isfinite(value)) {
    if (!applies && std::isnan(value)) return;
    a.faults.push_back(fmt::format("the {} audit is not a number", what));
    a.not_a_number = true;
    return;
  }
  if (value > bound) a.faults.push_back(fmt::format("{} audit {:.1e}", what, value));
}

void add_audits(const Case& c, const Result& r, StressAnswer& a) {
  const bool loaded = std::holds_alternative<LoadGiven>(c.operation.position);
  const bool heated = physics_of(c, r.tier).film_energy;
  add_bound("mass", r.audit.mass, kMassBound, true, a);
  add_bound("energy", energy_over_largest_stream(r), kEnergyBound, heated, a);
  // In time a film is solved to a hundredth of a step's error (cycle_search.cpp).
  const double load_bound = c.cycle ? kCycleLoadBound : kLoadBound;
  add_bound("load", r.audit.load, load_bound, loaded, a);
  add_bound("moment", r.audit.moment, kMomentBound, !c.cycle, a);
}

/// The coldest of all temperatures given.
double coldest_given(const Case& c) {
  double T = INFINITY;
  for (const Supply& s : c.supplies) T = std::min(T, s.temperature);
  if (c.oil_temperature) T = std::min(T, *c.oil_temperature);
  if (c.measured.shell_back_temperature) T = std::min(T, *c.measured.shell_back_temperature);
  if (c.shell) {
    const auto* back = std::get_if<ConvectiveBack>(&c.shell->back);
    T = std::min(
        T, back != nullptr ? back->ambient : std::get<PrescribedBack>(c.shell->back).temperature);
  }
  if (c.shaft && c.shaft->overhang > 0.0) T = std::min(T, c.shaft->ambient);
  return T;
}

void compare_mirror(const Result& result, const Result& mirror, StressAnswer& a) {
  if (mirror.verdict.status == Status::iteration_limit && result.verdict.good()) {
    a.status = to_string(mirror.verdict.status);  // not found is no contradiction
    a.reason = "its mirror image was not found: " + app::reason_of(mirror.verdict);
    return;
  }
  if (result.verdict.status == Status::iteration_limit && !mirror.verdict.good()) return;
  if (result.verdict.status != mirror.verdict.status) {
    a.faults.push_back(
        fmt::format("its mirror image ended otherwise: {}", to_string(mirror.verdict.status)));
    return;
  }
  if (!result.verdict.good()) return;
  for (const char* name :
       {"friction_torque", "h_min", "p_max", "side_flow", "eccentricity_ratio", "T_film_max"}) {
    if (!result.has(name)) continue;
    const double ours = std::abs(result.value(name));
    const double theirs = std::abs(mirror.value(name));
    if (std::abs(ours - theirs) <= kMirrorBound * std::max(ours, theirs)) continue;
    a.faults.push_back(fmt::format("{} is {:.6g}, in its mirror image {:.6g}", name, ours, theirs));
  }
}

double other_side(double phi) { return phi == 0.0 ? 0.0 : 2.0 * kPi - phi; }

Profile mirrored(const Profile& p) {
  const std::size_t n = p.phi.size();
  const std::size_t m = p.z.size();
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return other_side(p.phi[a]) < other_side(p.phi[b]);
  });
  Profile out;
  out.z = p.z;
  for (const std::size_t i : order) {
    out.phi.push_back(other_side(p.phi[i]));
    for (std::size_t k = 0; k < m; ++k) out.height.push_back(p.height[i * m + k]);
  }
  return out;
}

}  // namespace

namespace {

/// By how the branch has ended on the grid of the answer.
bool meets_bound(const Verdict& v) {
  if (v.as<ending::LimitMoves>() != nullptr) return meets_bound(v.cause.front());
  const auto* branch = v.as<ending::BranchEnded>();
  return branch != nullptr && branch->end == ending::BranchEnd::unbounded;
}

}  // namespace

bool StressAnswer::converged() const { return status == to_string(Status::converged); }

double StressAnswer::value(const std::string& name) const {
  for (const auto& [known, x] : quantities) {
    if (known == name) return x;
  }
  return NAN;
}

Case mirrored(const Case& c) {
  Case m = c;
  m.operation.omega = -c.operation.omega;
  for (Supply& s : m.supplies) s.angle = other_side(s.angle);
  if (auto* load = std::get_if<LoadGiven>(&m.operation.position)) load->angle = -load->angle;
  if (auto* given = std::get_if<EccentricityGiven>(&m.operation.position)) {
    given->load_angle = -given->load_angle;
  }
  if (auto* tilt = std::get_if<TiltGiven>(&m.operation.alignment)) tilt->about_x *= -1.0;
  if (auto* moment = std::get_if<MomentGiven>(&m.operation.alignment)) moment->about_x *= -1.0;
  if (m.bearing.profile) m.bearing.profile = mirrored(*m.bearing.profile);
  return m;
}

void look_through(const Case& c, const Result& r, StressAnswer& a) {
  for (const Quantity& q : r.quantities) {
    if (std::isfinite(q.value)) continue;
    a.faults.push_back(q.name + " is not a number");
    a.not_a_number = true;
  }
  const double inf = INFINITY;
  const bool rough = c.surfaces.shell.roughness > 0.0 || c.surfaces.shaft.roughness > 0.0;
  add_range("theta", r.fields.theta, -kThetaSlack, 1.0 + kThetaSlack, a);
  add_range("p", r.fields.p, c.model.cavitation_pressure - kPressureSlack, inf, a);
  add_range("the gap", r.fields.h, rough ? -inf : 0.0, inf, a);
  const double hottest =
      r.fields.T.empty() ? 0.0 : *std::max_element(r.fields.T.begin(), r.fields.T.end());
  const double low = coldest_given(c) - kRippleLeast - kRippleShare * (hottest - coldest_given(c));
  add_range("the film temperature", r.fields.T, low, kNoOilAnyMore, a);
  add_range("the shell temperature", r.fields.T_shell_surface, low, kNoOilAnyMore, a);
  add_range("the shear stress", r.fields.tau_journal, -inf, inf, a);
  add_audits(c, r, a);
}

StressAnswer solve_stress_case(const StressScene& scene, const std::vector<std::string>& words) {
  StressAnswer a;
  try {
    std::vector<app::Override> changes;
    for (const std::string& word : words) changes.push_back(app::parse_override(word));
    changes.push_back({"model.tier", fmt::format("\"{}\"", to_string(scene.tier)), "--tier"});
    const Case c = with_rivals(app::read_case(scene.case_path, changes));
    const Result result = c.cycle ? as_result(solve_cycle(c, c.model.tier)) : solve(c);
    a.status = to_string(result.verdict.status);
    const app::EndingWords words = app::words_of(result.verdict);
    a.reason = words.reason;
    a.place = words.place;
    a.meets_bound = meets_bound(result.verdict);
    a.audit = result.audit;
    a.wall_s = result.cost.wall_s;
    for (const Quantity& q : result.quantities) a.quantities.emplace_back(q.name, q.value);
    if (result.verdict.good()) look_through(c, result, a);
    if (scene.mirror) compare_mirror(result, solve(mirrored(c)), a);
  } catch (const InputError& error) {
    a.status = kRefusedInput;
    a.reason = error.what();
  }
  return a;
}

std::string to_text(const StressAnswer& a) {
  nlohmann::json j;
  j["status"] = a.status;
  j["reason"] = a.reason;
  j["place"] = a.place;
  j["audit"] = {a.audit.mass, a.audit.energy, a.audit.load, a.audit.moment};
  j["quantities"] = a.quantities;
  j["faults"] = a.faults;
  j["not_a_number"] = a.not_a_number;
  j["meets_bound"] = a.meets_bound;
  j["wall_s"] = a.wall_s;
  return j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

StressAnswer answer_from(const std::string& text) {
  const auto number = [](const nlohmann::json& j) {
    return j.is_number() ? j.get<double>() : NAN;  // JSON has no not-a-number
  };
  const nlohmann::json j = nlohmann::json::parse(text);
  StressAnswer a;
  a.status = j.at("status");
  a.reason = j.at("reason");
  a.place = j.at("place");
  const auto& audit = j.at("audit");
  a.audit = {number(audit[0]), number(audit[1]), number(audit[2]), number(audit[3])};
  for (const auto& q : j.at("quantities")) a.quantities.emplace_back(q[0], number(q[1]));
  a.faults = j.at("faults").get<std::vector<std::string>>();
  a.not_a_number = j.at("not_a_number");
  a.meets_bound = j.at("meets_bound");
  a.wall_s = number(j.at("wall_s"));
  return a;
}

}  // namespace shellback::validation
