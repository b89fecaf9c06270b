#pragma once
/// The command line: words in, exit code out.
#include <string>
#include <vector>

#include "app/program/request.hpp"

namespace shellback::program {

/// A finished reading of the command line: either a request or words to print and a code.
struct Reading {
  Request request;
  std::string words;  ///< help, version or what is wrong; printed instead of working
  int code = kDone;
};

/// Reads the words after the program's name. Never throws.
[[nodiscard]] Reading read_command_line(const std::vector<std::string>& words);

/// Does all: reads the words, works, prints, and gives the exit code. Never throws.
[[nodiscard]] int run_program(const std::vector<std::string>& words);

}  // namespace shellback::program
