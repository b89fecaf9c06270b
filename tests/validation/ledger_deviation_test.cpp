// Deviations that an entry documents: as documented they are no alarm, anything else is one.
#include "validation/ledger/ledger_deviation.hpp"

#include "tests/validation/ledger_scratch.hpp"

using namespace shellback;
using namespace shellback::validation;
using namespace shellback::validation::tests;

namespace {

/// The wide film's entry with one deviation of its middle row, documented from `from` to `to`
/// times what is allowed.
std::string entry_with(double from, double to, const std::string& column = "So") {
  return kEntry + "\n[[deviation]]\ncolumn = \"" + column +
         "\"\nwhere = { eps = 0.5 }\nfrom = " + std::to_string(from) +
         "\nto = " + std::to_string(to) + "\nwhy = \"a known misprint\"\n";
}

/// Judged with the middle value off by so many times what is allowed: ours are below theirs.
EntryReport off_by(double times, double from, double to) {
  const double theirs = 4.836798 / (1.0 - 0.005 * times);
  const std::string table = changed(kTable, "4.836798", std::to_string(theirs));
  return run_entry(ScratchLedger(entry_with(from, to), table).read(), {});
}

}  // namespace

TEST_CASE("ADeviationAsDocumentedIsNoAlarm") {
  const EntryReport report = off_by(2.0, -2.2, -1.8);
  CHECK(report.verdict() == Judgement::documented);
  CHECK(as_expected(report.verdict()));
  const QuantityReport& q = report.quantities.at(0);
  CHECK(q.judged == 3);  // the row counts among those judged, and in the root mean square
  CHECK(q.rows[1].judgement == Judgement::documented);
  CHECK(q.rows[1].reason == "a known misprint");
  CHECK(q.rms_relative > 0.004);
  REQUIRE(report.deviations.size() == 1);
  CHECK(report.deviations[0].complaint.empty());
  CHECK(report.deviations[0].found == Approx(-2.0).epsilon(0.03));  // ours is exact to 1e-4
}

TEST_CASE("ADeviationThatHasGrownIsOutside") {
  const EntryReport report = off_by(3.0, -2.2, -1.8);
  CHECK(report.verdict() == Judgement::outside);
  CHECK(report.deviations.at(0).complaint == "it has grown");
  CHECK(report.quantities[0].rows[1].reason.find("documented 1.8 to 2.2") == 0);
}

TEST_CASE("ADeviationThatHasShrunkOrDisappearedIsToldToo") {
  const EntryReport shrunk = off_by(1.5, -2.2, -1.8);
  CHECK(shrunk.verdict() == Judgement::changed);
  CHECK_FALSE(as_expected(shrunk.verdict()));
  CHECK(shrunk.deviations.at(0).complaint == "it has shrunk");
  const EntryReport gone = off_by(0.0, -2.2, -1.8);
  CHECK(gone.verdict() == Judgement::changed);
  CHECK(gone.quantities[0].rows[1].judgement == Judgement::within);
  CHECK(gone.deviations.at(0).complaint == "it has disappeared");
}

TEST_CASE("ADeviationToTheOtherSideIsOutside") {
  const EntryReport report = off_by(-2.0, -2.2, -1.8);
  CHECK(report.verdict() == Judgement::outside);
  CHECK(report.deviations.at(0).complaint == "it has disappeared");
}

TEST_CASE("ARowThatNoDeviationCoversIsOutside") {
  std::string table = changed(kTable, "4.836798", std::to_string(4.836798 / 0.99));
  table = changed(table, "1.886096", "1.95");
  const EntryReport report = run_entry(ScratchLedger(entry_with(-2.2, -1.8), table).read(), {});
  CHECK(report.verdict() == Judgement::outside);
  CHECK(report.quantities[0].rows[0].judgement == Judgement::outside);
  CHECK(report.quantities[0].rows[1].judgement == Judgement::documented);
  CHECK(report.deviations.at(0).complaint.empty());
}

TEST_CASE("ADeviationThatCannotBeIsRefused") {
  const auto error = [](const std::string& entry) { return ScratchLedger(entry).error(); };
  CHECK(error(entry_with(-2.2, -1.8)).empty());
  CHECK(error(entry_with(0.5, 1.8)).find("multiples of what is allowed") != std::string::npos);
  CHECK(error(entry_with(-1.8, 1.8)).find("multiples of what is allowed") != std::string::npos);
  CHECK(error(entry_with(1.8, 1.2)).find("lie above from") != std::string::npos);
  CHECK(error(entry_with(1.2, 1.8, "SO")).find("did you mean \"So\"?") != std::string::npos);
  CHECK(error(entry_with(1.2, 1.8, "eps")).find("no [[quantity]] compares") != std::string::npos);
}

TEST_CASE("EveryDocumentedDeviationOfTheLedgerHasItsNote") {
  for (const std::string& name : entry_names(SHELLBACK_SOURCE_DIR "/validation")) {
    const Entry entry = shipped(name);
    CAPTURE(name);
    CHECK((entry.deviations.empty() || !entry.note.empty()));
  }
}
