#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <mutex>

#include "app/pictures/svg_surface.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "app/progress.hpp"
#include "app/reading/surface_report.hpp"
#include "app/reading/units.hpp"
#include "app/write_surface.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "core/range.hpp"

namespace shellback::program {

using namespace app;

namespace {

double value_of(const std::string& text, const char* option, const Kind& kind,
                const Range& range = kPositive) {
  const double value = given(option, text, kind);
  if (range.holds(value)) return value;
  throw InputError(option, fmt::format("{} must {}", text, range.words));
}

/// Rising positive numbers.
std::vector<double> gaps_of(const std::vector<std::string>& words) {
  constexpr double kWidest = 1000.0;  // factors are 1 to 1e-6 there [-]
  std::vector<double> gaps;
  for (const std::string& word : words) {
    gaps.push_back(value_of(
        word, "--gaps", kNumber,
        {0.0, kWidest, true, "be positive and at most 1000: surfaces so far apart are smooth"}));
    if (gaps.size() > 1 && gaps.back() <= gaps[gaps.size() - 2]) {
      throw InputError("--gaps", fmt::format("{} does not rise; give h/sigma from small to large, "
                                             "for example 0.5,1,2,3,6",
                                             fmt::join(words, ",")));
    }
  }
  constexpr std::size_t kFewest = 3;  // that a case can interpolate
  if (gaps.size() >= kFewest) return gaps;
  throw InputError("--gaps", "give three or more values of h/sigma, for example 0.5,1,2,3,6");
}

SurfaceOptions surface_options(const Request& request) {
  SurfaceOptions o;
  o.path = request.case_file;
  o.motion = request.motion == "y" ? Motion::y : Motion::x;
  o.form = request.form;
  o.fill = !request.fill.empty();
  o.periodic = request.periodic;
  if (!request.error.empty()) {
    o.error = value_of(request.error, "--error", kNumber,
                       {0.0, 1.0, true, "be positive and at most 100 %"});
  }
  if (!request.gaps.empty()) o.gaps = gaps_of(request.gaps);
  if (!request.modulus.empty()) {
    o.modulus = value_of(request.modulus, "--composite-modulus", kPressure);
  }
  if (!request.hardness.empty()) o.hardness = value_of(request.hardness, "--hardness", kPressure);
  return o;
}

}  // namespace

int surface(const Request& request) {
  SurfaceOptions options = surface_options(request);
  Outputs outputs(request, {request.case_file});
  ProgressLine line;
  std::mutex one_at_a_time;
  options.threads = request.cores > 0 ? request.cores : hardware_threads();
  options.stop = &catch_interrupt();
  options.progress = [&](int done, int of) {
    const std::lock_guard lock(one_at_a_time);
    line.show(fmt::format("flow factors: {} of {} gaps", done, of));
  };
  const SurfaceReport report = describe_surface(options);
  line.wipe();
  if (report.factors.rows.empty()) {
    std::cerr << "interrupted: the flow factors are not finished; nothing is written\n";
    return kInterrupted;
  }
  if (prints_tables(request)) write_surface_table(std::cout, report);
  outputs.give("--json", [&] { return surface_json(report); });
  outputs.give("--picture", [&] { return surface_svg(report); });
  if (!request.csv.empty()) {
    const std::string factors = surface_csv(report);  // may be refused: the others stand
    outputs.give("--csv", [&] { return factors; });
  }
  return outputs.code(kDone);
}

}  // namespace shellback::program
