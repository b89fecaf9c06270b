// The worn shape as it is written, and the shipped bearing that has one.
#include "bearing/over_time/running_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/sections.hpp"
#include "app/result_mark.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_running_in.hpp"
#include "bearing/bore_shape.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::bearing;
using shellback::bearing::tests::torque_of;

namespace {

/// Integral of what the table has over the bearing: its points are the middles of the cells.
double volume_of(const Profile& table, const FilmGrid& g) {
  Bearing b;
  b.shape = table;
  double sum = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) sum += g.area(i, j) * shape_at(b, g.phi[i], g.z[j]);
  }
  return sum;
}

/// Archard's volume per time of a state, (C/H) int p_a |U| dA [m3/s].
double rate_of(const Case& c, const Solution& s) {
  const FilmGrid& g = s.model.domain.grid;
  double force = 0.0;
  for (int k = 0; k < g.cells(); ++k) {
    force += g.multiplicity() * g.area(k) * s.film.p_contact[k];
  }
  const double U = c.operation.omega * c.bearing.radius;
  return c.running_in->wear_coefficient / c.running_in->hardness * U * force;
}

/// Slow, loaded and fed by a hole.
const std::string kSlowCase = R"toml(title = "slow"

[bearing]
diameter = "50 mm"
width = "25 mm"
radial_clearance = "30 um"
reference_temperature = "20 degC"

[[supply]]
kind = "hole"
angle = "90 deg"
diameter = "5 mm"
depth = "1 mm"
pressure = "2 bar"
temperature = "60 degC"

[operation]
speed = "100 rpm"
load = "12 kN"

[oil]
name = "0W20"
temperature = "60 degC"

[shell]
layers = [ { material = "AlSn20", thickness = "0.3 mm" }, { material = "steel", thickness = "1.7 mm" } ]
housing = { material = "steel", outer_diameter = "90 mm", support = "held" }
back = { heat_transfer = "500 W/(m2 K)", ambient = "50 degC" }
end_heat_transfer = "50 W/(m2 K)"

[shaft]
material = "steel"
overhang = "20 mm"
heat_transfer = "50 W/(m2 K)"
ambient = "40 degC"

[surfaces]
shell = { roughness = "0.34 um", orientation = 1, summit_roughness = "0.28 um", summit_height = "0.39 um" }
shaft = { roughness = "0.20 um", orientation = 1, summit_roughness = "0.13 um", summit_height = "0.21 um" }
contact = { elastic_factor = 0.001, composite_modulus = "53.3 GPa", friction = 0.08 }

[model]
tier = "thd"
grid = [36, 5]
edges = "flooded"
cavitation_pressure = "0 bar"

[running_in]
wear_coefficient = 1e-7
hardness = "350 MPa"
until = "1000 s"
)toml";

}  // namespace

TEST_CASE("TheWrittenProfileHoldsTheVolumeThatArchardWears") {
  Case c = bearing::tests::rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {60, 13};
  c.operation.omega = 600.0 * kPi / 30.0;
  c.bearing.shape = Profile{{0.0}, {0.0}, {1.5e-6}};  // what was there before is not worn
  c.running_in = RunningIn{1e-7, 350e6, 20.0, 0.0, {}, 0.0};
  double worn = 0.0, t = 0.0, rate = NAN;  // by the trapezoid over the steps
  const RunningInRun run = run_in(c, Tier::isothermal, {}, [&](const RunningInRun& at) {
    const double now = rate_of(c, at.solution);
    const double later = at.states.back().t;
    if (later > t) worn += 0.5 * (later - t) * (rate + now);
    rate = now;
    t = later;
  });
  INFO(reason_of(run.verdict));
  REQUIRE(run.verdict.good());
  const ScratchFolder scratch;
  const Profile written = read_profile(scratch.write("worn.csv", worn_shape_csv(c, run)));
  double before = 0.0;
  for (int i = 0; i < run.grid.nt; ++i) {
    for (int j = 0; j < run.grid.nz; ++j) before += 1.5e-6 * run.grid.area(i, j);
  }
  const double volume = volume_of(written, run.grid) - before;
  // ten digits of the whole height are written; the wear is 4e-4 of it
  CHECK(std::abs(volume - run.states.back().volume) < 1e-9 * before);
  // the trapezoid over five states of a rate that falls, steps that err by 0.1 % of the depth
  CHECK(volume / worn == Approx(1.0).epsilon(0.005));
  CHECK(run.states.size() > 3);
}

TEST_CASE("ARunningInTellsWhatItsLastStateHasToSay") {
  Case c = bearing::tests::rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {48, 9};
  c.operation.omega = 100.0 * kPi / 30.0;
  bearing::tests::set_load(c, 20e3);
  c.surfaces.contact->hardness = 1e6;  // summits flow at the edges, worn or not
  c.running_in = RunningIn{1e-9, 350e6, 1.0, 0.0, {}, 0.0};
  const RunningInRun run = run_in(c, Tier::isothermal);
  INFO(reason_of(run.verdict));
  REQUIRE(run.verdict.good());
  const auto words = words_of_last_state(run);
  const auto says = [&](const std::string& part) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& line) {
      return line.find(part) != std::string::npos;
    });
  };
  CHECK(says("held at the hardness of 1 MPa"));
  check_parts(running_in_json(c, run, {}), {"\"warnings\"", "held at the hardness of 1 MPa",
                                            "\"case\"", "\"changes\"", "\"assumptions\""});
  CHECK(worn_surface_keys(c, run).empty());
  // The profile tells the surface that belongs to it, as keys that --set takes, and is read with
  // it.
  c.running_in->worn = c.surfaces.shell;
  c.running_in->worn->roughness *= 0.5;
  c.running_in->worn_after = 2.0 * *std::max_element(run.wear.begin(), run.wear.end());
  const std::string keys = worn_surface_keys(c, run);
  const std::string half = fmt::format("--set 'surfaces.shell.roughness=\"{:.6g} um\"",
                                       0.75e6 * c.surfaces.shell.roughness);
  CHECK(keys.starts_with(half));
  const ScratchFolder scratch;
  const std::string csv = worn_shape_csv(c, run);
  CHECK(csv.find(keys) != std::string::npos);
  CHECK(read_profile(scratch.write("worn.csv", marked(Format::csv, csv))).z.size() ==
        static_cast<std::size_t>(run.grid.nz) + 2);
}

TEST_CASE("ARunningInTellsHowFarItsEndIsFromTheTolerance") {
  Case c = tests::plain_case();
  c.model.tolerance = 0.05;
  RunningInRun run;
  run.states.resize(2);
  run.states[1] = RunningInState{100.0};
  run.states[1].depth = 2e-6;
  run.states[1].torque = -1.0;  // turns the other way
  run.states[1].h_min = 1e-6;
  fidelity::RunningInBars bars;
  bars.tried = true;
  CHECK(words_of_bars(c, run, bars).size() == 1);  // that none are known
  bars.grid.resize(2);
  bars.time.resize(2);
  bars.grid[1].depth = 0.02e-6;
  bars.time[1].depth = 0.10e-6;
  bars.grid[1].torque = 0.03;
  bars.grid[1].h_min = NAN;
  bars.grid[0].torque = 1.0;  // on the way, not at the end
  const auto told = words_of_bars(c, run, bars);
  REQUIRE(told.size() == 2);
  CHECK(told[1].find("bars of smallest film are not known whole") != std::string::npos);
  CHECK(
      told[0] ==
      "model.tolerance (5 %) is not met at the end: greatest wear +-6.0 % (most of it the steps in "
      "time)");
  bars.time[1].depth = 0.0;
  CHECK(words_of_bars(c, run, bars).size() == 1);
  bars.grid[1].h_min = 0.0;
  CHECK(words_of_bars(c, run, bars).empty());
  // Known of the grid alone: what is known is told, and that it is not all.
  bars.grid[1].depth = 0.2e-6;
  bars.time[1].depth = NAN;
  const auto partly = words_of_bars(c, run, bars);
  REQUIRE(partly.size() == 2);
  CHECK(partly[0].find("greatest wear +-10 % at least") != std::string::npos);
  CHECK(partly[1].find("bars of greatest wear") != std::string::npos);
}

TEST_CASE("AShapeThatIsNotFinishedSaysSo") {
  const ScratchFolder scratch;
  const std::string path = scratch.write("slow.toml", kSlowCase);
  const Case c =
      read_case(path, {{"model.tier", "\"isothermal\"", ""}, {"model.grid", "[36, 5]", ""}});
  RunningInRun run = run_in(c, Tier::isothermal);
  REQUIRE(run.verdict.good());
  const auto warned = [&] {
    scratch.write("worn.csv", marked(Format::csv, worn_shape_csv(c, run)));
    return read_case(path, {{"bearing.shape", "\"worn.csv\"", ""}}).warnings;
  };
  CHECK(warned().empty());
  run.verdict = {Status::interrupted};
  const auto told = warned();
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("bearing.shape") != std::string::npos);
  CHECK(told[0].find("not finished") != std::string::npos);
}

TEST_CASE("AWornInShapeIsTheOneThatWearArrivesAt") {
  // Rigid surfaces, half in contact: deeper shapes exist at which the contact rests at the limit,
  // too, and acceleration led to one (1.16 um for 0.78), or round about for ever.
  const ScratchFolder scratch;
  const std::string path = scratch.write("slow.toml", kSlowCase);
  for (const double limit : {1.5e6, 2e6, 2.5e6}) {
    INFO(limit << " Pa");
    Case c = read_case(path, {{"model.tier", "\"isothermal\"", ""},
                              {"operation.load", "\"6 kN\"", ""},
                              {"model.grid", "[48, 7]", ""}});
    c.running_in->limit_pressure = limit;
    c.running_in->duration = 1e5;
    const RunningInRun in_time = run_in(c, Tier::isothermal);
    REQUIRE(in_time.verdict.good());
    c.running_in->duration.reset();
    const RunningInRun end = run_in(c, Tier::isothermal);
    INFO(reason_of(end.verdict));
    REQUIRE(end.verdict.good());
    CHECK(end.complementarity < 1e-6);
    // what is left after that time, and the steps' errors of a thousandth each
    CHECK(end.states.back().depth == Approx(in_time.states.back().depth).epsilon(2e-3));
    CHECK(end.states.back().volume == Approx(in_time.states.back().volume).epsilon(2e-3));
  }
}

TEST_CASE("WhereTheStatesOfARunningInEndItGoesOverToOthersAndSaysSo") {
  // A slow loaded bearing has a hot state that rubs and a cool one. Wear carries it along the hot
  // ones until these end; that of the same shape that is found from cold is the cool one.
  const ScratchFolder scratch;
  const Case c = read_case(scratch.write("slow.toml", kSlowCase), {});
  const RunningInRun run = run_in(c, Tier::thd);
  INFO(reason_of(run.verdict));
  REQUIRE(run.verdict.good());
  CHECK(run.states.back().t == 1000.0);
  const auto jump = std::find_if(run.states.begin(), run.states.end(),
                                 [](const RunningInState& s) { return s.anew; });
  REQUIRE(jump != run.states.end());
  const RunningInState& hot = *(jump - 1);
  CHECK(jump->torque < 0.5 * hot.torque);
  CHECK(jump->volume >= hot.volume);  // what has gone stays away
  CHECK(jump->volume - hot.volume < 1e-3 * hot.volume);
  const auto words = words_of_last_state(run);
  CHECK(std::count_if(words.begin(), words.end(), [](const std::string& line) {
          return line.find("no state is found near those before") != std::string::npos;
        }) == 1);
  // The end is a steady state of its profile.
  const std::string csv = scratch.write("worn.csv", worn_shape_csv(c, run));
  const Case worn = read_case(scratch.path("slow.toml"), {{"bearing.shape", '"' + csv + '"', ""}});
  const Solution there = solve_tier(worn, Tier::thd);
  REQUIRE(there.verdict.good());
  // ten digits of the profile; the heat of both is settled within a thousandth
  CHECK(torque_of(there) == Approx(run.states.back().torque).epsilon(2e-3));
}

TEST_CASE("TheShippedWornBearingCarriesItsLoadAlikeOnTwoGrids") {
  Case c = read_case(case_path("ks-rig-worn-in").string(), {});
  REQUIRE(c.model.tier == Tier::tehd);
  c.model.grid = {80, 25};
  const Solution coarse = solve_tier(c, Tier::tehd);
  INFO(reason_of(coarse.verdict));
  REQUIRE(coarse.verdict.good());
  c.model.grid = {160, 25};
  const Solution fine = solve_tier_from(c, Tier::tehd, coarse, {}, Otherwise::failure);
  INFO(reason_of(fine.verdict));
  REQUIRE(fine.verdict.good());
  // the finer grid's bars are a tenth and more: docs/running-in.md has them for 200 x 25 cells
  CHECK(torque_of(coarse) == Approx(torque_of(fine)).epsilon(0.08));
  CHECK(coarse.film.least.h == Approx(fine.film.least.h).epsilon(0.1));
  // worn in: below the 5 MPa at which the paper looks no further
  const Field& p = fine.film.p_contact;
  CHECK(*std::max_element(p.begin(), p.end()) < 5e6);
}
