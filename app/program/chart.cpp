#include "validation/chart/chart.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

#include "app/pictures/write_png.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "app/progress.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "validation/chart/chart_csv.hpp"
#include "validation/chart/chart_picture.hpp"
#include "validation/chart/chart_scenes.hpp"

namespace shellback::program {

using namespace validation;

namespace {

/// The line on the terminal that says where the chart stands.
class ChartLine {
 public:
  ChartLine() : terminal_(isatty(STDERR_FILENO) == 1) {}
  ~ChartLine() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
  }
  ChartLine(const ChartLine&) = delete;
  ChartLine& operator=(const ChartLine&) = delete;
  void show(const std::string& what, int done, int of) {
    if (!terminal_) return;
    fmt::print(stderr, "\r\x1b[K[{}/{}] {}", done, of, what);
    std::fflush(stderr);
    shown_ = true;
  }

 private:
  bool terminal_;
  bool shown_ = false;
};

std::string percent(double part) { return fmt::format("{:.3g} %", 100.0 * part); }

/// The front of each scene in words, and what failed.
void print_scene(std::ostream& out, const ChartScene& scene) {
  out << fmt::format("{} ({})\n", scene.title, scene.name);
  if (scene.points.empty()) return;
  out << fmt::format(
      "  reference: friction torque {:.6g} N m (±{}), smallest film {:.5g} um (±{})\n",
      scene.reference[0].value, percent(scene.floor[0]), 1e6 * scene.reference[1].value,
      percent(scene.floor[1]));
  out << fmt::format("  {:<11} {:<11} {:>9} {:>11} {:>10} {:>10} {:>9}  {}\n", "varied", "", "grid",
                     "friction", "film", "T [K]", "ms", "matrices or sweeps");
  for (const ChartPoint& p : scene.points) {
    const ChartSetting& s = p.setting;
    const std::string grid =
        s.family == ChartFamily::automatic ? "auto" : fmt::format("{}x{}", s.grid[0], s.grid[1]);
    out << fmt::format("  {:<11} {:<11} {:>9} ", to_string(s.family), s.mark, grid);
    if (!p.verdict.good()) {
      out << fmt::format("{} after {:.3g} ms: {}\n", to_string(p.verdict.status), 1e3 * p.wall_s,
                         app::reason_of(p.verdict));
      continue;
    }
    const std::string kelvin = std::isfinite(p.error[2]) ? fmt::format("{:.3g}", p.error[2]) : "-";
    const bool front = p.on_front[0] || p.on_front[1] || p.on_front[2];
    out << fmt::format("{:>11} {:>10} {:>10} {:>9.3g}  {}{}\n", percent(p.error[0]),
                       percent(p.error[1]), kelvin, 1e3 * p.wall_s,
                       p.sweeps > 0 ? p.sweeps : p.factorizations, front ? "  front" : "");
  }
  out << "\n";
}

}  // namespace

int chart(const Request& request) {
  std::vector<std::pair<std::string, bearing::Case>> subjects;
  for (const std::string& name : request.scenes.empty() ? chart_scene_names() : request.scenes) {
    subjects.emplace_back(name, chart_case(name));
  }
  std::vector<std::string> inputs;
  for (const auto& [name, subject] : subjects) {
    const auto files = app::files_of_case(app::read_text_file(subject.path), subject.path);
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  Outputs outputs(request, inputs);
  ChartOptions options;
  options.threads = request.threads;
  options.stop = &app::catch_interrupt();
  if (request.quick) {
    options.grids = quick_grids();
    options.of_cycles = quick_cycle_grids();
    options.repeats = 1;
    options.tolerances = {0.1, 0.01};
  }
  std::vector<ChartScene> scenes;
  int code = kDone;
  {
    ChartLine line;
    options.tell = [&](const std::string& what, int done, int of) { line.show(what, done, of); };
    for (const auto& [name, subject] : subjects) {
      scenes.push_back(chart_scene(name, subject, options));
      code = worse_code(code, code_of(scenes.back().verdict));
      if (options.stop->load()) break;
    }
  }
  if (request.csv != "-") {
    for (const ChartScene& scene : scenes) print_scene(std::cout, scene);
  }
  for (const ChartScene& scene : scenes) {
    if (scene.verdict.good()) continue;
    std::cerr << "error: " << scene.name << ": " << to_string(scene.verdict.status) << ": "
              << app::reason_of(scene.verdict) << "\n";
  }
  outputs.give("-o", [&] { return chart_svg(scenes); });
  outputs.give("--png", [&] { return app::png_of(chart_svg(scenes)); });
  outputs.give("--csv", [&] { return chart_csv(scenes); });
  return outputs.code(code);
}

}  // namespace shellback::program
