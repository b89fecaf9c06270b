#include "validation/shells/shells_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/cycle_axis.hpp"
#include "app/library.hpp"
#include "app/overrides.hpp"
#include "app/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "fidelity/cycle_bars.hpp"

namespace shellback::validation {
namespace {

using bearing::Case;
using bearing::CycleResult;
using bearing::Tier;

constexpr const char* kPlace = "study shells";
constexpr std::array kTiers{Tier::tehd, Tier::isothermal};

struct Setting {
  std::array<int, 2> grid;
  double rpm = 2000.0;
  double factor = 1.0;
};

Case case_of(int shell, Tier tier, const Setting& s) {
  const std::vector<app::Override> set{
      {"model.grid", fmt::format("[{}, {}]", s.grid[0], s.grid[1]), kPlace},
      {"model.tier", tier == Tier::tehd ? "tehd" : "isothermal", kPlace},
      {"operation.speed", fmt::format("{:.10g} rpm", s.rpm), kPlace},
      {"load_cycle.factor", fmt::format("{:.10g}", s.factor), kPlace}};
  return app::read_case(app::case_path(shell_kinds()[shell].file).string(), set);
}

/// What the cycle meets first: no periodic state, a lining too hot, a film too thin.
ShellLimit limit_of(int shell, const Case& c, const CycleResult& r) {
  if (!r.verdict.good()) return ShellLimit::state;
  const double T = bearing::value_of(r, "T_shell_max");
  if (std::isfinite(T) && T > shell_kinds()[shell].T_limit) return ShellLimit::lining;
  return bearing::value_of(r, "h_min") < least_film(c) ? ShellLimit::film : ShellLimit::none;
}

LoadTried tried(double factor, const CycleResult& r) {
  if (!r.verdict.good()) return {factor, NAN, NAN};
  return {factor, bearing::value_of(r, "h_min"), bearing::value_of(r, "T_shell_max")};
}

/// Where the limit is met, here and on two thirds of the cells. Edges and mouths leave an error of
/// first order: what is missing on this grid is twice the difference.
void add_bar(const ShellsPlan& plan, StudyCrew& crew, Capability& c) {
  constexpr double kCells = 1.5, kBar = 2.0;  // h/(1.5 h - h)
  const Case subject = case_of(c.shell, c.tier, {plan.coarse, c.rpm, 1.0});
  const auto met_by = [&](ShellLimit limit, const LoadTried& good, const LoadTried& bad) {
    return load_met(limit, good, bad, least_film(subject), shell_kinds()[c.shell].T_limit);
  };
  const auto met = [&](const LoadTried& good, const LoadTried& bad) {
    return met_by(c.limit, good, bad);
  };
  // The last load may break both bounds: what is met first is at the lesser load.
  const bool hot = c.limit == ShellLimit::lining && c.bad.h < least_film(subject);
  if (hot && met_by(ShellLimit::film, c.good, c.bad) < met(c.good, c.bad)) {
    c.limit = ShellLimit::film;
  }
  c.met = met(c.good, c.bad);
  if (!std::isfinite(c.met)) return;
  const auto coarser = [&](const LoadTried& at) {
    Setting s{plan.coarse, c.rpm, at.factor};
    for (int& n : s.grid) n = std::max(3, static_cast<int>(std::lround(n / kCells)));
    const Case on = case_of(c.shell, c.tier, s);
    return tried(at.factor, bearing::solve_cycle(on, c.tier, crew.control()));
  };
  if (crew.stopped()) return;
  const LoadTried good = coarser(c.good);
  if (crew.stopped()) return;
  c.met_error = kBar * std::abs(met(good, coarser(c.bad)) - c.met);
}

/// Bisection of ln(factor) between a load that is borne and one that is not.
void find_capability(const ShellsPlan& plan, StudyCrew& crew, Capability& c) {
  const auto borne = [&](double factor) {
    const Case subject = case_of(c.shell, c.tier, {plan.coarse, c.rpm, factor});
    const CycleResult r = bearing::solve_cycle(subject, c.tier, crew.control());
    if (crew.stopped()) return false;
    const ShellLimit limit = limit_of(c.shell, subject, r);
    if (limit != ShellLimit::none) {
      c.bad = tried(factor, r);
      c.limit = limit;
      c.reason = app::reason_of(r.verdict);
      return false;
    }
    c.good = tried(factor, r);
    c.peak = 0.0;
    for (const auto& i : r.instants) c.peak = std::max(c.peak, std::hypot(i.load_x, i.load_y));
    return true;
  };
  double low = plan.factors[0], high = plan.factors[1];
  if (borne(high) || crew.stopped() || !borne(low)) {
    c.tried = !crew.stopped();
    return;
  }
  for (int k = 0; k < plan.halvings && !crew.stopped(); ++k) {
    const double middle = std::sqrt(low * high);
    (borne(middle) ? low : high) = middle;
  }
  add_bar(plan, crew, c);
  c.tried = !crew.stopped();
}

void run_cycles(StudyCrew& crew, ShellsStudy& study) {
  crew.work("cycles", 2 * kShells, [&](int k) {
    ShellCycle& c = study.cycles[k / 2][k % 2];
    c.input = case_of(k / 2, kTiers[k % 2], {study.plan.grid, 2000.0, 1.0});
    c.result = fidelity::solve_cycle_with_bars(c.input, crew.control());
    c.tried = !crew.stopped();
    if (c.good()) add_powers(c);
  });
}

void run_variants(StudyCrew& crew, ShellsStudy& study) {
  crew.work("what is left open", kVariants * kShells, [&](int k) {
    ShellCycle& c = study.variants[k / kShells][k % kShells];
    const Case usual = case_of(k % kShells, Tier::isothermal, {study.plan.left_open, 2000.0, 1.0});
    c.input = varied(usual, shell_variants()[k / kShells]);
    c.result = bearing::solve_cycle(c.input, Tier::isothermal, crew.control());
    c.tried = !crew.stopped();
    if (c.good()) add_powers(c);
  });
}

}  // namespace

const std::array<ShellKind, kShells>& shell_kinds() {
  // Limits: AlSn20 loses half its strength and its tin nears melting (232 degC) from about 170 degC
  // on; polyamide-imide coatings serve to about 200 degC (both textbook).
  static const std::array<ShellKind, kShells> kKinds{
      {{"AlSn, plain", "shell-plain", {0.02, 0.02, 0.005}, 102.5, 170.0 + kZeroCelsius},
       {"AlSn, grooved", "shell-grooved", {0.02, 0.015, 0.007}, 96.2, 170.0 + kZeroCelsius},
       {"polymer", "shell-polymer", {0.005, 0.0025, 0.01}, 71.5, 200.0 + kZeroCelsius}}};
  return kKinds;
}

const std::array<ShellVariant, kVariants>& shell_variants() {
  constexpr double kBeside = 20.0 * kPi / 180.0;  // paper, 4.2
  constexpr double kWarmer = 30.0;                // 130 degC: a hot, heavily loaded bearing
  static const std::array<ShellVariant, kVariants> kAll{
      {{"as in the cases", NAN, 0.0},
       {"oil 30 K warmer", NAN, kWarmer},
       {"drilling, 20 deg ahead", kBeside, 0.0},
       {"drilling, 20 deg behind", -kBeside, 0.0},
       {"drilling, 20 deg behind, oil 30 K warmer", -kBeside, kWarmer}}};
  return kAll;
}

Case varied(Case c, const ShellVariant& variant) {
  // The film presses hardest 8 deg after the dead centre; the pin has then turned by them and by
  // the swing of the rod, asin(137/2/207 sin 8 deg), in the rod, whose axis is at 90 deg.
  constexpr double kTurned = 10.6 * kPi / 180.0;
  c.oil_temperature = c.oil_temperature.value() + variant.warmer;
  for (bearing::Supply& supply : c.supplies) {
    supply.temperature += variant.warmer;
    if (std::isnan(variant.mouth)) continue;
    supply.kind = bearing::SupplyKind::drilling;
    supply.angle = 0.5 * kPi + variant.mouth - kTurned;
    supply.heat_transfer = 0.0;  // a drilling has no surface that the film sees,
    supply.carry_over = 0.0;     // and what is pressed back into it does not come again
  }
  return c;
}

ShellsPlan shells_plan(bool quick) {
  ShellsPlan plan;
  if (!quick) return plan;
  plan.grid = {100, 13};
  plan.left_open = {60, 9};
  plan.coarse = {48, 7};
  plan.rpm = {2000.0};
  plan.halvings = 3;
  return plan;
}

const char* to_string(ShellLimit limit) {
  switch (limit) {
    case ShellLimit::lining:
      return "lining too hot";
    case ShellLimit::film:
      return "film too thin";
    case ShellLimit::state:
      return "no periodic state found";
    case ShellLimit::none:
      break;
  }
  return "none met";
}

void add_powers(ShellCycle& c) {
  const auto& all = c.result.instants;
  if (all.size() < 2) return;
  double film = 0.0, asperity = 0.0, load = 0.0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const auto& a = all[k - 1];
    const auto& b = all[k];
    const double half = 0.5 * (b.t - a.t);
    asperity += half * (a.torque_asperity * a.omega + b.torque_asperity * b.omega);
    film += half *
            ((a.torque - a.torque_asperity) * a.omega + (b.torque - b.torque_asperity) * b.omega);
    load += half * (a.power - a.torque * a.omega + b.power - b.torque * b.omega);
  }
  const double time = all.back().t - all.front().t;
  c.film_power = film / time;
  c.asperity_power = asperity / time;
  c.load_power = load / time;
}

double error_of(const CycleResult& r, const std::string& name) {
  for (const bearing::CycleQuantity& q : r.quantities) {
    if (q.quantity.name == name) return q.quantity.error_grid + q.error_time;
  }
  return NAN;
}

double ShellCycle::power_error() const {
  return power() * error_of(result, "friction_torque") /
         bearing::value_of(result, "friction_torque");
}

HardestInstant hardest_instant(const ShellCycle& c) {
  const auto pressed = [](const bearing::CycleInstant& i) {
    return i.p_max + (std::isfinite(i.p_asperity_max) ? i.p_asperity_max : 0.0);
  };
  const auto& all = c.result.instants;
  if (all.empty()) return {};
  const auto at = std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return pressed(a) < pressed(b);
  });
  const double R = c.input.bearing.radius;
  const double area = 2.0 * kPi * R * c.input.bearing.width;
  const double asperity = at->torque_asperity;
  return {app::on_axis(c.result, at->t),
          pressed(*at),
          (at->torque - asperity) / (R * area),
          asperity / (R * area),
          at->torque * at->omega / area,
          at->heat_to_shell / area,
          at->T_shell_max,
          at->T_film_max};
}

double load_met(ShellLimit limit, const LoadTried& a, const LoadTried& b, double h_least,
                double T_most) {
  const auto beyond = [&](const LoadTried& at) {
    return limit == ShellLimit::film     ? at.h - h_least
           : limit == ShellLimit::lining ? T_most - at.T
                                         : NAN;
  };
  const double m = beyond(a), n = beyond(b);
  if (!(a.factor > 0.0) || !(b.factor > 0.0) || !std::isfinite(m - n) || m == n) return NAN;
  return a.factor * std::pow(b.factor / a.factor, m / (m - n));
}

double least_film(const Case& c) {
  return std::hypot(c.surfaces.shell.roughness, c.surfaces.shaft.roughness);
}

solid::FrictionParts parts_at_the_papers_point(const Case& c) {
  constexpr double kPressure = 10e6, kViscosity = 0.01, kSlide = 10.0;  // paper, 4.1
  const solid::AsperityContact contact(c.surfaces.shell, c.surfaces.shaft, *c.surfaces.contact);
  const double h = contact.gap_of(kPressure);
  return contact.friction().coefficient(contact.place(h, kPressure, kViscosity, kSlide));
}

const Capability* ShellsStudy::at(int shell, Tier tier, double rpm) const {
  for (const Capability& c : capability) {
    if (c.shell == shell && c.tier == tier && c.rpm == rpm) return &c;
  }
  return nullptr;
}

int ShellsStudy::count_failed() const {
  int failed = 0;
  for (const auto& shell : cycles) {
    for (const ShellCycle& c : shell) failed += c.tried && !c.good() ? 1 : 0;
  }
  for (const auto& variant : variants) {
    for (const ShellCycle& c : variant) failed += c.tried && !c.good() ? 1 : 0;
  }
  return failed;
}

ShellsStudy run_shells_study(const ShellsPlan& plan, const StudyOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  ShellsStudy study;
  study.plan = plan;
  study.threads = options.threads;
  StudyCrew crew(options);
  for (int k = 0; k < kShells; ++k) {
    study.parts[k] = parts_at_the_papers_point(case_of(k, Tier::tehd, {plan.grid, 2000.0, 1.0}));
  }
  run_cycles(crew, study);
  run_variants(crew, study);
  for (const double rpm : plan.rpm) {
    for (const Tier tier : kTiers) {
      for (int k = 0; k < kShells; ++k) {
        Capability c;
        c.shell = k;
        c.tier = tier;
        c.rpm = rpm;
        study.capability.push_back(c);
      }
    }
  }
  crew.work("load capability", static_cast<int>(study.capability.size()),
            [&](int k) { find_capability(plan, crew, study.capability[k]); });
  study.interrupted = crew.stopped();
  const auto spent = std::chrono::steady_clock::now() - begin;
  study.wall_s = std::chrono::duration<double>(spent).count();
  return study;
}

ShellsStudy run_shells_study(const StudyOptions& options) {
  return run_shells_study(shells_plan(options.quick), options);
}

}  // namespace shellback::validation
