#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "app/labels/command_words.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/progress.hpp"
#include "validation/stress/stress_list.hpp"
#include "validation/stress/stress_map.hpp"
#include "validation/stress/stress_picture.hpp"
#include "validation/stress/stress_table.hpp"
#include "validation/stress/stress_words.hpp"

namespace shellback::program {

using namespace validation;

namespace {

void list_scenes(const std::vector<StressScene>& scenes) {
  for (const StressScene& scene : scenes) {
    std::cout << fmt::format("{:<36} {} ({} values)\n", full_name(scene), scene.title,
                             scene.steps.size());
  }
}

/// Default cells that are neither a result nor a refusal on physical grounds, with the command
/// that repeats each.
void print_open_cells(const StressMap& map) {
  for (const StressRow& row : map.rows) {
    for (std::size_t k = 0; k < row.cells.front().size(); ++k) {
      const StressCell& cell = row.cells.front()[k];
      const bool open = cell.result == StressClass::not_found || cell.result == StressClass::missed;
      if (!is_fault(cell.result) && !open) continue;
      std::cout << fmt::format(
          "{} {}: {}: {}\n    {}\n", full_name(row.scene), row.scene.steps[k].label,
          to_string(cell.result), cell.why,
          repeat_command(row.scene, row.scene.steps[k], stress_methods().front()));
    }
  }
}

/// The link from the page's folder to the picture; blanks end a link of Markdown.
std::string link_to(const std::string& picture, const std::string& page) {
  const auto from = std::filesystem::absolute(page).parent_path();
  std::string link;
  for (const char c : std::filesystem::absolute(picture).lexically_relative(from).string()) {
    link += c == ' ' ? std::string("%20") : std::string(1, c);
  }
  return link;
}

std::string command_line(const Request& request) {
  std::string words = "shellback stress";
  for (const std::string& scene : request.scenes) words += " " + scene;
  if (request.quick) words += " --quick";
  if (request.only_default) words += " --only-default";
  words += fmt::format(" --limit {:g}", request.limit_s);
  if (!request.output.empty()) words += " -o " + app::shell_word(request.output);
  if (!request.table.empty()) words += " --table " + app::shell_word(request.table);
  return words;
}

}  // namespace

int stress(const Request& request) {
  const auto scenes = chosen_stress_scenes(shipped_stress_scenes(request.quick), request.scenes);
  if (request.list) {
    refuse_outputs_of_a_list(request);
    list_scenes(scenes);
    return kDone;
  }
  Outputs outputs(request, {});
  StressOptions options;
  options.at_once = request.threads;
  options.limit_s = request.limit_s;
  options.only_default = request.only_default;
  options.stop = &app::catch_interrupt();
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal) {
    options.tell = [](const std::string& what, int done, int of) {
      fmt::print(stderr, "\r\x1b[K[{}/{}] {}", done, of, what);
      std::fflush(stderr);
    };
  }
  const StressMap map = stress_map(scenes, options);
  if (terminal) fmt::print(stderr, "\r\x1b[K");
  if (prints_tables(request)) {
    std::cout << stress_summary(map) << "\n";
    print_open_cells(map);
  }
  outputs.give("-o", [&] { return stress_svg(map); });
  outputs.give("--table", [&] {
    const std::string link = request.output.empty() ? "" : link_to(request.output, request.table);
    return stress_page(map, link, command_line(request));
  });
  outputs.give("--csv", [&] { return stress_csv(map); });
  outputs.give("--json", [&] { return stress_json(map); });
  if (!map.complete) {
    std::cerr << "interrupted: cells are missing; what was finished is written\n";
    return outputs.code(kInterrupted);
  }
  return outputs.code(map.shipped_is_sound() ? kDone : kNotConverged);
}

}  // namespace shellback::program
