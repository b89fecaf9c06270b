#pragma once
/// What a run may write, judged before it works.
///
///   - An output never is an input, whatever the two are called.
///   - It never replaces a file that is no result (app/result_mark.hpp), unless by force. An empty
///     file holds nothing to be lost and may be replaced.
///   - The extension of its name does not promise another format.
///   - Two outputs are two files.
///   - Its folder is there and takes new files.
///
/// Devices, pipes and standard output take whatever comes.
#include <string>
#include <vector>

#include "app/result_mark.hpp"

namespace shellback::app {

/// An output that is asked for.
struct Output {
  std::string option;  ///< on the command line
  std::string path;    ///< "-": standard output
  Format format = Format::json;
};

/// Throws InputError, or FileError where the file system says no.
void expect_sound(const std::vector<Output>& outputs, const std::vector<std::string>& inputs,
                  bool force);

/// The one rule that can break while the run works: somebody else has written a file of this name.
/// Throws InputError.
void expect_replaceable(const Output& output, bool force);

}  // namespace shellback::app
