// The KS rig as a sum of its bearings, and the study on it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <mutex>

#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "core/constants.hpp"
#include "tests/app_output/markup.hpp"
#include "validation/rig/rig_bands.hpp"
#include "validation/rig/rig_page.hpp"
#include "validation/rig/rig_statements.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

bearing::CycleInstant at(double t, double torque, double asperity) {
  bearing::CycleInstant i;
  i.t = t;
  i.torque = torque;
  i.torque_asperity = asperity;
  return i;
}

RigPlan tiny_plan() {
  RigPlan plan;
  plan.peaks = {40e3};
  plan.rpm = {4000};
  plan.few_rpm = {4000};
  plan.grid = {48, 5};
  plan.hold = 20.0;
  plan.bands = false;
  return plan;
}

/// The study, stopped whenever `pieces` of its pieces have ended and gone on with from what was
/// kept of each; how often it was stopped is counted.
RigStudy in_pieces(const RigPlan& plan, int pieces, int& stops) {
  std::map<int, Tape::Content> kept;
  for (stops = 0;; ++stops) {
    std::mutex guard;
    std::map<int, bearing::KeptRun> runs;
    std::atomic<bool> stop{false};
    int ended = 0;
    StudyOptions options;
    options.threads = 2;  // one of two is stopped on its way
    options.stop = &stop;
    options.tell = [&](const std::string&, int done, int) {
      ended += done > 0 ? 1 : 0;
      if (ended == pieces) stop = true;
    };
    options.kept = [&](int k, const bearing::Case&, app::RunOf, const app::RunOptions&) {
      const std::lock_guard lock(guard);
      const auto save = [&, k](const Tape::Content& state) {
        const std::lock_guard saving(guard);
        kept[k] = state;
      };
      const auto found = kept.find(k);
      const auto made = found == kept.end() ? runs.try_emplace(k, save)
                                            : runs.try_emplace(k, save, found->second);
      return &made.first->second;
    };
    RigStudy study = run_rig_study(plan, options);
    if (!study.interrupted) return study;
    for (auto& [k, run] : runs) run.keep_noted();
    pieces = pieces + 2;  // that have ended, end again at once
  }
}

}  // namespace

TEST_CASE("TheRigCarriesItsLoadAndAddsItsTorques", "[rig]") {
  const auto loads = rig_loads(80e3);
  CHECK(loads[0] + loads[2] == Approx(loads[1]));
  CHECK(loads[0] == loads[2]);  // moments about mid-span
  CHECK(rig_torque({1.0, 2.0, 4.0}) == 7.0);
  CHECK(rig_torque({1.0, 2.0, 4.0}) == rig_torque({4.0, 2.0, 1.0}));
  CHECK(rig_torque(2.0, 0.5) == 3.0);
}

TEST_CASE("EveryUnknownOfTheRigIsACaseThatCanBeSolved", "[rig]") {
  std::vector<const RigUnknown*> all{&heavier_bodies()};
  for (const auto* unknowns : {&film_unknowns(), &body_unknowns()}) {
    for (const RigUnknown& u : *unknowns) all.push_back(&u);
  }
  for (const RigUnknown* unknown : all) {
    for (const int end : {0, 1}) {
      for (const RigBearing bearing : kRigBearings) {
        INFO(unknown->name << ", end " << end << ", " << to_string(bearing));
        CHECK_NOTHROW(rig_case(bearing, {80e3, 3000.0, {48, 7}, unknown, end}));
      }
    }
  }
  // Ten times the heat capacity of each ring, per volume.
  for (const RigBearing bearing : kRigBearings) {
    const auto stored = [&](const RigUnknown* unknown) {
      const auto c = rig_case(bearing, {80e3, 3000.0, {48, 7}, unknown, 1});
      const solid::Material& ring = c.shell->housing->material;
      return ring.density * ring.heat_capacity;
    };
    CHECK(stored(&heavier_bodies()) == Approx(10.0 * stored(nullptr)));
  }
}

TEST_CASE("TorquesAddAtEveryInstant", "[rig]") {
  // straight torques: interpolation is exact, whatever the instants
  const auto series = rig_series({at(0.0, 0.0, 0.0), at(0.3, 0.6, 0.3), at(1.0, 2.0, 1.0)},
                                 {at(0.0, 1.0, 0.5), at(0.5, 1.5, 0.5), at(1.0, 2.0, 0.5)});
  REQUIRE(series.size() == 3);
  for (const RigInstant& i : series) {
    CHECK(i.torque == Approx(2.0 * i.t + 2.0 * (1.0 + i.t)));
    CHECK(i.asperity == Approx(i.t + 1.0));
  }
}

TEST_CASE("TheFilmIsFullWhereAsperitiesRubLessThanAHundredth", "[rig]") {
  const std::vector<RigInstant> series{
      {0.0, 0.0, 1.0, 0.0}, {1.0, 0.0, 1.0, 0.9}, {2.0, 0.0, 1.0, 0.0}, {3.0, 0.0, 1.0, 0.5}};
  CHECK(time_of_full_film(series, 1.0) == Approx(1.0 + 0.89 / 0.9));
  CHECK(std::isnan(time_of_full_film(series, 100.0)));  // never above a hundredth of it
}

TEST_CASE("TheSubstituteLoadHasThePublishedPeak", "[rig]") {
  const auto test = rig_case(RigBearing::test, {80e3, 3000.0, {60, 9}, nullptr, 0});
  const auto numbers = bearing::cycle_numbers(*test.cycle, test.operation.omega);
  CHECK(numbers.largest == Approx(80e3).epsilon(1e-9));
  CHECK(numbers.angle == Approx(1.5 * kPi));
  CHECK(numbers.smallest == Approx(0.05 * 80e3).epsilon(1e-6));
  // 100 MPa on the projected area, as the paper rounds it
  CHECK(numbers.largest / rig_projected_area() == Approx(100e6).epsilon(0.03));
  const auto support = rig_case(RigBearing::support, {40e3, 3000.0, {60, 9}, nullptr, 0});
  CHECK(bearing::cycle_numbers(*support.cycle, 1.0).largest == Approx(20e3).epsilon(1e-9));
  for (const RigUnknown& u : film_unknowns()) {
    for (const int end : {0, 1}) {  // every end of every unknown is a case that reads
      for (const RigBearing b : kRigBearings) {
        const auto c =
            rig_isothermal_case(b, {80e3, 3000.0, {60, 9}, &u, end}, OilModel::pressure, 373.15);
        CHECK(c.cycle->period == Approx(12.5e-3 * u.stretched[static_cast<std::size_t>(end)]));
        CHECK_FALSE(*c.model.switches.shear_thinning);
        CHECK(*c.model.switches.pressure_dependence);
      }
    }
  }
}

TEST_CASE("ATinyStudyOfTheRigIsWholeAndInPiecesTheSame", "[rig]") {
  StudyOptions options;
  options.threads = 2;
  RigStudy study = run_rig_study(tiny_plan(), options);
  for (const std::string& line : rig_failures(study)) UNSCOPED_INFO(line);
  REQUIRE(study.count_failed() == 0);
  const auto torque = [&](OilModel oil, double warmer = 0.0) {
    return study.point(40e3, 4000.0, oil, warmer)->torque();
  };
  const RigPoint& full = *study.point(40e3, 4000.0, OilModel::full);
  // the same sum in another order: round-off
  CHECK(full.torque() == Approx(full.cycle[0].torque + 2.0 * full.cycle[1].torque).epsilon(1e-14));
  // pressure thickens the oil, shear and heat thin it
  CHECK(torque(OilModel::pressure) > torque(OilModel::temperature));
  CHECK(torque(OilModel::pressure) > torque(OilModel::full));
  CHECK(torque(OilModel::full) > torque(OilModel::full, study.plan.warmer));
  const RigStart& fresh = study.starts[0];
  CHECK(fresh.breakaway >= fresh.boundary);  // pressure that does not point along the load
  const auto statements = rig_statements(study);
  CHECK(statements.size() > 15);
  const std::string page = rig_page(study);
  CHECK(test::unbalanced_tag(page).empty());
  CHECK(page.find("substitute") != std::string::npos);
  CHECK(rig_json(study).find("\"friction_torque\"") != std::string::npos);

  int stops = 0;
  RigStudy pieces = in_pieces(tiny_plan(), 1, stops);
  CHECK(stops >= 3);
  pieces.wall_s = study.wall_s = 0.0;
  CHECK(rig_json(pieces) == rig_json(study));  // every digit
}

TEST_CASE("OnlyATorqueThatRisesBeforeTheStopDoes", "[rig]") {
  // Up and down again in six seconds, then at rest, where the torque is none.
  const auto judged = [](double new_at_stop, double worn_at_stop) {
    RigStudy study;
    for (const double at_stop : {new_at_stop, worn_at_stop}) {
      RigStart start;
      start.breakaway = start.boundary = 1.0;
      start.series = {{0.0, 0.0, 1.0, 1.0},
                      {3.0, 27.0, 0.4, 0.0},
                      {5.0, 9.0, 0.15, 0.0},
                      {5.9, 0.9, at_stop, 0.0},
                      {5.99, 0.009, 0.1 * at_stop, 0.0},  // friction of summits that stop to slide
                      {6.0, 6e-8, 0.001, 0.0}};
      study.starts.push_back(start);
    }
    study.starts[1].worn = true;
    const auto statements = rig_statements(study);
    const auto rises = [](const RigStatement& s) { return s.words.starts_with("torque rises"); };
    return std::find_if(statements.begin(), statements.end(), rises)->met;
  };
  CHECK(judged(0.8, 0.35) == Met::yes);
  CHECK(judged(0.1, 0.05) == Met::no);  // falls all the way
  CHECK(judged(0.8, 0.2) == Met::no);   // the worn one by a third
  CHECK(judged(0.35, 0.8) == Met::no);  // the worn one more
}

TEST_CASE("AStudyThatIsStoppedTellsWhatItHas", "[rig]") {
  const std::atomic<bool> stop{true};
  StudyOptions options;
  options.stop = &stop;
  const RigStudy study = run_rig_study(tiny_plan(), options);
  CHECK(study.interrupted);
  CHECK(study.count_failed() == 0);
  for (const RigStatement& s : rig_statements(study)) CHECK(s.met == Met::unknown);
  CHECK(rig_page(study).find("Interrupted") != std::string::npos);
  CHECK(rig_page(study).find("class=\"bad\">not found") == std::string::npos);
  CHECK(rig_json(study).find("\"interrupted\"") != std::string::npos);
}
