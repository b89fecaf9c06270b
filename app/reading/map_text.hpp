#pragma once
/// The lines of a height map's file, before anything is known of its grid.
#include <string>
#include <string_view>
#include <vector>

#include "app/reading/units.hpp"

namespace shellback::app {

/// A line that holds no comment.
struct MapLine {
  int number = 0;  ///< in the file, from 1
  std::string_view text;
};

/// A value of the header, `# Width: 100 um`.
struct HeaderValue {
  int line = 0;  ///< 0: not given
  std::string text;
};

class MapText {
 public:
  /// Throws FileError if the file cannot be read, InputError if it is empty or beyond 200 MB.
  explicit MapText(const std::string& path);
  MapText(const MapText&) = delete;
  MapText& operator=(const MapText&) = delete;

  [[nodiscard]] const std::vector<MapLine>& lines() const { return lines_; }
  /// Of the comments; names without regard to case. Throws InputError if it is given twice.
  [[nodiscard]] HeaderValue header(const std::string& name) const;
  [[nodiscard]] const std::string& path() const { return path_; }
  /// "file:line:column" of a field of a line.
  [[nodiscard]] std::string place(const MapLine& line, std::string_view field) const;

 private:
  std::string path_;
  std::string text_;
  std::vector<MapLine> lines_;
  std::vector<MapLine> comments_;
};

/// The fields of a line, without the blanks around them; valid as long as the line.
[[nodiscard]] std::vector<std::string_view> map_fields(std::string_view line);

/// The number of a field, times `factor`; NaN for a hole. Throws InputError at `place`.
[[nodiscard]] double map_height(std::string_view field, double factor, const MapText& text,
                                const MapLine& line);

}  // namespace shellback::app
