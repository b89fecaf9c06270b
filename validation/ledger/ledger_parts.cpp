#include "validation/ledger/ledger_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/reading/did_you_mean.hpp"

namespace shellback::validation {

using namespace app;

namespace {

constexpr int kMostBetween = 50;

std::map<std::string, double> numbers_of(const Section& section, const std::string& key) {
  std::map<std::string, double> numbers;
  const auto table = section.maybe_section(key);
  if (!table) return numbers;
  for (auto&& [name, node] : *table->table()) {
    const std::string word(name.str());
    numbers[word] = table->quantity(word, kNumber);
  }
  return numbers;
}

Condition read_condition(const Section& section, const Table& table) {
  Condition c{numbers_of(section, "where"), numbers_of(section, "above"),
              numbers_of(section, "below")};
  for (const auto* part : {&c.at, &c.above, &c.below}) {
    for (const auto& [column, value] : *part) {
      if (!table.has(column)) section.fail("", "there is no column " + in_quotes(column));
    }
  }
  return c;
}

Panel read_panel(const Section& s, const Table& table) {
  s.only({"ours", "title", "head", "logarithmic", "where", "above", "below", "part"},
         "a [[figure.panel]]");
  Panel panel{s.text("ours"),           s.text("title"),
              text_or(s, "head", ""),   s.maybe_switch("logarithmic").value_or(false),
              read_condition(s, table), {}};
  for (const Section& part : s.sections("part")) {
    part.only({"ours", "title"}, "a [[figure.panel.part]]");
    panel.parts.push_back({part.text("ours"), part.text("title")});
  }
  return panel;
}

}  // namespace

std::string text_or(const Section& section, const std::string& key, const std::string& otherwise) {
  return section.has(key) ? section.text(key) : otherwise;
}

double number_or(const Section& section, const std::string& key, double otherwise) {
  return section.quantity_or(key, kNumber, otherwise, "");
}

std::string column_of(const Section& section, const std::string& key, const Table& table) {
  std::string column = section.text(key);
  if (!table.has(column)) {
    section.fail(key, fmt::format("there is no column {} in {}{}", in_quotes(column), table.path(),
                                  choices_for(column, table.columns(), "columns are")));
  }
  return column;
}

Evidence read_evidence(const Section& section) {
  Choices<Evidence> choices;
  for (int k = 0; k < kEvidences; ++k) {
    const auto evidence = static_cast<Evidence>(k);
    choices.emplace_back(to_string(evidence), evidence);
  }
  return section.choice<Evidence>("kind", choices);
}

Exclusion read_exclusion(const Section& s, const Table& table) {
  s.only({"columns", "where", "above", "below", "why"}, "an exclusion");
  Exclusion e{s.texts("columns"), read_condition(s, table), s.text("why")};
  if (e.where.at.empty() && e.where.above.empty() && e.where.below.empty()) {
    s.fail("", "this would leave out every row; say which with where, above or below");
  }
  return e;
}

Deviation read_deviation(const Section& s, const Table& table) {
  s.only({"column", "where", "above", "below", "from", "to", "why"}, "a [[deviation]]");
  Deviation d;
  d.column = column_of(s, "column", table);
  d.where = read_condition(s, table);
  d.from = s.quantity("from", kNumber);
  d.to = s.quantity("to", kNumber, {d.from, kInfinite, true, "lie above from"});
  if (std::abs(d.from) < 1.0 || std::abs(d.to) < 1.0 || d.from * d.to < 0.0) {
    s.fail("from",
           "from and to are multiples of what is allowed, of (ours - theirs): both at least 1, or "
           "both at most -1");
  }
  d.why = s.text("why");
  return d;
}

Feature read_feature(const Section& s, const Table& table) {
  s.only({"name", "minimum_of", "column", "along", "where", "above", "below", "from", "to", "unit",
          "kind", "why"},
         "a [[feature]]");
  Feature f;
  f.name = s.text("name");
  f.ours = s.text("minimum_of");
  f.column = column_of(s, "column", table);
  f.along = column_of(s, "along", table);
  f.where = read_condition(s, table);
  f.low = s.quantity("from", kNumber);
  f.high = s.quantity("to", kNumber, {f.low, kInfinite, true, "lie above from"});
  f.unit = text_or(s, "unit", "1");
  f.evidence = read_evidence(s);
  f.why = s.text("why");
  return f;
}

FigureSpec read_figure(const Section& file, const Table& table) {
  const Section s = file.section("figure");
  s.only({"x", "x_title", "x_logarithmic", "series", "series_title", "shown", "between", "panel"},
         "[figure]");
  FigureSpec f;
  f.x = column_of(s, "x", table);
  f.x_title = s.text("x_title");
  f.x_logarithmic = s.maybe_switch("x_logarithmic").value_or(false);
  if (s.has("series")) f.series = column_of(s, "series", table);
  f.series_title = text_or(s, "series_title", f.series);
  for (const std::string& text : s.texts("shown")) f.shown.push_back(parse_quantity(text, kNumber));
  if (s.has("between")) f.between = s.whole_number("between", 0, kMostBetween);
  for (const Section& panel : s.sections("panel")) f.panels.push_back(read_panel(panel, table));
  if (f.panels.empty()) s.fail("panel", "the figure has no [[figure.panel]]: nothing to draw");
  return f;
}

}  // namespace shellback::validation
