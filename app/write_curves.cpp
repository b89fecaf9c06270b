#include "app/write_curves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/labels/csv_text.hpp"
#include "app/labels/cycle_shown.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

std::string head(const std::vector<Curve>& curves) {
  std::string line;
  for (const Curve& curve : curves) {
    const std::string unit = curve.unit == "rad" ? "deg" : curve.unit;
    line += (line.empty() ? "" : ",") + csv_text(fmt::format("{} [{}]", curve.name, unit));
    if (!curve.bars.empty()) line += "," + csv_text(fmt::format("{} error [{}]", curve.name, unit));
  }
  return line;
}

std::string row(const std::vector<Curve>& curves, std::size_t k) {
  std::string line;
  for (const Curve& curve : curves) {
    const auto shown = [&](double x) { return curve.unit == "rad" ? x * 180.0 / kPi : x; };
    if (&curve != &curves.front()) line += ",";
    line += csv_number(shown(curve.values[k]));
    if (!curve.bars.empty()) line += "," + csv_number(shown(curve.bars[k]));
  }
  return line;
}

Curve curve_of(const CycleSeries& series) { return {series.name, series.unit, series.values, {}}; }

}  // namespace

std::string curves_csv(const std::vector<Curve>& curves, const Verdict& verdict) {
  const std::string status = csv_text(to_string(verdict.status));
  std::string text = head(curves) + ",status\n";
  for (std::size_t k = 0; k < curves.front().values.size(); ++k) {
    text += row(curves, k) + "," + status + "\n";
  }
  return text;
}

std::vector<Curve> curves_of(const bearing::Case& c, const bearing::CycleResult& cycle) {
  std::vector<Curve> curves{curve_of(instants_told(cycle))};
  for (const CycleSeries& series : followed(c, cycle)) curves.push_back(curve_of(series));
  return curves;
}

}  // namespace shellback::app
