#pragma once
/// `shellback check`: what can be said about a case without solving it.
#include <iosfwd>

#include "bearing/case.hpp"

namespace shellback::app {

/// Whether a load cycle is estimated whole, by mobility: tens of milliseconds.
enum class WholeCycle { estimated, left_out };

/// Derived numbers, indicator numbers with words, warnings, assumptions, as a page of text.
void print_check(std::ostream& out, const bearing::Case& subject,
                 WholeCycle cycle = WholeCycle::estimated);

}  // namespace shellback::app
