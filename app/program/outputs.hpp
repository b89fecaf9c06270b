#pragma once
/// The files of one run: judged before the work, written after it.
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "app/output_rules.hpp"
#include "app/program/request.hpp"

namespace shellback::program {

/// Throws InputError, with `why`, at the first option that was asked for.
void refuse_options(std::initializer_list<std::pair<const char*, bool>> asked, const char* why);

/// Throws InputError if a file was asked for beside --list.
void refuse_outputs_of_a_list(const Request& request);

class Outputs {
 public:
  /// All that `request` writes, judged (app/output_rules.hpp). `inputs` are the files that the run
  /// reads; what comes with the program is never written to either. Throws InputError, FileError.
  Outputs(const Request& request, const std::vector<std::string>& inputs);

  /// Writes what `option` asks for, if it does. A file that cannot be written is told on standard
  /// error and does not keep the others from being written.
  void give(const std::string& option, const std::function<std::string()>& content);

  /// `code`, unless a file was lost.
  [[nodiscard]] int code(int code) const { return lost_ ? kBadFile : code; }

 private:
  std::vector<app::Output> wanted_;
  bool force_;
  bool lost_ = false;
};

}  // namespace shellback::program
