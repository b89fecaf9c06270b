#include "validation/stress/stress_row.hpp"

namespace shellback::validation {

std::vector<std::string> words_of(const StressScene& scene, const StressStep& step,
                                  const StressMethodWords& method) {
  std::vector<std::string> words = scene.words;
  words.insert(words.end(), step.words.begin(), step.words.end());
  words.insert(words.end(), method.words.begin(), method.words.end());
  return words;
}

}  // namespace shellback::validation
