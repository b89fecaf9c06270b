#include "app/hdf5_parts.hpp"
#include "app/pending_file.hpp"
#include "app/result_mark.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_cycle_hdf5.hpp"
#include "core/constants.hpp"
#include "hdf5_reader.hpp"
#include "markup.hpp"
#include "synthetic_cycle.hpp"

using namespace shellback;
using Shape = std::vector<hsize_t>;

namespace {

/// A cycle written to a file and opened again.
struct Written {
  explicit Written(const bearing::CycleResult& cycle) : scratch("cycle.h5") {
    app::write_file(scratch.path(), app::cycle_hdf5(test::cycle_case(), cycle));
  }
  test::ScratchFile scratch;
};

}  // namespace

TEST_CASE("SeriesOfACycleReadBackWithTheirUnits") {
  const auto cycle = test::synthetic_cycle();
  const Written written(cycle);
  const test::Reader file(written.scratch.path());
  const Shape n{cycle.instants.size()};
  for (const auto& [name, unit] :
       {std::pair{"t", "s"}, std::pair{"angle", "deg"}, std::pair{"h_min", "m"},
        std::pair{"eccentricity_x", "1"}, std::pair{"p_max", "Pa"},
        std::pair{"friction_torque", "N m"}, std::pair{"load_y", "N"}, std::pair{"speed", "rad/s"},
        std::pair{"side_flow", "m3/s"}, std::pair{"tilt_x", "rad"}, std::pair{"oil", "kg"}}) {
    INFO(name);
    const std::string path = std::string("series/") + name;
    CHECK(file.shape(path) == n);
    CHECK(file.text(path, "units") == unit);
  }
  const auto t = file.values("series/t");
  const auto angle = file.values("series/angle");
  const auto ex = file.values("series/eccentricity_x");
  for (std::size_t k = 0; k < t.size(); ++k) {
    CHECK(t[k] == cycle.instants[k].t);
    CHECK(angle[k] == Approx(t[k] * cycle.crank_speed * 180.0 / kPi));
    CHECK(ex[k] * test::cycle_case().bearing.radial_clearance == Approx(cycle.instants[k].ex));
  }
}

TEST_CASE("FieldsAndFramesOfACycleReadBack") {
  const auto cycle = test::synthetic_cycle();
  const Written written(cycle);
  const test::Reader file(written.scratch.path());
  CHECK(file.shape("fields/p_max") == Shape{60, 9});
  CHECK(file.values("fields/p_max") == cycle.fields.p_max);
  CHECK(file.values("fields/friction_power") == cycle.fields.friction_power);
  CHECK(file.text("fields/friction_power", "units") == "W/m2");
  for (const char* name : {"frames/p", "frames/theta", "frames/h"}) {
    CHECK(file.shape(name) == Shape{cycle.frames.size(), 60, 9});
    CHECK(file.text(name, "axes") == "t phi z");
  }
  CHECK(file.shape("frames/t") == Shape{cycle.frames.size()});
  const auto p = file.values("frames/p");
  const auto cells = cycle.frames[0].p.size();
  CHECK(std::vector<double>(p.begin() + cells, p.begin() + 2 * cells) == cycle.frames[1].p);
  CHECK(file.values("grid/phi") == cycle.fields.grid.phi);
}

TEST_CASE("ScalarsOfACycleReadBack") {
  const auto cycle = test::synthetic_cycle();
  const Written written(cycle);
  const test::Reader file(written.scratch.path());
  CHECK(file.number(".", "period") == cycle.period);
  CHECK(file.number(".", "steps") == cycle.steps);
  CHECK(file.number(".", "closure") == cycle.closure);
  CHECK(file.number("audit", "impulse") == cycle.audit.impulse);
  for (const auto& q : cycle.quantities) {
    CHECK(file.number("quantities", q.quantity.name) == q.quantity.value);
    CHECK(file.text("quantities", q.quantity.name + "_unit") == q.quantity.unit);
    if (!std::isfinite(q.at)) continue;
    CHECK(file.number("quantities", q.quantity.name + "_at") ==
          Approx(q.at * cycle.crank_speed * 180.0 / kPi));
    CHECK(file.text("quantities", q.quantity.name + "_at_unit") == "deg");
  }
  CHECK(file.has("case/verbatim"));
  std::vector<std::string> unlabelled;
  H5Ovisit2(file.file, H5_INDEX_NAME, H5_ITER_NATIVE, test::note_unlabelled, &unlabelled,
            H5O_INFO_BASIC);
  CHECK(unlabelled.empty());
  CHECK(app::is_result(written.scratch.path()));
}

TEST_CASE("AStoppedCycleIsAFileThatSaysSo") {
  const auto cycle = test::stopped_cycle();
  const Written written(cycle);
  const test::Reader file(written.scratch.path());
  CHECK(file.number(".", "converged") == 0.0);
  CHECK(file.text(".", "reason") == app::reason_of(cycle.verdict));
  CHECK(file.shape("series/h_min") == Shape{3});
  CHECK_FALSE(file.has("frames/p"));
  CHECK_FALSE(file.has("fields/p_max"));
}

TEST_CASE("ACycleWithoutACrankIsToldInTime") {
  const Written written(test::timed_cycle());
  const test::Reader file(written.scratch.path());
  CHECK_FALSE(file.has("series/angle"));
  CHECK(file.text("quantities", "h_min_at_unit") == "s");
}
