#pragma once
/// The whole program in one process, its streams caught.
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "app/program/cli.hpp"

namespace shellback::program::tests {

/// Where the program's ways are tested, not its numbers.
inline const std::string kCoarse = "model.grid=[48, 9]";

struct Ended {
  int code = 0;
  std::string out;
  std::string err;
};

inline Ended run_words(const std::vector<std::string>& words) {
  std::ostringstream out;
  std::ostringstream err;
  auto* cout = std::cout.rdbuf(out.rdbuf());
  auto* cerr = std::cerr.rdbuf(err.rdbuf());
  const int code = run_program(words);
  std::cout.rdbuf(cout);
  std::cerr.rdbuf(cerr);
  return {code, out.str(), err.str()};
}

}  // namespace shellback::program::tests
