#include "app/provenance.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/pending_file.hpp"
#include "core/contract.hpp"
#include "markup.hpp"
#include "synthetic.hpp"

using namespace shellback;

TEST_CASE("FingerprintMatchesPublishedFnv1aVectors") {
  // Test vectors published with the algorithm (Noll).
  CHECK(app::fnv1a_64("") == "cbf29ce484222325");
  CHECK(app::fnv1a_64("a") == "af63dc4c8601ec8c");
  CHECK(app::fnv1a_64("foobar") == "85944171f73967e8");
}

TEST_CASE("AFingerprintHoldsWhatTheCaseTakesIn") {
  auto c = test::synthetic_case();
  const std::string before = app::fingerprint(c);
  c.taken_in = {"angle [deg], load_x [N], load_y [N]\n0, 0, -1000\n"};
  const std::string with = app::fingerprint(c);
  CHECK(with != before);
  c.taken_in.front().back() = ' ';
  CHECK(app::fingerprint(c) != with);
}

TEST_CASE("ProvenanceNamesProgramInputAndLibraries") {
  const auto c = test::synthetic_case();
  const auto p = app::provenance(c);
  CHECK_FALSE(p.version.empty());
  CHECK_FALSE(p.git.empty());
  CHECK(p.input == c.path);
  CHECK(p.fingerprint == app::fingerprint(c));
  for (const char* name : {"Eigen", "SuiteSparse", "SUNDIALS", "GSL", "HDF5", "compiler"}) {
    const auto named = [&](const auto& library) { return library.first == name; };
    CHECK(std::any_of(p.libraries.begin(), p.libraries.end(), named));
  }
}

TEST_CASE("AFileAppearsOnlyWhenItIsComplete") {
  const test::ScratchFile scratch("pending.txt");
  const std::string& path = scratch.path();
  app::write_file(path, "first");
  {
    app::PendingFile pending(path);
    pending.write("half");
    CHECK(test::file_text(path) == "first");
  }  // given up
  CHECK(test::file_text(path) == "first");
  app::write_file(path, "second");
  CHECK(test::file_text(path) == "second");
}

TEST_CASE("AFileThatCannotBeWrittenIsAFileError") {
  CHECK_THROWS_AS(app::write_file("/nowhere/at/all.html", "text"), FileError);
}
