#pragma once
/// The named units, their factors to SI and the prefixes that engineers put before them.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellback::app {

/// Powers of the base dimensions.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int temperature = 0;
  int angle = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A unit: SI value = factor * number + offset.
struct Unit {
  double factor = 1.0;
  Dimension dimension;
  double offset = 0.0;  ///< [K]; only scales with their own zero have one
  bool scale = false;   ///< degC, degF: no part of products
};

/// The unit of that symbol, with its prefix if it has one; nothing if there is none.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view symbol);

/// Every symbol that find_unit knows, for did-you-mean.
[[nodiscard]] std::vector<std::string> unit_symbols();

}  // namespace shellback::app
