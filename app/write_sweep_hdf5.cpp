#include "app/write_sweep_hdf5.hpp"

#include <cmath>
#include <functional>

#include "app/hdf5_parts.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/words/ending_words.hpp"

namespace shellback::app {

using namespace hdf5;
using study::Sweep;
using study::SweepPoint;

namespace {

constexpr int kNotStarted = 5;  ///< after the values of Status

std::string axis_keys(const Sweep& sweep) {
  std::string keys;
  for (const auto& axis : sweep.axes) keys += (keys.empty() ? "" : " ") + axis.key;
  return keys;
}

/// Writes datasets over the whole grid.
class GridWriter {
 public:
  explicit GridWriter(const Sweep& sweep) : sweep_(sweep), axes_(axis_keys(sweep)) {
    for (const auto& axis : sweep.axes) shape_.push_back(static_cast<hsize_t>(axis.size()));
  }

  void numbers(hid_t parent, const std::string& name, const std::string& units,
               const std::string& long_name,
               const std::function<double(const SweepPoint&)>& value) const {
    std::vector<double> values;
    for (const SweepPoint& point : sweep_.points) values.push_back(value(point));
    dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), shape_, {units, long_name, axes_, ""});
  }
  void counts(hid_t parent, const std::string& name, const std::string& long_name,
              const std::function<int(const SweepPoint&)>& value) const {
    std::vector<int> values;
    for (const SweepPoint& point : sweep_.points) values.push_back(value(point));
    dataset(parent, name, H5T_NATIVE_INT, values.data(), shape_, {"1", long_name, axes_, ""});
  }
  void words(hid_t parent, const char* name, const std::string& long_name,
             const std::function<std::string(const SweepPoint&)>& value) const {
    std::vector<std::string> values;
    for (const SweepPoint& point : sweep_.points) values.push_back(value(point));
    texts(parent, name, values, shape_, {"-", long_name, axes_, ""});
  }

 private:
  const Sweep& sweep_;
  std::string axes_;
  Shape shape_;
};

void write_head(hid_t file, const bearing::Case& subject, const Sweep& sweep) {
  attribute(file, "format", std::string("shellback sweep"));
  attribute(file, "format_version", 1);
  attribute(file, "title", subject.title);
  attribute(file, "axes", axis_keys(sweep));
  attribute(file, "points", static_cast<int>(sweep.points.size()));
  attribute(file, "converged", sweep.count_good());
  attribute(file, "failed", sweep.count_failed());
  attribute(file, "interrupted", sweep.interrupted ? 1 : 0);
  attribute(file, "threads", sweep.threads);
  attribute(file, "wall_s", sweep.wall_s);
}

/// The quantity's label, without what aligns it in tables.
std::string words_of_quantity(const SweepQuantity& q) {
  std::string label = quantity_label(q.name);
  label.erase(0, label.find_first_not_of(' '));
  return label;
}

void write_axes(hid_t file, const Sweep& sweep) {
  const Handle axes = group(file, "axes");
  for (const auto& axis : sweep.axes) {
    const std::string name = "varied key of the case, " + std::string(to_string(axis.spacing));
    if (axis.numbers.empty()) {
      texts(axes, axis.key.c_str(), axis.words, name.c_str());
    } else {
      doubles(axes, axis.key.c_str(), axis.numbers, axis.unit.empty() ? "1" : axis.unit.c_str(),
              name.c_str());
    }
  }
}

/// Bars of one cause, of the quantities that have one at some point.
void write_bars(hid_t file, const Sweep& sweep, const GridWriter& grid, const char* name,
                const std::string& meaning, const Bar& bar) {
  const Handle bars = group(file, name);
  for (const SweepQuantity& q : sweep_quantities(sweep)) {
    if (!known_somewhere(sweep, q, bar)) continue;
    grid.numbers(bars, q.name, q.unit, meaning + words_of_quantity(q),
                 [&](const SweepPoint& point) { return bar_at(point, q, bar); });
  }
}

void write_quantities(hid_t file, const Sweep& sweep, const GridWriter& grid) {
  const Handle quantities = group(file, "quantities");
  for (const SweepQuantity& q : sweep_quantities(sweep)) {
    grid.numbers(quantities, q.name, q.unit, words_of_quantity(q),
                 [&](const SweepPoint& point) { return value_at(point, q); });
  }
  using bearing::Quantity;
  write_bars(file, sweep, grid, "errors", "error bar: ", &Quantity::error);
  const auto part = [&](const char* name, const char* meaning, double Quantity::*bar) {
    write_bars(file, sweep, grid, name, meaning, [bar](const Quantity& q) { return q.*bar; });
  };
  part("errors_grid", "error bar of the grid: ", &Quantity::error_grid);
  part("errors_time", "error bar of the steps in time: ", &Quantity::error_time);
  part("errors_model", "error bar of the model: ", &Quantity::error_model);
}

void write_audit(hid_t file, const GridWriter& grid) {
  using bearing::Audit;
  const Handle audit = group(file, "audit");
  const auto add = [&](const char* name, double Audit::*member, const char* meaning) {
    grid.numbers(audit, name, "1", meaning, [member](const SweepPoint& point) {
      return point.good() ? point.result.audit.*member : NAN;
    });
  };
  add("mass", &Audit::mass, "imbalance of the oil's mass");
  add("energy", &Audit::energy, "imbalance of power");
  add("load", &Audit::load, "residual of the load");
  add("moment", &Audit::moment, "imbalance of the moments on journal and shell");
}

void write_cost(hid_t file, const GridWriter& grid) {
  using bearing::Cost;
  const Handle cost = group(file, "cost");
  const auto add = [&](const char* name, int Cost::*member, const char* meaning) {
    grid.counts(cost, name, meaning,
                [member](const SweepPoint& point) { return point.result.cost.*member; });
  };
  add("outer_iterations", &Cost::outer_iterations, "outer iterations of the try that converged");
  add("newton_iterations", &Cost::newton_iterations, "Newton iterations of the try that converged");
  add("factorizations", &Cost::factorizations, "factorizations of the try that converged");
  grid.counts(cost, "tries", "solves begun for the point",
              [](const SweepPoint& point) { return point.tries; });
  grid.numbers(cost, "wall_s", "s", "time of all tries",
               [](const SweepPoint& point) { return point.wall_s; });
}

void write_state(hid_t file, const GridWriter& grid) {
  const Handle state = group(file, "state");
  grid.counts(state, "status",
              "0 converged, 1 iteration limit, 2 no steady state, 3 invalid number, 4 interrupted, "
              "5 not started",
              [](const SweepPoint& point) {
                return point.tried() ? static_cast<int>(point.result.verdict.status) : kNotStarted;
              });
  grid.words(state, "tier", "tier of the model", [](const SweepPoint& point) {
    return std::string(point.tried() ? to_string(point.result.tier) : "");
  });
  grid.words(state, "start", "from where the last try began",
             [](const SweepPoint& point) { return std::string(to_string(point.start)); });
  grid.words(state, "reason", "why the point is not solved", [](const SweepPoint& point) {
    return point.good() ? std::string() : reason_of(point.result.verdict);
  });
}

}  // namespace

std::string sweep_hdf5(const bearing::Case& subject, const Sweep& sweep) {
  return file_bytes([&](hid_t file) {
    const GridWriter grid(sweep);
    write_head(file, subject, sweep);
    write_axes(file, sweep);
    write_quantities(file, sweep, grid);
    write_audit(file, grid);
    write_cost(file, grid);
    write_state(file, grid);
    write_origin(file, subject);
  });
}

}  // namespace shellback::app
