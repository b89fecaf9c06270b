#include "app/reading/sweep_case.hpp"

#include <fmt/format.h>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/units.hpp"
#include "core/contract.hpp"

namespace shellback::app {

using bearing::Case;
using study::Position;

namespace {

std::vector<std::string> words_at(const std::vector<study::Axis>& axes, const Position& at) {
  std::vector<std::string> words{word_at(axes.front(), at.along)};
  for (std::size_t a = 1; a < axes.size(); ++a) words.push_back(axes[a].words[at.across[a - 1]]);
  return words;
}

/// `set` and, last, the values of the axes.
std::vector<Override> overrides_at(std::vector<Override> set, const std::vector<study::Axis>& axes,
                                   const Position& at) {
  const std::vector<std::string> words = words_at(axes, at);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    set.push_back({axes[a].key, words[a], "--vary " + axes[a].key});
  }
  return set;
}

/// The error with the point in front of the problem.
[[noreturn]] void rethrow_at(const std::string& point, const InputError& error) {
  std::string problem = error.what();
  const std::string prefix = error.where() + ": ";
  if (!error.where().empty() && problem.starts_with(prefix)) problem.erase(0, prefix.size());
  throw InputError(error.where(), fmt::format("at {}: {}", point, problem));
}

}  // namespace

std::string position_words(const std::vector<study::Axis>& axes, const Position& at) {
  const std::vector<std::string> words = words_at(axes, at);
  std::string text;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    text += fmt::format("{}{} = {}", a == 0 ? "" : ", ", axes[a].key, words[a]);
  }
  return text;
}

std::string axis_words(const study::Axis& axis) {
  constexpr int kFew = 6;
  if (axis.size() <= kFew) return axis.key + " = " + comma_list(axis.words);
  return fmt::format("{} = {} to {}, {} values", axis.key, axis.words.front(), axis.words.back(),
                     axis.size());
}

study::CaseAt case_source(std::string text, std::string path, std::vector<Override> set,
                          std::vector<study::Axis> axes) {
  return [text = std::move(text), path = std::move(path), set = std::move(set),
          axes = std::move(axes)](const Position& at) {
    try {
      return read_case_text(text, path, overrides_at(set, axes, at));
    } catch (const InputError& error) {
      rethrow_at(position_words(axes, at), error);
    }
  };
}

void expect_speed_is_free(const Case& a, const Case& b, const std::string& option) {
  const bool own = a.cycle && b.cycle && !a.cycle->omega.empty();  // a crank's follow the key
  if (!own || a.cycle->omega != b.cycle->omega || a.operation.omega == b.operation.omega) return;
  throw InputError(option,
                   "the load cycle's table has speeds of its own; take its column speed away");
}

Case sweep_subject(const std::string& text, const std::string& path,
                   const std::vector<Override>& set, const std::vector<study::Axis>& axes) {
  const Position first{0.0, std::vector<int>(axes.size() - 1, 0)};
  const study::CaseAt case_at = case_source(text, path, set, axes);
  Case subject = case_at(first);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (axes[a].key != "operation.speed") continue;
    Position last = first;
    if (a == 0) last.along = axes[a].size() - 1;
    if (a > 0) last.across[a - 1] = axes[a].size() - 1;
    expect_speed_is_free(subject, case_at(last), "--vary operation.speed");
  }
  subject.verbatim = text;
  std::erase_if(subject.changes, [](const auto& change) { return change.option == "--vary"; });
  if (!text.ends_with('\n')) subject.verbatim += '\n';
  for (const Override& change : set) {
    subject.verbatim +=
        fmt::format("# changed on the command line: {} = {}\n", change.key, change.value);
  }
  for (const study::Axis& axis : axes)
    subject.verbatim += fmt::format("# varied: {}\n", axis_words(axis));
  return subject;
}

std::vector<std::string> files_of_sweep(const std::string& text, const std::string& path,
                                        const std::vector<Override>& set,
                                        const std::vector<study::Axis>& axes) {
  std::vector<std::string> files;
  const auto add = [&](const Position& at) {
    const auto more = files_of_case(text, path, overrides_at(set, axes, at));
    files.insert(files.end(), more.begin(), more.end());
  };
  const Position first{0.0, std::vector<int>(axes.size() - 1, 0)};
  add(first);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (!axes[a].numbers.empty()) continue;  // only words name files
    for (int k = 1; k < axes[a].size(); ++k) {
      Position at = first;
      if (a == 0) at.along = k;
      if (a > 0) at.across[a - 1] = k;
      add(at);
    }
  }
  return files;
}

std::optional<double> value_in_file(const std::string& text, const study::Axis& axis) {
  if (axis.numbers.empty()) return std::nullopt;
  toml::table root = parse_toml(text, "");
  const auto node = root.at_path(axis.key);
  if (axis.unit.empty()) return node.value<double>();
  const auto words = node.value<std::string>();
  const auto given = words ? number_and_unit(*words) : std::nullopt;
  return given && given->unit == axis.unit ? std::optional(given->number) : std::nullopt;
}

}  // namespace shellback::app
