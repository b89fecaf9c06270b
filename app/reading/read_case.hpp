#pragma once
/// A case file in, a judged Case out: the only way from a user's words to the solver's numbers.
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// Reads, changes by `overrides`, checks and judges the case in the file. `tiers` are those it
/// must have the data for; empty: its own tier only.
/// Throws FileError if the file cannot be read and InputError for anything wrong in it.
[[nodiscard]] bearing::Case read_case(const std::string& path,
                                      const std::vector<Override>& overrides = {},
                                      const std::vector<bearing::Tier>& tiers = {});

/// The same from text; `path` names it in messages, and files it refers to lie beside it.
[[nodiscard]] bearing::Case read_case_text(const std::string& text, const std::string& path,
                                           const std::vector<Override>& overrides = {},
                                           const std::vector<bearing::Tier>& tiers = {});

/// The tables beside the case that it refers to: profile, load, pressure. Throws likewise.
[[nodiscard]] std::vector<std::string> tables_of_case(const std::string& text,
                                                      const std::string& path);

/// Every file that this reading takes in: the case, its tables, oils and materials. Throws
/// likewise.
[[nodiscard]] std::vector<std::string> files_of_case(const std::string& text,
                                                     const std::string& path,
                                                     const std::vector<Override>& overrides = {},
                                                     const std::vector<bearing::Tier>& tiers = {});

/// The tier of that name ("isothermal", "lumped", "thd", "tehd"). Throws InputError at `place`.
[[nodiscard]] bearing::Tier tier_named(const std::string& name, const std::string& place);

}  // namespace shellback::app
