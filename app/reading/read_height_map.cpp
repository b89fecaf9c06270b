#include "app/reading/read_height_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/map_text.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using surface::HeightMap;

constexpr int kFewest = 8;         ///< points each way: below, nothing can be said
constexpr long kMost = 4'000'000;  ///< points: what memory holds of a factorisation
constexpr double kOffGrid = 0.05;  ///< of a pitch: what positions may be off the grid [-]
constexpr const char* kColumns = "x [um], y [um], z [nm]";
/// Lengths of a map: heights are told in nanometres.
constexpr Kind kOfMap{"a length", {1, 0, 0, 0, 0}, "nm, um, mm", "10 um"};

/// A unit that stands in the header or at a column, as a factor.
double factor_of(const std::string& unit, const std::string& place, const std::string& what) {
  try {
    return unit_factor(unit, kOfMap);
  } catch (const UnitError& error) {
    throw InputError(place, fmt::format("{}: {}", what, error.what()));
  }
}

double header_length(const MapText& text, const HeaderValue& value, const std::string& name) {
  const std::string place = fmt::format("{}:{}:1", text.path(), value.line);
  double length = 0.0;
  try {
    length = parse_quantity(value.text, kOfMap);
  } catch (const UnitError& error) {
    throw InputError(place, fmt::format("{}: {}", name, error.what()));
  }
  if (length > 0.0) return length;
  throw InputError(place, fmt::format("{}: a size must be positive", name));
}

double values_factor(const MapText& text) {
  const HeaderValue units = text.header("Value units");
  if (units.line == 0) {
    throw InputError(fmt::format("{}:{}:1", text.path(), text.lines().front().number),
                     "the header names no unit of the heights; write a line such as "
                     "# Value units: nm above them");
  }
  return factor_of(units.text, fmt::format("{}:{}:1", text.path(), units.line), "Value units");
}

/// Pitch of one direction: from `# Pitch`, else the size over the number of points.
double pitch_of(const MapText& text, const char* size, int points) {
  const HeaderValue pitch = text.header("Pitch"), whole = text.header(size);
  if (pitch.line > 0 && whole.line > 0) {
    throw InputError(fmt::format("{}:{}:1", text.path(), pitch.line),
                     fmt::format("the header gives Pitch and {}; keep one of them", size));
  }
  if (pitch.line > 0) return header_length(text, pitch, "Pitch");
  if (whole.line > 0) return header_length(text, whole, size) / points;
  throw InputError(fmt::format("{}:{}:1", text.path(), text.lines().front().number),
                   fmt::format("the header does not tell how large the map is: there is no {}; "
                               "write lines such as # Width: 100 um and # Height: 80 um, or # "
                               "Pitch: 0.5 um, above the heights; points in columns begin with {}",
                               size, kColumns));
}

void expect_size(const MapText& text, long nx, long ny) {
  if (nx >= kFewest && ny >= kFewest && nx * ny <= kMost) return;
  throw InputError(
      text.path(),
      nx * ny > kMost
          ? fmt::format("the map has {} x {} points, more than {} million; export a part of it, or "
                        "every second point",
                        nx, ny, kMost / 1'000'000)
          : fmt::format("the map has {} x {} points; {} or more each way are needed (and many "
                        "more for statistics)",
                        nx, ny, kFewest));
}

/// Rows that all end with a mark between heights have no height behind it.
bool rows_end_with_mark(const MapText& text) {
  return std::all_of(text.lines().begin(), text.lines().end(),
                     [](const MapLine& line) { return map_fields(line.text).back().empty(); });
}

HeightMap read_matrix(const MapText& text) {
  const double factor = values_factor(text);
  const bool marked = rows_end_with_mark(text);
  HeightMap map;
  map.ny = static_cast<int>(text.lines().size());
  map.nx = static_cast<int>(map_fields(text.lines().front().text).size()) - (marked ? 1 : 0);
  expect_size(text, map.nx, map.ny);
  map.dx = pitch_of(text, "Width", map.nx);
  map.dy = pitch_of(text, "Height", map.ny);
  map.z.resize(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny));
  for (int j = 0; j < map.ny; ++j) {
    const MapLine& line = text.lines()[static_cast<std::size_t>(j)];
    auto fields = map_fields(line.text);
    if (marked) fields.pop_back();
    if (static_cast<int>(fields.size()) != map.nx) {
      const std::size_t odd = std::min(fields.size() - 1, static_cast<std::size_t>(map.nx));
      throw InputError(text.place(line, fields[odd]),
                       fmt::format("this row has {} heights, the first one has {}; write nan for "
                                   "points that were not measured",
                                   fields.size(), map.nx));
    }
    // The first line is the top: y rises upwards.
    for (int i = 0; i < map.nx; ++i) {
      map.z[map.index(i, map.ny - 1 - j)] =
          map_height(fields[static_cast<std::size_t>(i)], factor, text, line);
    }
  }
  return map;
}

/// Even positions that points take.
struct GridLine {
  double first = 0.0;
  double pitch = 0.0;
  int points = 0;
};

/// The rise from one line of points to the next, of all `rises` between points, the longest first:
/// points of one line scatter by less than kOffGrid of a pitch to either side. Gaps of missing
/// lines are fewer than kFewest.
double least_rise_of_lines(const std::vector<double>& rises) {
  constexpr double kApart = 1.0 / (4.0 * kOffGrid);  // 1 - 2 kOffGrid over 2 kOffGrid at least
  for (std::size_t k = kFewest - 1; k < rises.size(); ++k) {
    if (rises[k - 1] > kApart * rises[k]) return rises[k - 1];
  }
  return rises.back();
}

/// Means of points that lie nearer to each other than `rise`, which are sorted.
std::vector<double> lines_of(const std::vector<double>& positions, double rise) {
  std::vector<double> lines;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    sum += positions[k];
    ++count;
    if (k + 1 < positions.size() && positions[k + 1] - positions[k] < rise) continue;
    lines.push_back(sum / static_cast<double>(count));
    sum = 0.0;
    count = 0;
  }
  return lines;
}

/// Even lines from the first to the last of these distances apart, their median: a line that is
/// missing or stands askew does not change it.
GridLine even_lines(double first, double whole, std::vector<double> steps) {
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (!(whole / *middle <= static_cast<double>(kMost))) return {first, 0.0, 0};
  GridLine line{first, 0.0, static_cast<int>(std::lround(whole / *middle)) + 1};
  line.pitch = whole / (line.points - 1);
  return line;
}

bool lie_on(const std::vector<double>& positions, const GridLine& line) {
  return line.points > 0 && std::all_of(positions.begin(), positions.end(), [&](double x) {
           const double steps = (x - line.first) / line.pitch;
           return std::abs(steps - std::round(steps)) <= kOffGrid;
         });
}

/// Of points that lie on even lines; or scatter about such by less than kOffGrid of a pitch.
GridLine grid_line(std::vector<double> positions, const MapText& text, const char* axis) {
  std::sort(positions.begin(), positions.end());
  const double range = positions.back() - positions.front();
  constexpr double kSame = 1e-7;  // of the range: more digits than instruments write
  std::vector<double> rises;
  for (std::size_t k = 1; k < positions.size(); ++k) {
    const double rise = positions[k] - positions[k - 1];
    if (rise > kSame * range) rises.push_back(rise);
  }
  if (rises.empty()) {
    throw InputError(text.path(),
                     fmt::format("all points have the same {}: this is a profile, no map", axis));
  }
  const GridLine exact = even_lines(positions.front(), range, rises);
  if (lie_on(positions, exact)) return exact;
  std::sort(rises.begin(), rises.end(), std::greater<>());
  const std::vector<double> lines = lines_of(positions, least_rise_of_lines(rises));
  std::vector<double> steps;
  for (std::size_t k = 1; k < lines.size(); ++k) steps.push_back(lines[k] - lines[k - 1]);
  if (steps.empty()) return exact;
  const GridLine scattered = even_lines(lines.front(), lines.back() - lines.front(), steps);
  const GridLine& best = lie_on(positions, scattered) ? scattered : exact;
  if (best.points == 0) expect_size(text, kMost, kFewest);
  return best;
}

/// The three columns of the first line: where they stand, and their units.
struct ColumnPlace {
  std::size_t at = 0;
  double factor = 1.0;
};

std::array<ColumnPlace, 3> columns_of(const MapText& text) {
  const MapLine& line = text.lines().front();
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  std::array<std::optional<ColumnPlace>, 3> found;
  const auto fields = map_fields(line.text);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string_view field = fields[k];
    const std::string name(field.substr(0, field.find_first_of(" [")));
    const auto known = std::find(kNames.begin(), kNames.end(), name);
    const std::size_t open = field.find('['), close = field.find(']');
    if (known == kNames.end()) {
      throw InputError(text.place(line, field),
                       fmt::format("the column {} is not known; the first line names columns and "
                                   "units: {}",
                                   in_quotes(name), kColumns));
    }
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      throw InputError(text.place(line, field),
                       fmt::format("the column {} names no unit; write {}", name, kColumns));
    }
    auto& column = found[static_cast<std::size_t>(known - kNames.begin())];
    if (column) {
      throw InputError(text.place(line, field), fmt::format("there are two columns {}", name));
    }
    const std::string unit(field.substr(open + 1, close - open - 1));
    column = ColumnPlace{k, factor_of(unit, text.place(line, field), "column " + name)};
  }
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    if (found[k]) continue;
    throw InputError(
        text.place(line, line.text),
        fmt::format("there is no column {}; the first line names columns and units: {}", kNames[k],
                    kColumns));
  }
  return {*found[0], *found[1], *found[2]};
}

struct MapPoint {
  std::array<double, 3> xyz;
  const MapLine* line;
};

std::vector<MapPoint> read_points(const MapText& text) {
  const auto columns = columns_of(text);
  std::vector<MapPoint> points;
  for (std::size_t row = 1; row < text.lines().size(); ++row) {
    const MapLine& line = text.lines()[row];
    const auto fields = map_fields(line.text);
    if (fields.size() != columns.size()) {
      throw InputError(text.place(line, line.text),
                       fmt::format("this row has {} fields; give x, y and z", fields.size()));
    }
    MapPoint point{{}, &line};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      point.xyz[k] = map_height(fields[columns[k].at], columns[k].factor, text, line);
      if (k < 2 && std::isnan(point.xyz[k])) {
        throw InputError(text.place(line, fields[columns[k].at]),
                         "a position is missing; only z may be");
      }
    }
    points.push_back(point);
  }
  if (points.empty()) throw InputError(text.path(), "the map holds no points");
  return points;
}

HeightMap read_columns(const MapText& text) {
  const std::vector<MapPoint> points = read_points(text);
  std::array<GridLine, 2> grid;
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<double> positions;
    for (const MapPoint& point : points) positions.push_back(point.xyz[k]);
    grid[k] = grid_line(std::move(positions), text, k == 0 ? "x" : "y");
  }
  expect_size(text, grid[0].points, grid[1].points);
  HeightMap map{grid[0].points, grid[1].points, grid[0].pitch, grid[1].pitch, {}};
  map.x0 = grid[0].first;
  map.y0 = grid[1].first;
  const auto all = static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny);
  map.z.assign(all, std::numeric_limits<double>::quiet_NaN());
  std::vector<char> given(all, 0);
  for (const MapPoint& point : points) {
    std::array<int, 2> at{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double steps = (point.xyz[k] - grid[k].first) / grid[k].pitch;
      at[k] = static_cast<int>(std::lround(steps));
      if (std::abs(steps - at[k]) > kOffGrid) {
        throw InputError(text.place(*point.line, point.line->text),
                         fmt::format("this point lies {:.0f} % of a pitch off the even grid of the "
                                     "others; resample the points to one (Gwyddion: rasterize)",
                                     100.0 * std::abs(steps - at[k])));
      }
    }
    const std::size_t c = map.index(at[0], at[1]);
    if (given[c] != 0) {
      throw InputError(text.place(*point.line, point.line->text),
                       "this position has been given before; keep one of the points");
    }
    given[c] = 1;
    map.z[c] = point.xyz[2];
  }
  return map;
}

/// Whether the line begins with a word that is no height.
bool names_columns(std::string_view line) {
  const auto fields = map_fields(line);
  if (fields.empty() || fields.front().empty()) return false;
  const char first = fields.front().front();
  const bool letter = std::isalpha(static_cast<unsigned char>(first)) != 0;
  const std::string_view word = fields.front();
  return letter && word != "nan" && word != "NaN" && word != "NAN" && word != "bad" &&
         word != "Bad" && word != "BAD";
}

}  // namespace

HeightMap read_height_map(const std::string& path, Motion motion) {
  const MapText text(path);
  HeightMap map = names_columns(text.lines().front().text) ? read_columns(text) : read_matrix(text);
  return motion == Motion::x ? map : exchanged(map);
}

}  // namespace shellback::app
