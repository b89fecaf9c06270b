#include <hdf5.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "app/pending_file.hpp"
#include "app/write_hdf5.hpp"
#include "core/contract.hpp"
#include "hdf5_reader.hpp"
#include "markup.hpp"
#include "synthetic.hpp"

using namespace shellback;
using test::Reader;

TEST_CASE("FieldsReadBackAreThoseWritten") {
  const test::ScratchFile scratch("output.h5");
  const auto result = test::synthetic_result();
  app::write_file(scratch.path(), app::result_hdf5(test::synthetic_case(), result));
  const Reader file(scratch.path());
  const auto& f = result.fields;
  using Shape = std::vector<hsize_t>;
  CHECK(file.values("fields/p") == f.p);
  CHECK(file.values("fields/theta") == f.theta);
  CHECK(file.values("fields/h") == f.h);
  CHECK(file.values("fields/tau_journal") == f.tau_journal);
  CHECK(file.values("fields/T") == f.T);
  CHECK(file.values("fields/T_solid") == f.T_solid);
  CHECK(file.values("grid/phi") == f.grid.phi);
  CHECK(file.values("grid/z") == f.grid.z);
  CHECK(file.values("grid/s") == f.s);
  CHECK(file.shape("fields/p") == Shape{200, 25});
  CHECK(file.shape("fields/T") == Shape{200, 25, 5});
  CHECK(file.shape("fields/T_solid") == Shape{200, 8});
  CHECK(file.text("fields/T", "axes") == "phi z s");
  CHECK(file.values("fields/supplied") ==
        std::vector<double>(f.supplied.begin(), f.supplied.end()));
}

TEST_CASE("ScalarsReadBackWithTheirUnits") {
  const test::ScratchFile scratch("output.h5");
  const auto result = test::synthetic_result();
  app::write_file(scratch.path(), app::result_hdf5(test::synthetic_case(), result));
  const Reader file(scratch.path());
  for (const auto& q : result.quantities) {
    CHECK(file.number("quantities", q.name) == q.value);
    CHECK(file.text("quantities", q.name + "_unit") == q.unit);
  }
  CHECK(file.number("audit", "mass") == result.audit.mass);
  CHECK(file.number(".", "converged") == 1.0);
  CHECK(file.text(".", "tier") == "tehd");
  CHECK(file.values("history/residual").size() == result.history.size());
  CHECK(file.text("provenance", "input") == test::synthetic_case().path);
}

TEST_CASE("EveryDatasetNamesItsUnitsAndMeaning") {
  const test::ScratchFile scratch("output.h5");
  app::write_file(scratch.path(),
                  app::result_hdf5(test::synthetic_case(), test::synthetic_result()));
  const Reader file(scratch.path());
  std::vector<std::string> unlabelled;
  H5Ovisit2(file.file, H5_INDEX_NAME, H5_ITER_NATIVE, test::note_unlabelled, &unlabelled,
            H5O_INFO_BASIC);
  CHECK(unlabelled.empty());
  CHECK(file.text("fields/p", "units") == "Pa");
  CHECK(file.text("fields/T_mean", "units") == "K");
}

TEST_CASE("TheVerbatimCaseIsKept") {
  const test::ScratchFile scratch("output.h5");
  const auto c = test::synthetic_case();
  app::write_file(scratch.path(), app::result_hdf5(c, test::synthetic_result()));
  const Reader file(scratch.path());
  const hid_t id = H5Dopen2(file.file, "case/verbatim", H5P_DEFAULT);
  const hid_t type = H5Dget_type(id);
  char* text = nullptr;
  H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
  CHECK(std::string(text) == c.verbatim);
  H5free_memory(text);
  H5Tclose(type);
  H5Dclose(id);
}

TEST_CASE("FieldsOfAFailedSolveAreMarkedAsSuch") {
  const test::ScratchFile scratch("output.h5");
  app::write_file(scratch.path(), app::result_hdf5(test::synthetic_case(),
                                                   test::not_converged(test::synthetic_result())));
  const Reader file(scratch.path());
  CHECK(file.number(".", "converged") == 0.0);
  CHECK(file.text(".", "status") == "iteration limit");
  CHECK_FALSE(file.text(".", "reason").empty());
  CHECK(file.text("fields/p", "state").find("not converged") != std::string::npos);
}

TEST_CASE("FieldsTheTierDoesNotHaveAreAbsent") {
  const test::ScratchFile scratch("output.h5");
  app::write_file(scratch.path(), app::result_hdf5(test::synthetic_case(),
                                                   test::synthetic_comparison().results.front()));
  const Reader file(scratch.path());
  CHECK(file.has("fields/p"));
  CHECK_FALSE(file.has("fields/T"));
  CHECK_FALSE(file.has("fields/T_solid"));
  CHECK(std::isnan(file.number("audit", "energy")));
}

TEST_CASE("AResultWithoutAnyFieldsOrNotesIsStillWritten") {
  const test::ScratchFile scratch("output.h5");
  bearing::Result bare;
  CHECK_NOTHROW(app::write_file(scratch.path(), app::result_hdf5(bearing::Case{}, bare)));
  const Reader file(scratch.path());
  CHECK(file.shape("notes/warnings") == std::vector<hsize_t>{0});
}

TEST_CASE("AFailedWriteKeepsTheOlderFileAndLeavesNothingElse") {
  const test::ScratchFile scratch("output_folder");
  const std::string& folder = scratch.path();
  CHECK_THROWS_AS(app::write_file(folder + "/r.h5", app::result_hdf5(test::synthetic_case(),
                                                                     test::synthetic_result())),
                  FileError);
  CHECK_FALSE(std::filesystem::exists(folder));
  // A folder of the wanted name cannot be replaced by a file.
  std::filesystem::create_directories(folder + "/r.h5/inside");
  CHECK_THROWS_AS(app::write_file(folder + "/r.h5", app::result_hdf5(test::synthetic_case(),
                                                                     test::synthetic_result())),
                  FileError);
  const auto left = std::distance(std::filesystem::directory_iterator(folder),
                                  std::filesystem::directory_iterator());
  CHECK(left == 1);
}
