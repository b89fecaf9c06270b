/// What is written of a sweep is what was computed; failed points are no values.
#include <hdf5.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/pending_file.hpp"
#include "app/pictures/svg_sweep.hpp"
#include "app/pictures/svg_sweep_parts.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_csv.hpp"
#include "app/write_json.hpp"
#include "app/write_sweep_hdf5.hpp"
#include "app/write_sweep_table.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/study/sweeps.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::study::tests;
using shellback::study::Sweep;
using shellback::study::SweepPoint;

namespace {

/// Solved, but for one point made to fail and one left undone.
Sweep broken_sweep() {
  const std::vector<study::Axis> axes{
      study::spaced_axis("operation.speed", 4000.0, 1000.0, 3, study::Spacing::logarithmic, "rpm"),
      study::listed_axis("operation.load", {1.0, 2.0}, "kN")};
  Sweep sweep = study::run_sweep(axes, plain_source(axes));
  REQUIRE(sweep.count_good() == 6);
  SweepPoint& failed = sweep.points[3];
  failed.result.quantities.clear();
  failed.result.verdict = {
      Status::iteration_limit, ending::FilmUnsettled{80, 1.0, 1.0, 0.0, 1e-6}, {0.0, 1e-3}};
  sweep.points[5] = {};
  return sweep;
}

std::vector<std::vector<std::string>> csv_cells(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (line[k] == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
        cells.back() += line[k++];
      } else if (line[k] == '"') {
        quoted = !quoted;
      } else if (line[k] == ',' && !quoted) {
        cells.emplace_back();
      } else {
        cells.back() += line[k];
      }
    }
    rows.push_back(cells);
  }
  return rows;
}

std::vector<double> values_of(hid_t file, const char* path) {
  const hid_t id = H5Dopen2(file, path, H5P_DEFAULT);
  REQUIRE(id >= 0);
  const hid_t space = H5Dget_space(id);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(id);
  return values;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("TheCsvHoldsEveryPointCurveAfterCurve") {
  const Sweep sweep = broken_sweep();
  const auto rows = csv_cells(sweep_csv(sweep));
  REQUIRE(rows.size() == 7);
  for (const auto& row : rows) REQUIRE(row.size() == rows[0].size());
  CHECK(rows[0][0] == "operation.speed [rpm]");
  const auto torque_at = static_cast<std::size_t>(
      std::find(rows[0].begin(), rows[0].end(), "friction_torque [N m]") - rows[0].begin());
  REQUIRE(torque_at < rows[0].size());
  for (int c = 0; c < 2; ++c) {
    for (int k = 0; k < 3; ++k) {
      const auto& row = rows[static_cast<std::size_t>(1 + 3 * c + k)];
      CHECK(std::stod(row[0]) == sweep.axes[0].numbers[k]);
      CHECK(std::stod(row[1]) == sweep.axes[1].numbers[c]);
      const SweepPoint& point = sweep.at(k, c);
      if (point.good()) {
        CHECK(std::stod(row[torque_at]) == torque(point));  // every digit
      } else {
        CHECK(row[torque_at].empty());
      }
    }
  }
  CHECK(rows[5][2] == "iteration limit");
  CHECK(rows[5].back() == app::reason_of(sweep.points[3].result.verdict));  // with its commas
  CHECK(rows[6][2] == "not started");
}

TEST_CASE("TheHdf5FileHoldsTheGridWithHolesForWhatFailed") {
  const ScratchFolder scratch;
  const Sweep sweep = broken_sweep();
  Case subject = bearing::tests::plain_case();
  subject.verbatim = "title = \"plain\"\n";
  const std::string path = scratch.path("sweep.h5");
  write_file(path, sweep_hdf5(subject, sweep));
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  const auto torques = values_of(file, "/quantities/friction_torque");
  const auto status = values_of(file, "/state/status");
  REQUIRE(torques.size() == sweep.points.size());
  for (std::size_t k = 0; k < torques.size(); ++k) {
    const SweepPoint& point = sweep.points[k];
    CHECK(std::isnan(torques[k]) == !point.good());
    if (point.good()) CHECK(torques[k] == torque(point));
  }
  CHECK(status == std::vector<double>{0, 0, 0, 1, 0, 5});
  CHECK(values_of(file, "/axes/operation.speed") == sweep.axes[0].numbers);
  const hid_t id = H5Dopen2(file, "/quantities/h_min", H5P_DEFAULT);
  hsize_t shape[2]{};
  const hid_t space = H5Dget_space(id);
  REQUIRE(H5Sget_simple_extent_ndims(space) == 2);
  H5Sget_simple_extent_dims(space, shape, nullptr);
  CHECK((shape[0] == 3 && shape[1] == 2));
  CHECK(H5Aexists(id, "units") > 0);
  CHECK(H5Aexists(id, "long_name") > 0);
  CHECK(H5Aexists(id, "axes") > 0);
  CHECK(H5Lexists(file, "/case/verbatim", H5P_DEFAULT) > 0);
  H5Sclose(space);
  H5Dclose(id);
  H5Fclose(file);
}

TEST_CASE("TheJsonGivesNoQuantitiesForWhatFailed") {
  const Sweep sweep = broken_sweep();
  const auto json = nlohmann::json::parse(sweep_json(bearing::tests::plain_case(), sweep));
  CHECK(json["converged"] == 4);
  CHECK(json["failed"] == 1);
  REQUIRE(json["points"].size() == 6);
  for (const auto& point : json["points"]) {
    CHECK(point.contains("quantities") == point["converged"].get<bool>());
  }
  CHECK(json["points"][4]["at"] == std::vector<int>{1, 1});
  CHECK(json["points"][4]["reason"] == app::reason_of(sweep.points[3].result.verdict));
  CHECK(json["axes"][0]["unit"] == "rpm");
}

TEST_CASE("TheTableNamesEveryFailureWithItsPoint") {
  std::ostringstream out;
  write_sweep_table(out, bearing::tests::plain_case(), broken_sweep());
  check_parts(out.str(), {"6 points, 4 converged, 1 not, 1 left by the interrupt",
                          "not solved at operation.speed = 2000 rpm, operation.load = 2 kN",
                          "did not settle", "not started"});
}

TEST_CASE("ThePictureCountsFailedPointsAndDrawsNone") {
  const ScratchFolder scratch;
  const auto drawn = [&](const Sweep& sweep) {
    const std::string path = scratch.path("sweep.svg");
    write_file(path, sweep_svg(kSampleCase, bearing::tests::plain_case(), sweep));
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  };
  Sweep sweep = broken_sweep();
  const std::string broken = drawn(sweep);
  CHECK(broken.find("4 converged, 1 not") != std::string::npos);
  CHECK(broken.find("nan") == std::string::npos);
  CHECK(broken.find("inf") == std::string::npos);
  sweep.points[3] = sweep.points[1];
  sweep.points[5] = sweep.points[1];
  const std::string whole = drawn(sweep);
  CHECK(whole.find("converged") == std::string::npos);
  // A dot per panel and solved point: two points more in each of four panels.
  CHECK(count_of(whole, "<circle") == count_of(broken, "<circle") + 2 * 4);
}

TEST_CASE("APictureHasRoomForErrorBars") {
  Sweep sweep = broken_sweep();
  const auto with_bars = [&](double part) {
    for (SweepPoint& point : sweep.points) {
      for (auto& q : point.result.quantities) q.error_grid = part * std::abs(q.value);
    }
    const auto q = app::drawn_quantity(sweep, "friction_torque");
    REQUIRE(q);
    return *q;
  };
  const auto bare = with_bars(0.0);
  CHECK(bare.lowest == Approx(bare.low));
  CHECK(bare.highest == Approx(bare.high));
  const auto narrow = with_bars(0.1);
  CHECK(narrow.low == bare.low);  // that of the colours of a map
  CHECK(narrow.lowest == Approx(0.9 * bare.low));
  CHECK(narrow.highest == Approx(1.1 * bare.high));
  const auto wide = with_bars(9.0);  // they do not press the curve together, nor below zero
  CHECK(wide.lowest >= 0.0);
  CHECK(wide.highest <= 1.5 * bare.high * (1.0 + 1e-12));
}

TEST_CASE("APictureNeedsNumbers") {
  CHECK_THROWS_AS(expect_drawable({study::word_axis("model.tier", {"thd", "tehd"})}), InputError);
  CHECK_THROWS_AS(expect_drawable({study::listed_axis("operation.load", {4.0}, "kN")}), InputError);
  CHECK_NOTHROW(expect_drawable({study::word_axis("model.tier", {"thd", "tehd"}),
                                 study::listed_axis("operation.load", {4.0, 8.0}, "kN")}));
}

TEST_CASE("ErrorBarsStandBesideTheirValues") {
  Sweep sweep = broken_sweep();
  for (auto& q : sweep.points[0].result.quantities) {
    q.error_grid = 0.01 * std::abs(q.value);
    q.error_time = 0.02 * std::abs(q.value);
  }
  const auto rows = csv_cells(sweep_csv(sweep));
  const auto at = std::find(rows[0].begin(), rows[0].end(), "friction_torque error [N m]");
  REQUIRE(at != rows[0].end());
  const auto column = static_cast<std::size_t>(at - rows[0].begin());
  CHECK(std::stod(rows[1][column]) == Approx(0.03 * torque(sweep.points[0])).epsilon(1e-12));
  CHECK(rows[2][column].empty());  // not known there: no bar, not a bar of zero
  const ScratchFolder scratch;
  write_file(scratch.path("bars.h5"), sweep_hdf5(bearing::tests::plain_case(), sweep));
  const hid_t file = H5Fopen(scratch.path("bars.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  for (const auto& [bars, part] : {std::pair{"errors", 0.03}, std::pair{"errors_grid", 0.01},
                                   std::pair{"errors_time", 0.02}}) {
    const auto values = values_of(file, ("/" + std::string(bars) + "/friction_torque").c_str());
    CHECK(values[0] == Approx(part * torque(sweep.points[0])).epsilon(1e-12));
    CHECK(std::isnan(values[1]));
  }
  CHECK(H5Lexists(file, "/errors_model/friction_torque", H5P_DEFAULT) == 0);  // nobody knows it
  H5Fclose(file);
}
