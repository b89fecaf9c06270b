#include "validation/shells/shells_study.hpp"

#include <algorithm>
#include <cmath>

#include "app/pictures/cycle_axis.hpp"
#include "core/constants.hpp"
#include "core/stopwatch.hpp"
#include "fidelity/cycle_bars.hpp"

namespace shellback::validation {
namespace {

using bearing::Case;
using bearing::CycleResult;
using bearing::Tier;

constexpr std::array kTiers{Tier::tehd, Tier::isothermal};

void run_cycles(StudyCrew& crew, ShellsStudy& study) {
  crew.work("cycles", 2 * kShells, [&](int k) {
    ShellCycle& c = study.cycles[k / 2][k % 2];
    c.input = shell_case(k / 2, kTiers[k % 2], {study.plan.grid, 2000.0, 1.0});
    const auto control = crew.control(k, c.input);
    c.result = fidelity::solve_cycle_with_bars(c.input, control);
    StudyCrew::keep(control, c.result.verdict);
    c.tried = !crew.stopped();
    if (c.good()) add_powers(c);
  });
}

void run_variants(StudyCrew& crew, ShellsStudy& study) {
  crew.work("what is left open", kVariants * kShells, [&](int k) {
    ShellCycle& c = study.variants[k / kShells][k % kShells];
    const Case usual =
        shell_case(k % kShells, Tier::isothermal, {study.plan.left_open, 2000.0, 1.0});
    c.input = varied(usual, shell_variants()[k / kShells]);
    const auto control = crew.control(k, c.input);
    c.result = bearing::solve_cycle(c.input, Tier::isothermal, control);
    StudyCrew::keep(control, c.result.verdict);
    c.tried = !crew.stopped();
    if (c.good()) add_powers(c);
  });
}

void run_shells_in(StudyCrew& crew, ShellsStudy& study) {
  crew.work("running-in", 2 * kShells, [&](int k) {
    study.run_in[k / 2][k % 2] = run_shell_in(study.plan, crew, k, k / 2, kTiers[k % 2]);
  });
}

/// Of shells that were not run in there is none to find.
void find_capabilities(StudyCrew& crew, ShellsStudy& study) {
  for (const double rpm : study.plan.rpm) {
    for (const Tier tier : kTiers) {
      for (int k = 0; k < kShells; ++k) {
        for (const bool worn : {false, true}) {
          Capability c;
          c.shell = k;
          c.tier = tier;
          c.rpm = rpm;
          c.worn = worn;
          study.capability.push_back(c);
        }
      }
    }
  }
  crew.work("load capability", static_cast<int>(study.capability.size()), [&](int k) {
    Capability& c = study.capability[k];
    const RunInShell& run_in = study.run_in[c.shell][c.tier == kTiers[0] ? 0 : 1];
    if (!c.worn) find_capability(study.plan, crew, k, nullptr, c);
    if (c.worn && run_in.good()) find_capability(study.plan, crew, k, &run_in.wear, c);
  });
}

}  // namespace

const std::array<ShellVariant, kVariants>& shell_variants() {
  constexpr double kBeside = 20.0 * kPi / 180.0;  // paper, 4.2
  constexpr double kWarmer = 30.0;                // 130 degC: a hot, heavily loaded bearing
  static const std::array<ShellVariant, kVariants> kAll{
      {{"as in the cases", NAN, 0.0, false},
       {"coating that flows", NAN, 0.0, true},
       {"oil 30 K warmer", NAN, kWarmer, false},
       {"drilling, 20 deg ahead", kBeside, 0.0, false},
       {"drilling, 20 deg behind", -kBeside, 0.0, false},
       {"drilling, 20 deg behind, oil 30 K warmer", -kBeside, kWarmer, false},
       {"the same, coating that flows", -kBeside, kWarmer, true}}};
  return kAll;
}

Case varied(Case c, const ShellVariant& variant) {
  // The film presses hardest 8 deg after the dead centre; the pin has then turned by them and by
  // the swing of the rod, asin(137/2/207 sin 8 deg), in the rod, whose axis is at 90 deg.
  constexpr double kTurned = 10.6 * kPi / 180.0;
  c.oil_temperature = c.oil_temperature.value() + variant.warmer;
  bearing::ShellLayer& lining = c.shell->layers.front();
  lining.elasto_plastic = variant.flows && lining.material.damping_ratio > 0.0;
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

void add_powers(ShellCycle& c) {
  const auto& all = c.result.instants;
  if (all.size() < 2) return;
  double film = 0.0, asperity = 0.0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const auto& a = all[k - 1];
    const auto& b = all[k];
    const double half = 0.5 * (b.t - a.t);
    asperity += half * (a.torque_asperity * a.omega + b.torque_asperity * b.omega);
    film += half *
            ((a.torque - a.torque_asperity) * a.omega + (b.torque - b.torque_asperity) * b.omega);
  }
  const double time = all.back().t - all.front().t;
  c.film_power = film / time;
  c.asperity_power = asperity / time;
  c.load_power = bearing::value_of(c.result, "power_loss") - c.film_power - c.asperity_power;
}

double error_of(const CycleResult& r, const std::string& name) {
  const bearing::CycleQuantity* q = quantity_named(r, name);
  return q == nullptr ? NAN : q->quantity.error_grid + q->quantity.error_time;
}

double ShellCycle::power_error() const {
  return power() * error_of(result, "friction_torque") /
         bearing::value_of(result, "friction_torque");
}

double ShellCycle::asperity_error() const {
  return power() * error_of(result, "friction_torque_asperity") /
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

solid::FrictionParts parts_at_the_papers_point(const Case& c) {
  constexpr double kPressure = 10e6, kViscosity = 0.01, kSlide = 10.0;  // paper, 4.1
  const solid::AsperityContact contact(c.surfaces.shell, c.surfaces.shaft, *c.surfaces.contact);
  const double h = contact.gap_of(kPressure);
  return contact.friction().coefficient(contact.place(h, kPressure, kViscosity, kSlide));
}

const Capability* ShellsStudy::at(int shell, Tier tier, double rpm, bool worn) const {
  for (const Capability& c : capability) {
    if (c.shell == shell && c.tier == tier && c.rpm == rpm && c.worn == worn) return &c;
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
  for (const auto& shell : run_in) {
    for (const RunInShell& r : shell) failed += r.tried && !r.good() ? 1 : 0;
  }
  return failed;
}

int count_pieces(const ShellsPlan& plan) {
  return (2 + kVariants + 2 + 4 * static_cast<int>(plan.rpm.size())) * kShells;
}

ShellsStudy run_shells_study(const ShellsPlan& plan, const StudyOptions& options) {
  const Stopwatch watch;
  ShellsStudy study;
  study.plan = plan;
  study.threads = options.threads;
  StudyCrew crew(options);
  for (int k = 0; k < kShells; ++k) {
    study.parts[k] = parts_at_the_papers_point(shell_case(k, Tier::tehd, {plan.grid, 2000.0, 1.0}));
  }
  run_cycles(crew, study);
  run_variants(crew, study);
  run_shells_in(crew, study);
  find_capabilities(crew, study);
  study.interrupted = crew.stopped();
  study.wall_s = watch.seconds();
  return study;
}

ShellsStudy run_shells_study(const StudyOptions& options) {
  return run_shells_study(shells_plan(options.quick), options);
}

}  // namespace shellback::validation
