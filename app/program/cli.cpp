#include "app/program/cli.hpp"

#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <new>

#include "app/init.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "core/contract.hpp"

namespace shellback::program {
namespace {

using namespace app;

int init(const Request& request) {
  if (request.name.empty()) {
    refuse_outputs_of_a_list(request);
    list_cases(std::cout);
  } else {
    write_case(request.name, request.output, std::cout);
  }
  return kDone;
}

int work(const Request& request) {
  switch (request.command) {
    case Command::init:
      return init(request);
    case Command::check:
      return check(request);
    case Command::run:
      return run(request);
    case Command::report:
      return report(request);
    case Command::export_film:
      return export_film(request);
    case Command::help:
      return help(request);
    case Command::compare:
      return compare(request);
    case Command::auto_honesty:
      return auto_honesty(request);
    case Command::chart:
      return chart(request);
    case Command::stress:
      return stress(request);
    case Command::study:
      return study(request);
    case Command::surface:
      return surface(request);
    case Command::sweep:
      return sweep(request);
    case Command::identify:
      return identify(request);
    case Command::honesty:
      return honesty(request);
    case Command::validate:
      return validate(request);
    case Command::none:
      break;
  }
  return kBadInput;
}

/// The whole number behind the last colon of `text`, which is cut off; 0 if there is none.
std::size_t cut_number(std::string& text) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return 0;
  const std::string digits = text.substr(colon + 1);
  const bool number = !digits.empty() && digits.size() <= kMostDigits &&
                      digits.find_first_not_of("0123456789") == std::string::npos;
  if (!number) return 0;
  text.resize(colon);
  return std::stoul(digits);
}

/// The line that the error is about, with a mark under the place.
std::string excerpt(std::string where) {
  constexpr std::size_t kWidest = 160;  // longer lines tell nothing on a terminal
  const std::size_t column = cut_number(where);
  const std::size_t number = cut_number(where);
  if (number == 0 || column == 0) return "";
  std::ifstream file(where);
  std::string line;
  for (std::size_t n = 0; n < number; ++n) {
    if (!std::getline(file, line)) return "";
  }
  if (line.empty() || line.size() > kWidest || column > line.size() + 1) return "";
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20U) c = ' ';  // tabs would shift the mark
  }
  // Columns count characters, not bytes: the mark stands under the same character.
  return fmt::format("{:>6} | {}\n       | {:>{}}\n", number, line, "^", column);
}

}  // namespace

int run_program(const std::vector<std::string>& words) {
  try {
    const Reading reading = read_command_line(words);
    if (!reading.words.empty()) {
      (reading.code == kDone ? std::cout : std::cerr) << reading.words;
      return reading.code;
    }
    const int code = work(reading.request);
    std::cout.flush();
    if (!std::cout) {
      throw FileError(
          "cannot write to standard output: its reader is gone or its disk is full; send it "
          "elsewhere, or ask for files");
    }
    return code;
  } catch (const InputError& error) {
    std::cerr << "error: " << error.what() << "\n" << excerpt(error.where());
    return kBadInput;
  } catch (const FileError& error) {
    std::cerr << "error: " << error.what() << "\n";
    return kBadFile;
  } catch (const std::bad_alloc&) {
    std::cerr << "error: the case needs more memory than there is; take a coarser model.grid\n";
    return kNotConverged;
  } catch (const std::exception& error) {
    std::cerr << "error inside shellback, please report it with the case: " << error.what() << "\n";
    return kDefect;
  }
}

}  // namespace shellback::program
