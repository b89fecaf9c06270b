#pragma once
/// The reference of the case file (docs/case-file.md, which the tests hold against the readers) for
/// a terminal.
#include <string>
#include <vector>

namespace shellback::app {

/// The page as it stands in docs.
[[nodiscard]] const char* case_page();

/// What stands under the headings of `page` that name one of `sections` (all: none is named), each
/// key in the form in which a case gives it, then its meaning and its default; at most 92 columns
/// wide. Throws InputError for a section that the page does not have.
[[nodiscard]] std::string key_reference(const std::string& page,
                                        const std::vector<std::string>& sections);

/// Names in the headings of `page`: bearing, supply, ...
[[nodiscard]] std::vector<std::string> sections_of(const std::string& page);

}  // namespace shellback::app
