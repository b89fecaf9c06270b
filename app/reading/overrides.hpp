#pragma once
/// Changes to a case on the command line: --set operation.speed="1500 rpm".
#include <string>

#include "app/reading/toml.hpp"

namespace shellback::app {

/// One change. `place` is what an error names as its place, "--set operation.speed".
struct Override {
  std::string key;    ///< dotted; entries of lists by number from 0: supply.0.pressure
  std::string value;  ///< TOML, or a text without its quotes
  std::string place;
};

/// KEY=VALUE taken apart. Throws InputError if there is no "=" or no key.
[[nodiscard]] Override parse_override(const std::string& key_and_value);

/// Puts the value into the table, making tables on the way as needed. Throws InputError if the
/// key leads through a value that is no table, or past the end of a list.
void apply_override(toml::table& root, const Override& change);

}  // namespace shellback::app
