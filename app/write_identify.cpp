#include "app/write_identify.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <cmath>
#include <ostream>

#include "app/labels/command_words.hpp"
#include "app/labels/csv_text.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/text_table.hpp"
#include "bearing/quantities.hpp"

namespace shellback::app {
namespace {

using study::Fit;

std::string si_unit(const std::string& quantity) {
  return std::string(bearing::find_quantity(quantity)->unit);
}

void write_keys(std::ostream& out, const IdentifyView& v) {
  const Fit& fit = v.end.fit;
  TextTable table;
  table.add({"key", "start", "fitted", "deviation", "unit", "bounds", ""});
  table.rule();
  for (std::size_t k = 0; k < v.keys.size(); ++k) {
    const FittedKey& key = v.keys[k];
    const bool judged = k < fit.deviation.size();
    table.add({key.key, figures(key.value.start, 5), fit.computed() ? figures(fit.x[k], 5) : "n/a",
               judged ? figures(fit.deviation[k], 2) : "n/a", key.unit,
               fmt::format("{:.4g} to {:.4g}", key.value.low, key.value.high),
               judged && fit.at_bound[k] != 0 ? "at its bound: no value of the data's" : ""});
  }
  table.print(out);
}

void write_correlations(std::ostream& out, const IdentifyView& v) {
  const auto& rho = v.end.fit.correlation;
  if (v.keys.size() < 2 || rho.empty()) return;
  out << "\nCorrelations (of logarithms where the bounds span a decade)\n";
  TextTable table;
  for (std::size_t j = 0; j < v.keys.size(); ++j) {
    std::vector<std::string> row{v.keys[j].key};
    for (std::size_t k = 0; k <= j; ++k) {
      row.push_back(std::isfinite(rho[j][k]) ? fmt::format("{:.3f}", rho[j][k]) : "n/a");
    }
    for (std::size_t k = j + 1; k < v.keys.size(); ++k) row.emplace_back("");
    table.add(std::move(row));
  }
  table.print(out);
}

void write_directions(std::ostream& out, const IdentifyView& v) {
  if (v.end.fit.directions.empty()) return;
  out << "\nWhat the data determine (singular values, keys in distances of their bounds)\n";
  TextTable table;
  table.add({v.keys.size() > 1 ? "together" : "key", "singular value", "deviation / bounds", ""});
  table.rule();
  for (const auto& d : v.end.fit.directions) {
    table.add({direction_words(v, d), fmt::format("{:.3g}", d.singular_value),
               std::isfinite(d.deviation) ? fmt::format("{:.2g}", d.deviation) : "n/a",
               d.determined ? "determined" : "NOT determined"});
  }
  table.print(out);
}

/// In standard deviations where they are given; temperatures in kelvin, all else of the value.
std::string off_words(const study::MeasuredValue& m, double off) {
  if (std::isfinite(m.deviation)) return fmt::format("{:+.2f} sd", off / m.deviation);
  const std::string unit = si_unit(m.quantity);
  if (unit == "K") return fmt::format("{:+.2g} K", off);
  if (m.value == 0.0) return fmt::format("{:+.2g} {}", off, unit);
  return fmt::format("{:+.2g} %", 100.0 * off / m.value);
}

void write_points(std::ostream& out, const IdentifyView& v) {
  out << "\nPoints\n";
  TextTable table;
  table.add({"point", "quantity", "measured", "start", "fitted", "off by", "unit"});
  table.rule();
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const auto& measured = v.table.points[i];
    const auto& p = v.end.points[i];
    for (std::size_t k = 0; k < measured.values.size(); ++k) {
      const auto& m = measured.values[k];
      const DisplayUnit unit = display_unit(m.quantity, si_unit(m.quantity), std::abs(m.value));
      const auto shown = [&](const std::vector<double>& all) {
        return k < all.size() ? figures(unit(all[k])) : "not found";
      };
      const bool fitted = k < p.fitted.size();
      const double off = fitted ? p.fitted[k] - m.value : NAN;
      const std::string off_by = fitted ? off_words(m, off) : "";
      table.add({measured.name, quantity_label(m.quantity), figures(unit(m.value)), shown(p.start),
                 shown(p.fitted), off_by, unit.unit});
    }
  }
  table.print(out);
}

constexpr double kTwoSided = 0.975;  ///< 2.5 % beyond on either side [-]

void write_sum(std::ostream& out, const IdentifyView& v) {
  const Fit& fit = v.end.fit;
  out << fmt::format("\n{}: {} steps, {} evaluations of {} points, {:.3g} s\n",
                     to_string(fit.status), fit.iterations, fit.evaluations, v.end.points.size(),
                     v.end.wall_s);
  if (fit.refused_steps > 0) {
    out << fmt::format("{} steps were not taken: a point was not found there\n", fit.refused_steps);
  }
  if (!fit.computed()) return;
  if (v.table.deviations_known) {
    out << fmt::format("chi2 {:.4g} (start {:.4g}) for {} values more than keys\n", fit.chi2,
                       fit.chi2_start, fit.freedom);
    return;
  }
  const std::string& quantity = v.table.quantities.front();
  const double found = found_deviation(v);
  if (!std::isfinite(found)) return;
  const DisplayUnit unit = display_unit(quantity, si_unit(quantity));
  out << fmt::format(
      "no deviations are given: equal ones are taken, {} {} as the points scatter ({} values more "
      "than keys: 95 % of repetitions lie within {:.3g} deviations, Student)\n",
      figures(found * unit.scale, 3), unit.unit, fit.freedom,
      gsl_cdf_tdist_Pinv(kTwoSided, fit.freedom));
}

}  // namespace

void write_identify_table(std::ostream& out, const IdentifyView& v) {
  out << v.subject.title << '\n';
  if (const std::string changes = describe_changes(v.subject); !changes.empty()) {
    out << changes << '\n';
  }
  out << "Identified in tier " << to_string(v.subject.model.tier) << " from "
      << v.end.values_used(v.table.points) << " values of " << v.table.path << "\n\n";
  write_keys(out, v);
  write_sum(out, v);
  write_correlations(out, v);
  write_directions(out, v);
  write_points(out, v);
  if (!v.end.fit.computed()) return;
  if (!v.table.deviations_known && v.end.fit.freedom <= 0) {
    out << "\nNo case is proposed: how well the keys are known is not.\n";
    return;
  }
  if (!v.end.fit.directions.empty() && !v.end.fit.determined()) {
    out << "\nNo case is proposed: not all keys are determined.\n";
    return;
  }
  out << "\nThe fitted case:";
  for (std::size_t k = 0; k < v.keys.size(); ++k) {
    const FittedKey& key = v.keys[k];
    const std::string number = fmt::format("{:.7g}", v.end.fit.x[k]);
    out << fmt::format(" --set {}=\"{}{}{}\"", key.key, number, key.unit.empty() ? "" : " ",
                       key.unit);
  }
  out << "\n";
}

std::string identify_csv(const IdentifyView& v) {
  std::string out = "point";
  for (const MeasuredInput& input : v.table.inputs) {
    out += fmt::format(",{} [{}]", input.column, input.axis.unit);
  }
  out += ",quantity,unit,measured,deviation,start,fitted\n";
  const auto number = [](double x) { return std::isfinite(x) ? fmt::format("{:.10g}", x) : ""; };
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const auto& measured = v.table.points[i];
    const auto& p = v.end.points[i];
    for (std::size_t k = 0; k < measured.values.size(); ++k) {
      const auto& m = measured.values[k];
      out += csv_text(v.table.places[i]);
      for (const MeasuredInput& input : v.table.inputs) {
        out += fmt::format(",{:.10g}", input.axis.numbers[i]);
      }
      out += fmt::format(",{},{},{},{},{},{}\n", m.quantity, si_unit(m.quantity), number(m.value),
                         number(m.deviation), number(k < p.start.size() ? p.start[k] : NAN),
                         number(k < p.fitted.size() ? p.fitted[k] : NAN));
    }
  }
  return out;
}

}  // namespace shellback::app
