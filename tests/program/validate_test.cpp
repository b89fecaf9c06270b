/// shellback validate: exit codes and streams.
#include <catch2/catch.hpp>

#include "tests/program/run_words.hpp"
#include "tests/proof/ledger_scratch.hpp"

using namespace shellback;
using namespace shellback::program;
using namespace shellback::program::tests;
using namespace shellback::proof::tests;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

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
