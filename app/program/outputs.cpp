#include "app/program/outputs.hpp"

#include <algorithm>
#include <iostream>

#include "app/pending_file.hpp"
#include "app/reading/library.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using app::Format;
using app::Output;

namespace {

/// What -o writes.
Format main_format(Command command) {
  switch (command) {
    case Command::run:
    case Command::sweep:
      return Format::hdf5;
    case Command::compare:
    case Command::report:
    case Command::study:
    case Command::validate:
      return Format::html;
    default:
      return Format::svg;
  }
}

/// The one list of everything that any command writes.
std::vector<Output> wanted_by(const Request& request) {
  std::vector<Output> wanted{
      {"-o", request.output, main_format(request.command)},
      {"--json", request.json, Format::json},
      {"--csv", request.csv, Format::csv},
      {"--profile", request.profile, Format::csv},
      {"--coefficients-table", request.coefficients_table, Format::coefficients},
      {"--picture", request.picture, Format::svg},
      {"--page", request.page, Format::html},
      {"--state", request.state, Format::hdf5},
      {"--png", request.png, Format::png},
      {"--table", request.table, Format::markdown}};
  std::erase_if(wanted, [](const Output& output) { return output.path.empty(); });
  for (const Output& output : wanted) {
    if (output.path != "-" || output.option == "--json" || output.option == "--csv") continue;
    throw InputError(output.option,
                     "only --json and --csv take - for standard output; give a file");
  }
  return wanted;
}

}  // namespace

void refuse_options(std::initializer_list<std::pair<const char*, bool>> asked, const char* why) {
  for (const auto& [option, is_asked] : asked) {
    if (is_asked) throw InputError(option, why);
  }
}

void refuse_outputs_of_a_list(const Request& request) {
  refuse_options({{"-o", !request.output.empty()},
                  {"--table", !request.table.empty()},
                  {"--csv", !request.csv.empty()},
                  {"--json", !request.json.empty()}},
                 "a list runs nothing that could be written; name what to run");
}

Outputs::Outputs(const Request& request, const std::vector<std::string>& inputs)
    : wanted_(wanted_by(request)), force_(request.force) {
  if (wanted_.empty()) return;
  std::vector<std::string> all = inputs;
  const std::vector<std::string> shipped = app::shipped_files();
  all.insert(all.end(), shipped.begin(), shipped.end());
  app::expect_sound(wanted_, all, force_);
}

void Outputs::give(const std::string& option, const std::function<std::string()>& content) {
  const auto output = std::find_if(wanted_.begin(), wanted_.end(),
                                   [&](const Output& o) { return o.option == option; });
  if (output == wanted_.end()) return;
  std::cout.flush();  // what is printed already stays, whatever happens to the file
  try {
    const std::string bytes = app::marked(output->format, content());
    if (output->path == "-") {
      std::cout << bytes;
      return;
    }
    app::expect_replaceable(*output, force_);
    app::write_file(output->path, bytes);
  } catch (const std::runtime_error& error) {  // InputError or FileError
    std::cerr << "error: " << error.what() << "\n";
    lost_ = true;
  }
}

}  // namespace shellback::program
