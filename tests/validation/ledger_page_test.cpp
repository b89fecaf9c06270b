// What the ledger writes: every row, bands where inputs are unknown, nothing that breaks a page.
#include "validation/ledger/ledger_page.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/validation/ledger_scratch.hpp"
#include "validation/ledger/ledger_json.hpp"
#include "validation/ledger/ledger_text.hpp"

using namespace shellback;
using namespace shellback::validation;
using namespace shellback::validation::tests;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("EveryRowOfEveryQuantityIsWritten") {
  const EntryReport report = run_entry(shipped("long-bearing"), {});
  std::size_t values = 0;
  for (const QuantityReport& q : report.quantities) values += q.rows.size();
  CHECK(count(ledger_csv({report}), "\n") == values + 1);  // and the header
  const auto json = nlohmann::json::parse(ledger_json({report}, {}));
  std::size_t rows = 0;
  for (const auto& q : json["entries"][0]["quantities"]) rows += q["rows"].size();
  CHECK(rows == values);
  CHECK(json["entries"][0]["verdict"] == "within");
}

TEST_CASE("ThePageTellsWithinFromOutsideAndKindsApart") {
  Entry entry = ScratchLedger(kEntry, changed(kTable, "4.836798", "5.5")).read();
  entry.quantities.push_back(entry.quantities[0]);
  entry.quantities[1].evidence = Evidence::own;
  const std::string page = ledger_page({run_entry(entry, {})}, {{"a dataset", "its <reason>"}});
  CHECK(count(page, ">outside</span>") >= 2);
  const auto exact = page.find("<th colspan=\"5\">exact solution");
  const auto own = page.find("<th colspan=\"5\">own regression");
  REQUIRE(exact != std::string::npos);
  REQUIRE(own != std::string::npos);
  CHECK(exact < own);
  CHECK(count(page, "its &lt;reason&gt;") == 1);
}

TEST_CASE("ADocumentedDeviationIsWrittenWithItsReasonAndWhatWasFound") {
  Entry entry = ScratchLedger(kEntry, changed(kTable, "4.836798", "4.90")).read();
  entry.deviations.push_back({"So", {{{"eps", 0.5}}, {}, {}}, -2.8, -2.4, "a known <misprint>"});
  const EntryReport report = run_entry(entry, {});
  const std::string page = ledger_page({report}, {});
  CHECK(count(page, ">as documented</span>") >= 2);
  CHECK(count(page, "a known &lt;misprint&gt;") == 2);  // in the list and at the row
  const auto json = nlohmann::json::parse(ledger_json({report}, {}));
  const auto& written = json["entries"][0]["deviations"][0];
  CHECK(written["as_documented"] == true);
  CHECK(written["found"].get<double>() == Approx(-2.58).epsilon(0.03));
}

TEST_CASE("OutsideTextCannotBreakThePage") {
  Entry entry = ScratchLedger().read();
  entry.title = entry.note = entry.source = "<script>\"&";
  entry.figure.panels[0].head = "<b>";
  const std::string page = ledger_page({run_entry(entry, {})}, {});
  CHECK(count(page, "<script>") == 0);
  CHECK(count(page, "<b>") == 0);
  CHECK(count(page, "&lt;script&gt;") >= 3);
}

TEST_CASE("UnknownInputsSpanABand") {
  Entry entry = shipped("ks-stribeck");
  entry.features.clear();
  entry.unknowns.resize(1);  // the clearance: less of it is more torque in the full film
  entry.table =
      Table("load_N,rpm,M_ref_Nm,hmin_ref_um,M_from_400_Nm\n4000,2000,0.7,,0.7\n", "reduced");
  entry.figure.series.clear();
  entry.bearings.resize(1);
  std::erase_if(entry.vary, [](const Vary& v) { return v.bearing == "support"; });
  LedgerOptions options;
  options.bands = true;
  const EntryReport report = run_entry(entry, options);
  const BandWidth band = band_at(report, "total_friction_torque", 0);
  const double taken = report.points[0].values.value.at("total_friction_torque");
  const double low_clearance = report.bands[0].side[0][0].value.at("total_friction_torque");
  CHECK(band.high == Approx(low_clearance));
  CHECK(band.low < taken);
  // Petroff: torque goes with 1/c; 0.8 of the clearance gives up to 1.25 times the torque.
  CHECK(low_clearance / taken > 1.05);
  CHECK(low_clearance / taken < 1.25);
}

TEST_CASE("TheTableNamesTheWorstRow") {
  const Entry entry = ScratchLedger(kEntry, changed(kTable, "4.836798", "5.5")).read();
  std::ostringstream out;
  write_entry_table(out, run_entry(entry, {}), RowsShown::worst);
  CHECK(count(out.str(), "eps 0.5") == 2);  // as the worst row, and as the one outside
  CHECK(count(out.str(), "outside") == 2);
  CHECK(count(out.str(), "eps 0.2") == 0);
}
