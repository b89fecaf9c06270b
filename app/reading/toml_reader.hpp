#pragma once
/// Typed access to the tables of a case file, with a place, a reason and a cure in each error.
///
/// A Section declares the keys that belong to it (anything else is an error with did-you-mean),
/// hands out values in SI and remembers what it handed out: `expect_all_used` then finds keys
/// that are allowed but had no effect. All errors are InputError.
#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/reading/toml.hpp"
#include "app/reading/units.hpp"
#include "core/contract.hpp"
#include "core/range.hpp"

namespace shellback::app {

/// What gathers while a case is read.
struct Reader {
  std::string file;                           ///< name in messages
  std::map<std::string, std::string> places;  ///< dotted key -> "file:line:column"
  std::vector<std::string> assumptions;
  std::vector<std::string> warnings;
  std::set<const toml::node*> used;
  std::map<std::string, toml::table> documents;  ///< library files read, by path
  std::vector<std::string> tables;               ///< other files read: profile, load, pressure

  /// Place of the key, or of the nearest section around it, or the file.
  [[nodiscard]] std::string place(std::string key) const;
  [[nodiscard]] bool given(const std::string& key) const { return places.contains(key); }
};

/// Place and key before a problem; the key only once where the place names it already.
[[nodiscard]] InputError error_at(const std::string& place, const std::string& key,
                                  const std::string& problem);

/// Words for the alternatives of a choice.
template <class E>
using Choices = std::vector<std::pair<std::string, E>>;

class Section {
 public:
  /// `path` is the dotted name, "" for the whole file. Values missing in `table` are looked up
  /// in `behind` (a shipped oil behind the user's own numbers).
  Section(Reader& reader, const toml::table& table, std::string path,
          const toml::table* behind = nullptr);

  /// Declares all keys that may stand here; throws at the first that may not. `what` names the
  /// section in messages ("a hole").
  void only(std::initializer_list<const char*> keys, const std::string& what) const;

  [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }

  /// SI value of the key. Missing, no unit, wrong unit, not finite, out of range: error.
  [[nodiscard]] double quantity(const std::string& key, const Kind& kind,
                                const Range& range = kAnyValue) const;
  [[nodiscard]] std::optional<double> maybe_quantity(const std::string& key, const Kind& kind,
                                                     const Range& range = kAnyValue) const;
  /// The key's value or, if it is missing, `fallback`; `assumption` then goes on record.
  [[nodiscard]] double quantity_or(const std::string& key, const Kind& kind, double fallback,
                                   const std::string& assumption,
                                   const Range& range = kAnyValue) const;
  /// Pressure from `key` or, counted from vacuum, `key`_absolute; gauge [Pa].
  [[nodiscard]] std::optional<double> maybe_gauge_pressure(const std::string& key,
                                                           const Kind& kind = kPressure) const;

  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] bool is_text(const std::string& key) const;
  [[nodiscard]] bool is_table(const std::string& key) const;
  /// true, false, or nothing for "auto" and for a missing key.
  [[nodiscard]] std::optional<bool> maybe_switch(const std::string& key) const;
  [[nodiscard]] int whole_number(const std::string& key, int low, int high) const;
  [[nodiscard]] std::array<int, 2> pair_of_whole_numbers(const std::string& key, int low,
                                                         int high) const;
  [[nodiscard]] std::array<double, 2> pair_of_quantities(const std::string& key, const Kind& kind,
                                                         const std::string& example) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;

  /// The alternative that the key's word names.
  template <class E>
  [[nodiscard]] E choice(const std::string& key, const Choices<E>& choices) const {
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) words.push_back(word);
    return choices[choice_index(key, words)].second;
  }

  [[nodiscard]] Section section(const std::string& key) const;
  [[nodiscard]] std::optional<Section> maybe_section(const std::string& key) const;
  /// The tables of a list such as [[supply]]; empty if the key is missing.
  [[nodiscard]] std::vector<Section> sections(const std::string& key) const;

  void assume(const std::string& sentence) const { reader_->assumptions.push_back(sentence); }
  void warn(const std::string& key, const std::string& problem) const;
  /// Error at the key's value, or at this section if the key is not there (or is "").
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;
  /// The same of a file that the key names: FileError.
  [[noreturn]] void fail_file(const std::string& key, const std::string& problem) const;
  [[noreturn]] void fail_missing(const std::string& key, const std::string& example) const;

  /// Throws at the first key inside that was never asked for.
  void expect_all_used() const;
  /// The law table `key`. One that names its law stands alone; one that does not changes single
  /// parameters of the law behind it.
  [[nodiscard]] Section law(const std::string& key) const;

  [[nodiscard]] Reader& reader() const { return *reader_; }
  [[nodiscard]] const toml::table* table() const { return table_; }
  /// Dotted name of the key in the whole file.
  [[nodiscard]] std::string name(const std::string& key) const;

 private:
  [[nodiscard]] const toml::node* find(const std::string& key) const;
  [[nodiscard]] const toml::node& need(const std::string& key, const std::string& example) const;
  [[nodiscard]] double value_of(const toml::node& node, const std::string& key,
                                const Kind& kind) const;
  void check_range(const std::string& key, double value, const Kind& kind,
                   const Range& range) const;
  [[nodiscard]] std::size_t choice_index(const std::string& key,
                                         const std::vector<std::string>& words) const;
  [[nodiscard]] int whole(const toml::node& node, const std::string& key, int low, int high) const;

  Reader* reader_;
  const toml::table* table_;
  const toml::table* behind_;
  std::string path_;
};

}  // namespace shellback::app
