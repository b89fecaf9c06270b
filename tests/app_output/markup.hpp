#pragma once
/// A small check of HTML and SVG text: every element that opens also closes, in order.
#include <string>

namespace shellback::test {

/// Empty if all tags balance, else what is wrong. Void HTML elements need not close.
[[nodiscard]] std::string unbalanced_tag(const std::string& markup);

/// Occurrences of `part` in `text`.
[[nodiscard]] int count(const std::string& text, const std::string& part);

/// A place for a file of this process alone: the tests of one program may run side by side.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Content of a file; empty if there is none.
[[nodiscard]] std::string file_text(const std::string& path);

}  // namespace shellback::test
