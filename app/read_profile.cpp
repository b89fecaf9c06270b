#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "app/case_text.hpp"
#include "app/csv_table.hpp"
#include "app/did_you_mean.hpp"
#include "app/sections.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr double kSame = 1e-9;  ///< positions closer than this are one [rad, m]

struct Column {
  const char* name;
  Kind kind;
  std::size_t at = 0;
  std::string unit;
  double factor = 1.0;
};

/// Finds phi, z and height with their units in a header such as "phi [deg], z [mm], height [um]".
std::array<Column, 3> read_header(const std::string& line, const std::string& place) {
  std::array<Column, 3> columns{
      {{"phi", kAngle, 0, ""}, {"z", kLength, 0, ""}, {"height", kLength, 0, ""}}};
  const std::vector<CsvCell> cells = split_cells(line);
  for (Column& column : columns) {
    bool found = false;
    for (std::size_t k = 0; k < cells.size() && !found; ++k) {
      const std::string& text = cells[k].text;
      const std::size_t open = text.find('[');
      const std::size_t close = text.find(']');
      const std::string word = text.substr(0, text.find_first_of(" ["));
      if (word != column.name) continue;
      if (open == std::string::npos || close == std::string::npos || close < open) {
        throw InputError(fmt::format("{}:{}", place, cells[k].column),
                         fmt::format("the column {} names no unit; write for example "
                                     "phi [deg], z [mm], height [um]",
                                     column.name));
      }
      try {
        column.unit = text.substr(open + 1, close - open - 1);
        column.factor = unit_factor(column.unit, column.kind);
      } catch (const UnitError& error) {
        throw InputError(fmt::format("{}:{}", place, cells[k].column), error.what());
      }
      column.at = k;
      found = true;
    }
    if (!found) {
      throw InputError(place + ":1",
                       fmt::format("there is no column {}; the first line names the columns and "
                                   "units: phi [deg], z [mm], height [um]",
                                   column.name));
    }
  }
  return columns;
}

double read_cell(const std::vector<CsvCell>& cells, const Column& column,
                 const std::string& place) {
  if (column.at >= cells.size()) {
    throw InputError(place + ":1", fmt::format("this line has no {}", column.name));
  }
  try {
    return number_of(cells[column.at].text, column.unit) * column.factor;
  } catch (const UnitError& error) {
    throw InputError(fmt::format("{}:{}", place, cells[column.at].column), error.what());
  }
}

/// Sorted positions, those closer than kSame merged.
std::vector<double> merged(std::vector<double> positions) {
  std::sort(positions.begin(), positions.end());
  std::vector<double> result;
  for (const double x : positions) {
    if (result.empty() || x - result.back() > kSame) result.push_back(x);
  }
  return result;
}

std::size_t index_of(const std::vector<double>& positions, double x) {
  const auto at = std::lower_bound(positions.begin(), positions.end(), x - kSame);
  return static_cast<std::size_t>(at - positions.begin());
}

struct Point {
  double phi;
  double z;
  double height;
  std::string place;
};

std::vector<Point> read_points(const std::string& text, const std::string& path) {
  std::vector<Point> points;
  std::array<Column, 3> columns;
  bool header = true;
  std::size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::string place = fmt::format("{}:{}", path, number);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (header) {
      columns = read_header(line, place);
      header = false;
      continue;
    }
    const std::vector<CsvCell> cells = split_cells(line);
    double phi = std::fmod(read_cell(cells, columns[0], place), 2.0 * kPi);
    if (phi < 0.0) phi += 2.0 * kPi;
    if (2.0 * kPi - phi < kSame) phi = 0.0;  // 360 deg is 0 deg
    points.push_back({phi, read_cell(cells, columns[1], place), read_cell(cells, columns[2], place),
                      place + ":1"});
  }
  if (points.empty()) throw InputError(path, "the profile holds no points");
  return points;
}

}  // namespace

bearing::Profile read_profile(const std::string& path) {
  const std::vector<Point> points =
      read_points(read_text_file(path, TextKind::table_of_case), path);
  bearing::Profile profile;
  for (const Point& point : points) {
    profile.phi.push_back(point.phi);
    profile.z.push_back(point.z);
  }
  profile.phi = merged(profile.phi);
  profile.z = merged(profile.z);
  const std::size_t m = profile.z.size();
  std::map<std::size_t, double> given;
  for (const Point& point : points) {
    const std::size_t at = index_of(profile.phi, point.phi) * m + index_of(profile.z, point.z);
    const auto [entry, fresh] = given.emplace(at, point.height);
    if (!fresh && std::abs(entry->second - point.height) > kSame) {
      throw InputError(point.place,
                       "this position has been given before with another height (0 deg and "
                       "360 deg are one position)");
    }
  }
  if (given.size() != profile.phi.size() * m) {
    throw InputError(path,
                     fmt::format("the positions form no rectangular grid: {} angles by {} "
                                 "axial positions need {} points, but there are {}",
                                 profile.phi.size(), m, profile.phi.size() * m, given.size()));
  }
  for (const auto& [at, height] : given) profile.height.push_back(height);
  return profile;
}

}  // namespace shellback::app
