#include "app/reading/did_you_mean.hpp"

#include <algorithm>
#include <cctype>

namespace shellback::app {
namespace {

constexpr std::size_t kLongestWord = 60;   ///< longer words are no slips of the pen
constexpr std::size_t kLongestQuote = 60;  ///< bytes of the user's text shown in a message

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Edits that a word of this length may contain and still be recognised: 1 in 3 letters, 3 at most.
int allowed_edits(std::size_t length) { return std::min(3, static_cast<int>(length) / 3); }

/// What stands behind the last '_'.
std::string_view last_part(std::string_view word) {
  const auto at = word.rfind('_');
  return at == std::string_view::npos ? word : word.substr(at + 1);
}

/// The one known word that ends as this one does; none, or several: "".
std::string with_same_end(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t kSays = 5;  // letters that say something
  const std::string_view end = last_part(word);
  std::string found;
  if (end.size() < kSays) return found;
  for (const std::string& candidate : known) {
    if (last_part(candidate) != end) continue;
    if (!found.empty()) return "";
    found = candidate;
  }
  return found;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + replace});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  if (word.size() > kLongestWord) return best;
  int least = allowed_edits(word.size()) + 1;
  for (const std::string& candidate : known) {
    const int edits = edit_distance(word, candidate);
    if (edits < least) {
      least = edits;
      best = candidate;
    }
  }
  return best.empty() ? with_same_end(word, known) : best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string best = nearest(word, known);
  return best.empty() ? "" : "; did you mean \"" + best + "\"?";
}

std::string choices_for(std::string_view word, const std::vector<std::string>& known,
                        std::string_view possible) {
  const std::string question = did_you_mean(word, known);
  return (question.empty() ? ";" : question) + " " + std::string(possible) + ": " +
         comma_list(known);
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string in_quotes(std::string_view text) {
  std::string shown = "\"";
  const bool cut = text.size() > kLongestQuote;
  std::size_t end = cut ? kLongestQuote : text.size();
  // Do not cut a UTF-8 character in two: continuation bytes are 10xxxxxx.
  while (cut && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  for (const char c : text.substr(0, end)) {
    shown += static_cast<unsigned char>(c) < 0x20U || c == 0x7F ? '?' : c;
  }
  return shown + (cut ? "...\"" : "\"");
}

}  // namespace shellback::app
