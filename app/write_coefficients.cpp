#include "app/write_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/labels/quantity_label.hpp"

namespace shellback::app {
namespace {

void print_matrix(std::ostream& out, const char* name, const bearing::Matrix2& m) {
  for (int i = 0; i < 2; ++i) {
    out << fmt::format("  {:<14}{:>11}{:>11}\n", i == 0 ? name : "", figures(m[i][0], 4),
                       figures(m[i][1], 4));
  }
}

std::string threshold_words(const bearing::Coefficients& k) {
  switch (k.whirl.verdict) {
    case bearing::WhirlVerdict::always_stable:
      return "a rigid rotor runs stably at this speed whatever its mass";
    case bearing::WhirlVerdict::never_stable:
      return "a rigid rotor does not run stably at this speed whatever its mass";
    case bearing::WhirlVerdict::threshold:
      break;
  }
  return fmt::format(
      "a rigid rotor runs stably at this speed up to {} kg per bearing\n"
      "  (speed ratio omega sqrt(c m/W) = {}); beyond it whirls, at {} of the speed",
      figures(k.whirl.critical_mass, 4), figures(k.speed_ratio, 4), figures(k.whirl_ratio, 3));
}

}  // namespace

void print_coefficients(std::ostream& out, const bearing::Result& result) {
  if (!result.coefficients || !result.coefficients->verdict.good()) return;
  const auto& k = *result.coefficients;
  out << "\nlinear coefficients, force on the journal = -K x - C dx/dt, temperatures held\n"
         "  (x along the load, y a quarter turn on with the rotation; [-])\n";
  print_matrix(out, "K c/W", k.K_load);
  print_matrix(out, "C c omega/W", k.C_load);
  out << "  " << threshold_words(k) << '\n';
}

std::string coefficients_csv(std::vector<bearing::Coefficients> at_speeds) {
  std::stable_sort(at_speeds.begin(), at_speeds.end(),
                   [](const auto& a, const auto& b) { return a.omega < b.omega; });
  std::string text = "frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy\n";
  for (const bearing::Coefficients& k : at_speeds) {
    text += fmt::format("{:.10g}", k.omega);
    for (const auto* m : {&k.K, &k.C}) {
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) text += fmt::format(",{:.8e}", (*m)[i][j]);
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace shellback::app
