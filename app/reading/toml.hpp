#pragma once
/// toml++, made safe against any input. Include this instead of <toml++/toml.h>.
///
/// Version 3.3 asserts, and in release builds lets some compilers assume, that a table header
/// begins with a key: "[;x]" then ends the program, or worse. Behind the assertion it reports the
/// same as a syntax error, which is what we want of every file; so its assertions are off in all
/// builds and its assumptions as well.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
#include <cassert>  // again, with our NDEBUG
