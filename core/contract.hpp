#pragma once
/// What may go wrong at the border and inside.
///
/// Bad input throws InputError: problem, value with unit, why, cure. A broken contract between
/// our own functions is EXPECTS (checked in builds without NDEBUG). A solve that does not
/// converge is neither: it is an Outcome (core/outcome.hpp).
#include <cassert>
#include <stdexcept>
#include <string>

#define EXPECTS(condition) assert(condition)
#define ENSURES(condition) assert(condition)

namespace shellback {

/// Input that cannot be used. `where` is "file:line:column", or the key of a case that no file has
/// been read for (empty if the error has no place). Exit code 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, const std::string& problem)
      : std::runtime_error(where.empty() ? problem : where + ": " + problem),
        where_(std::move(where)) {}
  explicit InputError(const std::string& problem) : InputError("", problem) {}
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  std::string where_;
};

/// A file that cannot be read or written. Exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace shellback
