#include "app/reading/measured_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "app/reading/csv_table.hpp"

namespace shellback::app {
namespace {

constexpr const char* kMeasuredExample =
    "speed [rpm], load [kN], friction_torque [N m], friction_torque_sd [N m]";

constexpr const char* kFrictionTorque = "friction_torque";

/// A column that may say where the bearing ran.
struct InputColumn {
  const char* name;
  Kind kind;
  const char* key;  ///< "supply.#.": of every supply
};
const std::vector<InputColumn> kInputs{
    {"speed", kSpeed, "operation.speed"},
    {"load", kForce, "operation.load"},
    {"load_angle", kAngle, "operation.load_angle"},
    {"oil_temperature", kTemperature, "oil.temperature"},
    {"supply_temperature", kTemperature, "supply.#.temperature"},
    {"supply_pressure", kPressure, "supply.#.pressure"},
    {"shell_back_temperature", kTemperature, "measured.shell_back_temperature"}};

/// A column that may be measured; its deviation is NAME_sd.
struct OutputColumn {
  const char* name;
  const char* deviation;
  Kind kind;
  const char* quantity;
};
const std::vector<OutputColumn> kOutputs{
    {kFrictionTorque, "friction_torque_sd", kTorque, kFrictionTorque},
    {"power_loss", "power_loss_sd", kPower, "power_loss"},
    {"h_min", "h_min_sd", kLength, "h_min"},
    {"p_max", "p_max_sd", kPressure, "p_max"},
    {"side_flow", "side_flow_sd", kFlow, "side_flow"},
    {"T_shell_max", "T_shell_max_sd", kTemperature, "T_shell_max"},
    {"T_film_max", "T_film_max_sd", kTemperature, "T_film_max"},
    {"T_shaft", "T_shaft_sd", kTemperature, "T_shaft"},
    {"shell_back_temperature", "shell_back_temperature_sd", kTemperature, "T_shell_back"}};

std::vector<CsvKind> possible_columns() {
  std::vector<CsvKind> all;
  for (const InputColumn& c : kInputs) all.push_back({c.name, c.kind});
  for (const OutputColumn& c : kOutputs) {
    const bool twice = std::any_of(all.begin(), all.end(),
                                   [&](const CsvKind& k) { return std::string(k.name) == c.name; });
    if (!twice) all.push_back({c.name, c.kind});
    all.push_back({c.deviation, c.kind.absolute ? kTemperatureDifference : c.kind});
  }
  return all;
}

bool is_back(const std::string& name) { return name == "shell_back_temperature"; }

std::vector<std::string> keys_of(const InputColumn& column, int supplies) {
  const std::string key = column.key;
  const std::size_t sign = key.find('#');
  if (sign == std::string::npos) return {key};
  std::vector<std::string> keys;
  for (int k = 0; k < supplies; ++k) {
    keys.push_back(key.substr(0, sign) + std::to_string(k) + key.substr(sign + 1));
  }
  return keys;
}

/// Reads one table; the order of points is found first.
class Reading {
 public:
  Reading(const std::string& path, int supplies, bool isothermal, double omega)
      : csv_(path, possible_columns(), kMeasuredExample, TextKind::table),
        supplies_(supplies),
        isothermal_(isothermal),
        omega_(omega) {
    table_.path = path;
  }

  MeasuredTable table() {
    if (csv_.rows() == 0) csv_.fail_header("there is no row behind the first line; give points");
    choose_columns();
    sort_rows();
    add_inputs();
    for (const std::size_t row : rows_) add_point(row);
    return std::move(table_);
  }

 private:
  void choose_columns();
  void sort_rows();
  void add_inputs();
  void add_point(std::size_t row);
  [[nodiscard]] std::string curve_of(std::size_t row) const;

  CsvTable csv_;
  int supplies_;
  bool isothermal_;
  double omega_;
  MeasuredTable table_;
  std::vector<InputColumn> inputs_;
  std::vector<OutputColumn> outputs_;
  std::vector<std::size_t> rows_;
};

void Reading::choose_columns() {
  for (const InputColumn& c : kInputs) {
    if (csv_.has(c.name) && (isothermal_ || !is_back(c.name))) inputs_.push_back(c);
  }
  int without = 0;
  for (const OutputColumn& c : kOutputs) {
    const bool given = csv_.has(c.name) && !(isothermal_ && is_back(c.name));
    if (!given && csv_.has(c.deviation)) {
      csv_.fail_header(fmt::format(
          "{} is the deviation of {}, which is {}; leave it out", c.deviation, c.name,
          csv_.has(c.name) ? "given to tier isothermal, not computed by it" : "not there"));
    }
    if (!given) continue;
    outputs_.push_back(c);
    table_.quantities.emplace_back(c.quantity);
    if (!csv_.has(c.deviation)) ++without;
  }
  if (inputs_.empty())
    csv_.fail_header(std::string("no column says where, as in ") + kMeasuredExample);
  if (outputs_.empty())
    csv_.fail_header(std::string("no column is measured, as in ") + kMeasuredExample);
  table_.deviations_known = without == 0;
  if (without > 0 && outputs_.size() > 1) {
    csv_.fail_header(
        "several quantities are measured: only standard deviations say how they weigh against one "
        "another; give each its column NAME_sd");
  }
}

/// All inputs but the first (speed, if there is one), as written.
std::string Reading::curve_of(std::size_t row) const {
  std::string name;
  for (std::size_t k = 1; k < inputs_.size(); ++k) {
    name += fmt::format("{}{} = {}", k == 1 ? "" : ", ", inputs_[k].name,
                        csv_.written(row, inputs_[k].name));
  }
  return name;
}

void Reading::sort_rows() {
  rows_.resize(csv_.rows());
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  const std::vector<double>& along = csv_.column(inputs_.front().name);
  std::vector<std::string> order;  // curves as they first appear
  for (const std::size_t row : rows_) {
    const std::string name = curve_of(row);
    if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
  }
  const auto rank = [&](std::size_t row) {
    return std::find(order.begin(), order.end(), curve_of(row)) - order.begin();
  };
  std::stable_sort(rows_.begin(), rows_.end(), [&](std::size_t a, std::size_t b) {
    const auto ra = rank(a), rb = rank(b);
    return ra != rb ? ra < rb : along[a] < along[b];
  });
}

void Reading::add_inputs() {
  for (const InputColumn& c : inputs_) {
    std::vector<double> numbers;
    std::string unit;
    for (const std::size_t row : rows_) {
      const auto written = number_in_front(csv_.written(row, c.name));  // read as one before
      numbers.push_back(written->number);
      unit = written->unit;
    }
    const std::vector<std::string> keys = keys_of(c, supplies_);
    if (keys.empty()) csv_.fail_header(fmt::format("{}: the case has no [[supply]]", c.name));
    table_.inputs.push_back({c.name, study::listed_axis(keys[0], numbers, unit), keys});
  }
}

void Reading::add_point(std::size_t row) {
  study::MeasuredPoint p;
  const std::string place = csv_.place(row, inputs_.front().name);
  table_.places.push_back(place);
  p.name = fmt::format("{} ({} = {}", place.substr(0, place.rfind(':')), inputs_.front().name,
                       csv_.written(row, inputs_.front().name));
  p.curve = curve_of(row);
  p.name += p.curve.empty() ? ")" : ", " + p.curve + ")";
  constexpr double kScatter = 3.0;  // standard deviations: one value of 400 is further off
  for (const OutputColumn& c : outputs_) {
    study::MeasuredValue m{c.quantity, csv_.column(c.name)[row]};
    if (csv_.has(c.deviation)) {
      m.deviation = csv_.column(c.deviation)[row];
      if (!(m.deviation > 0.0)) {
        csv_.fail(row, c.deviation, "a standard deviation must be positive; give the instrument's");
      }
    }
    const bool torque = std::string_view(c.quantity) == kFrictionTorque;
    const bool scatter = std::abs(m.value) < kScatter * m.deviation;
    const double speed = csv_.has("speed") ? csv_.column("speed")[row] : omega_;
    if (torque && !scatter && m.value * speed < 0.0) {
      csv_.fail(row, c.name,
                "a friction torque has the sign of the speed, which drives against it; change that "
                "of one of the two");
    }
    p.values.push_back(m);
  }
  table_.points.push_back(std::move(p));
}

}  // namespace

std::vector<Override> MeasuredTable::overrides_at(double at) const {
  std::vector<Override> all;
  const std::string& place = places[static_cast<std::size_t>(std::floor(at))];
  for (const MeasuredInput& input : inputs) {
    const std::string word = word_at(input.axis, at);
    for (const std::string& key : input.keys) all.push_back({key, word, place});
  }
  return all;
}

MeasuredTable read_measured_table(const std::string& path, int supplies, bool isothermal,
                                  double omega) {
  return Reading(path, supplies, isothermal, omega).table();
}

}  // namespace shellback::app
