#pragma once
/// `shellback check`: what can be said about a case without solving it.
#include <iosfwd>

#include "bearing/case.hpp"

namespace shellback::app {

/// Derived numbers, indicator numbers with words, warnings, assumptions, as a page of text.
void print_check(std::ostream& out, const bearing::Case& subject);

}  // namespace shellback::app
