#pragma once
/// Where a result comes from: program, source state, input, libraries.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::app {

struct Provenance {
  std::string version;  ///< of the program
  std::string git;      ///< `git describe --always --dirty` of the source tree when built
  std::string input;    ///< path of the case file; empty: the case did not come from a file
  /// FNV-1a 64 of the case as it was run, 16 hexadecimal digits: the file's text, behind it what
  /// was changed on the command line, and behind that the texts of the files that it takes in.
  std::string fingerprint;
  std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version; compiler last
};

/// FNV-1a with 64 bits: from offset basis 0xcbf29ce484222325, per byte xor, then times
/// 0x100000001b3. Tells texts apart; not cryptographic. Textbook (Fowler, Noll, Vo).
[[nodiscard]] std::string fnv1a_64(std::string_view text);

/// That of Provenance.
[[nodiscard]] std::string fingerprint(const bearing::Case& c);

[[nodiscard]] Provenance provenance(const bearing::Case& c);

}  // namespace shellback::app
