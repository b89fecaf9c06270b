#include "validation/stress/stress_expectation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace shellback::validation {
namespace {

constexpr const char* kSteadyTo = "steady to ";
constexpr const char* kNoneFrom = "none from ";
constexpr const char* kSeparator = "; ";

std::size_t place_of_label(const std::string& label, const std::vector<std::string>& labels) {
  const auto found = std::find(labels.begin(), labels.end(), label);
  if (found != labels.end()) return static_cast<std::size_t>(found - labels.begin());
  throw std::invalid_argument(fmt::format("\"{}\" is none of the scene's values", label));
}

void read_part(const std::string& part, const std::vector<std::string>& labels,
               StressExpectation& e) {
  const auto rest = [&](const char* beginning) {
    return part.substr(std::string(beginning).size());
  };
  if (part == "steady") {
    e.steady_before = labels.size();
  } else if (part.starts_with(kSteadyTo)) {
    e.steady_before = place_of_label(rest(kSteadyTo), labels) + 1;
  } else if (part.starts_with(kNoneFrom)) {
    e.none_from = place_of_label(rest(kNoneFrom), labels);
  } else {
    throw std::invalid_argument(fmt::format(
        "\"{}\" is no expectation; write \"steady\", \"steady to VALUE\", \"none from VALUE\" or "
        "\"steady to VALUE; none from VALUE\"",
        part));
  }
}

}  // namespace

StressExpectation expectation_from(const std::string& words,
                                   const std::vector<std::string>& labels) {
  StressExpectation e;
  e.words = words;
  std::size_t begin = 0;
  while (begin <= words.size()) {
    const std::size_t end = std::min(words.find(kSeparator, begin), words.size());
    read_part(words.substr(begin, end - begin), labels, e);
    begin = end + std::string(kSeparator).size();
  }
  if (e.steady_before > e.none_from) {
    throw std::invalid_argument("a steady state is expected where none is expected");
  }
  return e;
}

}  // namespace shellback::validation
