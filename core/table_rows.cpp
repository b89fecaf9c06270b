#include "core/table_rows.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

namespace shellback {

std::vector<std::vector<double>> table_rows(const char* text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool numbers = !line.empty() && std::isdigit(static_cast<unsigned char>(line[0])) != 0;
    if (!numbers) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    rows.emplace_back();
    for (double x = 0.0; cells >> x;) rows.back().push_back(x);
  }
  return rows;
}

}  // namespace shellback
