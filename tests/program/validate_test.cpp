/// shellback validate: exit codes and streams.
#include <catch2/catch.hpp>

#include "tests/contains.hpp"
#include "tests/program/run_words.hpp"
#include "tests/validation/ledger_scratch.hpp"

using namespace shellback;
using namespace shellback::program;
using namespace shellback::program::tests;
using test::contains;
using namespace shellback::validation::tests;

TEST_CASE("AnEntryWithinEndsWithZero") {
  const ScratchLedger ledger;
  const Ended ended = run_words({"validate", "--ledger", ledger.path()});
  CHECK(ended.code == kDone);
  CHECK(contains(ended.out, "1 of 1 entries within"));
  CHECK(ended.err.empty());
}

TEST_CASE("AnEntryOutsideEndsWithThreeAndIsNamed") {
  const ScratchLedger ledger(kEntry, changed(kTable, "4.836798", "5.5"));
  const Ended ended = run_words({"validate", "wide", "--ledger", ledger.path()});
  CHECK(ended.code == kNotConverged);
  CHECK(contains(ended.err, "error: wide: outside: load number"));
}

TEST_CASE("AnEntryAsItsNoteSaysEndsWithZeroAndOtherwiseWithThree") {
  const auto entry_with = [](const char* range) {
    return kEntry + "\n[[deviation]]\ncolumn = \"So\"\nwhere = { eps = 0.5 }\n" + range +
           "\nwhy = \"a known misprint\"\n";
  };
  const std::string table = changed(kTable, "4.836798", "4.90");  // 2.6 times what is allowed
  const ScratchLedger known(entry_with("from = -2.8\nto = -2.4"), table);
  const Ended ended = run_words({"validate", "--ledger", known.path()});
  CHECK(ended.code == kDone);
  CHECK(contains(ended.out, "0 of 1 entries within; outside as documented: wide"));
  CHECK(contains(ended.out, "a known misprint"));
  CHECK(ended.err.empty());
  const ScratchLedger grown(entry_with("from = -2.2\nto = -1.8"), table);
  const Ended more = run_words({"validate", "--ledger", grown.path()});
  CHECK(more.code == kNotConverged);
  CHECK(contains(more.err, "error: wide: outside: load number"));
  CHECK(contains(more.err, "it has grown"));
  const ScratchLedger gone(entry_with("from = -2.8\nto = -2.4"));
  const Ended none = run_words({"validate", "--ledger", gone.path()});
  CHECK(none.code == kNotConverged);
  CHECK(contains(none.err, "error: wide: not as documented: load number"));
  CHECK(contains(none.err, "it has disappeared"));
  CHECK(contains(none.err, "wide/entry.toml"));
}

TEST_CASE("AMisspeltEntryEndsWithTwoAndTheNearestName") {
  const Ended ended = run_words({"validate", "raimondi-bod"});
  CHECK(ended.code == kBadInput);
  CHECK(contains(ended.err, "did you mean \"raimondi-boyd\""));
}

TEST_CASE("TheListRunsNothing") {
  const Ended ended = run_words({"validate", "--list"});
  CHECK(ended.code == kDone);
  CHECK(contains(ended.out, "ks-stribeck"));
  CHECK(contains(ended.out, "not runnable"));
  CHECK_FALSE(contains(ended.out, "verdict"));
}

TEST_CASE("JsonOnStandardOutputStandsAlone") {
  const ScratchLedger ledger;
  const Ended ended = run_words({"validate", "--ledger", ledger.path(), "--json", "-"});
  CHECK(ended.code == kDone);
  CHECK(ended.out.front() == '{');
}
