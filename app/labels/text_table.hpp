#pragma once
/// Columns of text for a terminal.
#include <iosfwd>
#include <string>
#include <vector>

namespace shellback::app {

/// Lines of cells; the first `left` columns flush left, the others flush right.
class TextTable {
 public:
  explicit TextTable(std::size_t left = 1) : left_(left) {}
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  void rule() { rows_.emplace_back(); }
  void print(std::ostream& out) const;

 private:
  static constexpr std::size_t kGap = 2;  ///< blanks between columns
  std::size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace shellback::app
