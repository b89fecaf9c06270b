#pragma once
/// A ledger in a folder of its own: an exact reference that takes no time, and ways to spoil it.
#include <filesystem>
#include <string>

#include "tests/app/sample_case.hpp"
#include "validation/ledger/ledger_read.hpp"
#include "validation/ledger/ledger_run.hpp"

namespace shellback::validation::tests {

/// Sommerfeld's film at two eccentricities (6 pi eps/((2 + eps^2) sqrt(1 - eps^2))).
inline const std::string kEntry = R"toml(title = "wide film"
source = "textbook"
compared = "load number"
evaluator = "endlessly wide film"
expected = "expected.csv"

[settings]
cells = "200"
cavitation = "none"

[[quantity]]
name = "load number"
column = "So"
ours = "load_number"
kind = "exact solution"
tolerance = { relative = "0.5 %" }
why = "second order"

[figure]
x = "eps"
x_title = "eps"

[[figure.panel]]
ours = "load_number"
title = "So"
)toml";
inline const std::string kTable =
    "# closed form\neps,So\n0.2,1.886096\n0.5,4.836798\n0.8,9.519975\n";

/// `text` with the first `from` replaced.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

class ScratchLedger {
 public:
  explicit ScratchLedger(const std::string& entry = kEntry, const std::string& table = kTable) {
    std::filesystem::create_directories(folder_.path("wide"));
    static_cast<void>(folder_.write("wide/entry.toml", entry));
    static_cast<void>(folder_.write("wide/expected.csv", table));
  }
  [[nodiscard]] std::string path() const { return folder_.path(""); }
  [[nodiscard]] Entry read() const { return read_entry(path(), "wide"); }
  [[nodiscard]] std::string error() const {
    try {
      static_cast<void>(run_entry(read(), {}));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  app::ScratchFolder folder_;
};

/// Entries of the repository.
[[nodiscard]] inline Entry shipped(const std::string& name) {
  return read_entry(SHELLBACK_SOURCE_DIR "/validation", name);
}

}  // namespace shellback::validation::tests
