#include "app/labels/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace shellback::app {

void TextTable::print(std::ostream& out) const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::size_t total = 0;
  for (const auto width : widths) total += width + kGap;
  for (const auto& row : rows_) {
    std::string line(row.empty() ? total - kGap : 0, '-');
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string gap(k == 0 ? 0 : kGap, ' ');
      line += k < left_ ? fmt::format("{}{:<{}}", gap, row[k], widths[k])
                        : fmt::format("{}{:>{}}", gap, row[k], widths[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

}  // namespace shellback::app
