// A ledger that is written wrongly is refused with file, line, reason and cure.
#include "tests/validation/ledger_scratch.hpp"

using namespace shellback;
using namespace shellback::validation;
using namespace shellback::validation::tests;

namespace {

/// The message that a spoilt entry or table gives.
std::string entry_error(const std::string& from, const std::string& to) {
  return ScratchLedger(changed(kEntry, from, to)).error();
}
std::string table_error(const std::string& table) { return ScratchLedger(kEntry, table).error(); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("AGoodEntryIsRead") {
  CHECK(ScratchLedger().error().empty());
  const Entry entry = ScratchLedger().read();
  CHECK(entry.quantities.at(0).evidence == Evidence::exact);
  CHECK(entry.quantities.at(0).tolerance.relative == Approx(0.005));
  CHECK(entry.table->lines().size() == 3);
}

TEST_CASE("MisspeltKeysOfAnEntryAreRefusedAtTheirPlace") {
  const std::string message = entry_error("compared =", "comparred =");
  CHECK(contains(message, "wide/entry.toml:3:1"));
  CHECK(contains(message, "did you mean \"compared\""));
}

TEST_CASE("UnknownEvaluatorsAreRefusedWithTheNearestName") {
  const std::string message = entry_error("endlessly wide film", "endlesly wide film");
  CHECK(contains(message, "entry.toml:4:"));
  CHECK(contains(message, "did you mean \"endlessly wide film\""));
}

TEST_CASE("UnknownColumnsAreRefused") {
  CHECK(contains(entry_error("column = \"So\"", "column = \"SO\""), "there is no column \"SO\""));
  CHECK(contains(entry_error("x = \"eps\"", "x = \"epsilon\""), "there is no column \"epsilon\""));
}

TEST_CASE("NamesThatTheEvaluatorDoesNotGiveAreRefused") {
  const std::string message = entry_error("ours = \"load_number\"", "ours = \"load_numbr\"");
  CHECK(contains(message, "gives no value \"load_numbr\""));
  CHECK(contains(message, "did you mean \"load_number\""));
}

TEST_CASE("AToleranceOfNothingIsRefused") {
  const std::string message = entry_error("relative = \"0.5 %\"", "relative = \"0 %\"");
  CHECK(contains(message, "entry.toml:16:"));
  CHECK(contains(message, "a tolerance of nothing"));
}

TEST_CASE("UnknownKindsOfEvidenceAreRefused") {
  CHECK(contains(entry_error("kind = \"exact solution\"", "kind = \"measurement\""),
                 "\"measurement\" is not known"));
}

TEST_CASE("AnExclusionOfEverythingIsRefused") {
  const std::string entry = changed(kEntry, "[figure]", "[[exclude]]\nwhy = \"\"\n\n[figure]");
  CHECK(contains(ScratchLedger(entry).error(), "leave out every row"));
}

TEST_CASE("SpoiltTablesAreRefusedAtTheirLine") {
  CHECK(contains(table_error("# nothing\neps,So\n"), "no lines"));
  CHECK(contains(table_error("eps,eps\n1,2\n"), "named twice"));
  CHECK(contains(table_error("eps,So\n0.2,1.9,7\n"), "expected.csv:2:1: 3 cells"));
  const std::string message = table_error("# head\neps,So\n0.2,1.886096\n0.5,4,836798\n");
  CHECK(contains(message, "expected.csv:4:1"));  // a decimal comma makes a cell too many
  const std::string word = table_error("eps,So\n0.2,1.886096\n0.5,about 5\n");
  CHECK(contains(word, "expected.csv:3:1"));
  CHECK(contains(word, "\"about 5\" is no number"));
  CHECK(contains(table_error("eps,So\n0.2,nan\n"), "is no number"));
}

TEST_CASE("EmptyCellsAreNoValuesAndQuotientsAreNumbers") {
  const Table table("gamma,C\n1/9,1.5\n3,\n", "t.csv");
  CHECK(*table.number(0, "gamma") == Approx(1.0 / 9.0));
  CHECK_FALSE(table.number(1, "C").has_value());
  CHECK(table.numbers(1).count("C") == 0);
}

TEST_CASE("UnknownEntriesAreRefusedWithTheNearestName") {
  const std::string ledger = SHELLBACK_SOURCE_DIR "/validation";
  try {
    static_cast<void>(read_entries(ledger, {"sommerfelt"}));
    FAIL("read");
  } catch (const InputError& error) {
    CHECK(contains(error.what(), "did you mean \"sommerfeld\""));
  }
}

TEST_CASE("EveryShippedEntryIsReadAndSaysWhatItRestsOn") {
  const std::string ledger = SHELLBACK_SOURCE_DIR "/validation";
  const auto entries = read_entries(ledger, {});
  CHECK(entries.size() >= 15);
  for (const Entry& entry : entries) {
    CAPTURE(entry.name);
    CHECK_FALSE(entry.source.empty());
    for (const QuantitySpec& q : entry.quantities) CHECK_FALSE(q.why.empty());
  }
  CHECK(read_unrun(ledger).size() >= 10);
}
