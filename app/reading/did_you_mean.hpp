#pragma once
/// The nearest known word to a misspelt one.
#include <string>
#include <string_view>
#include <vector>

namespace shellback::app {

/// Edits (insert, delete, replace, swap of neighbours) that turn `a` into `b`
/// (optimal string alignment, textbook). A change of case alone counts as no edit.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The word of `known` nearest to `word` if it is near enough to be meant, or the only one with the
/// same last part (clearance, radial_clearance), else "".
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// `; did you mean "x"?` if there is a near word, else "".
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

/// `; did you mean "x"? possible: a, b, c`, without the question if there is no near word.
/// `possible` introduces the list ("shipped are").
[[nodiscard]] std::string choices_for(std::string_view word, const std::vector<std::string>& known,
                                      std::string_view possible);

/// a, b, c
[[nodiscard]] std::string comma_list(const std::vector<std::string>& words);

/// `text` as a quoted word for a message: control characters replaced, long text cut.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace shellback::app
