/// Load cycles that are killed or interrupted and gone on with.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "app/program/cli.hpp"
#include "app/program/run_keeper.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "app/run_state.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/process.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kKilled = 1000 + SIGKILL;

/// Lets it run for so long [s], until it has ended, or until `enough`.
void let_run(
    const Process& process, double seconds,
    const std::function<bool()>& enough = [] { return false; }) {
  const auto till = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < till && !process.ended() && !enough()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

/// The shipped case with long steps on a coarse grid, and its files.
struct Run {
  explicit Run(const ScratchFolder& scratch, const std::string& name)
      : json(scratch.path(name + ".json")),
        state(json + ".state"),
        out(scratch.path(name + ".out")),
        err(scratch.path(name + ".err")) {}
  [[nodiscard]] Process start(const Words& more = {}) const {
    Words words{"run", case_path("rotating-load").string(), "--set", "model.grid=[60,9]", "--json",
                json};
    words.insert(words.end(), more.begin(), more.end());
    return {words, out, err};
  }
  std::string json, state, out, err;
};

/// A result without what the clock says.
nlohmann::json result(const std::string& path) {
  nlohmann::json json = nlohmann::json::parse(text_of(path));
  json.erase("cost");
  json.erase("provenance");
  return json;
}

}  // namespace

TEST_CASE("ACycleThatIsKilledAgainAndAgainEndsAsOneThatIsNot") {
  const ScratchFolder scratch;
  const Run whole(scratch, "whole");
  const auto begin = Clock::now();
  REQUIRE(whole.start().wait() == kDone);
  const double took = std::chrono::duration<double>(Clock::now() - begin).count();
  CHECK_FALSE(fs::exists(whole.state));

  const Run killed(scratch, "killed");
  std::mt19937 random(12);
  std::uniform_real_distribution<double> part(0.05, 0.3);  // of the whole
  int kills = 0;
  int code = kKilled;
  for (int k = 0; k < 40 && code == kKilled; ++k) {
    const Process process = killed.start({"--resume"});
    let_run(process, k < 30 ? part(random) * took : 10.0 * took);
    ::kill(process.pid(), SIGKILL);
    code = process.wait();
    kills += code == kKilled ? 1 : 0;
  }
  INFO(text_of(killed.err));
  REQUIRE(code == kDone);
  CHECK(kills >= 1);  // about six, where the machine is as fast all the time
  CHECK(text_of(killed.err).find("goes on from") != std::string::npos);
  CHECK_FALSE(fs::exists(killed.state));
  CHECK(result(killed.json) == result(whole.json));  // every number, to the last digit
}

TEST_CASE("ARunningInThatIsKilledAgainAndAgainEndsAsOneThatIsNot") {
  const ScratchFolder scratch;
  const auto words = [&](const std::string& json) {
    return Words{"run",          case_path("running-in").string(),
                 "--running-in", "--resume",
                 "--set",        "model.grid=[120,17]",
                 "--set",        "running_in.until=900 s",
                 "--json",       json};
  };
  const std::string err = scratch.path("err");
  const std::string whole = scratch.path("whole.json");
  REQUIRE(Process(words(whole), scratch.path("out"), err).wait() == kDone);
  const std::string killed = scratch.path("killed.json");
  const std::string state = killed + ".state";
  const auto kept = [&] { return fs::exists(state) ? text_of(state) : std::string(); };
  int kills = 0;
  // A loaded machine may wake the test when the run has ended; such a run says nothing.
  for (int runs = 0; runs < 100 && kills == 0; ++runs) {
    fs::remove(killed);
    int code = kKilled;
    std::string last;               // state at the last kill
    constexpr int kMostKills = 20;  // then it is let go on: a busy machine may grant a shape a run
    for (int k = 0; k <= kMostKills && code == kKilled; ++k) {
      const Process process(words(killed), scratch.path("out"), err);
      if (k < kMostKills) {
        let_run(process, 60.0, [&] { return kept() != last && !kept().empty(); });
        ::kill(process.pid(), SIGKILL);
      }
      code = process.wait();
      kills += code == kKilled ? 1 : 0;
      last = kept();
    }
    INFO(text_of(err));
    REQUIRE(code == kDone);
    REQUIRE_FALSE(fs::exists(state));
  }
  REQUIRE(kills >= 1);
  CHECK(result(killed) == result(whole));
}

TEST_CASE("AStateIsOfOneCaseAndWholeOrRefused") {
  const ScratchFolder scratch;
  const Run run(scratch, "a");
  for (int k = 0; k < 100 && !fs::exists(run.state); ++k) {
    const Process process = run.start();
    let_run(process, 20.0, [&] { return fs::exists(run.state); });
    ::kill(process.pid(), SIGINT);
    const int code = process.wait();
    if (code == kDone) continue;
    CHECK(code == kInterrupted);
    check_parts(text_of(run.err), {run.state, "--resume"});
  }
  REQUIRE(fs::exists(run.state));

  CHECK(run.start({"--resume", "--set", "operation.speed=2900 rpm"}).wait() == kBadInput);
  check_parts(text_of(run.err), {"--resume", "another case", "operation.speed"});
  CHECK(run.start({"--resume", "--set", "model.grid=[52,8]"}).wait() == kBadInput);

  const std::string bytes = text_of(run.state);
  scratch.write("a.json.state", bytes.substr(0, bytes.size() / 2));
  CHECK(run.start({"--resume"}).wait() == kBadFile);
  check_parts(text_of(run.err), {run.state, "damaged", "leave out --resume"});

  std::string other = bytes;
  other[other.size() / 2] = static_cast<char>(other[other.size() / 2] ^ 0x10);
  scratch.write("a.json.state", other);
  CHECK(run.start({"--resume"}).wait() != kDone);  // not a bit of it may differ

  scratch.write("a.json.state", bytes);
  REQUIRE(run.start({"--resume"}).wait() == kDone);
  check_parts(text_of(run.err), {"goes on from", run.state});
  CHECK_FALSE(fs::exists(run.state));
}

TEST_CASE("AWarmUpThatIsInterruptedEndsAsOneThatIsNot") {
  const ScratchFolder scratch;
  const std::string err = scratch.path("err");
  const auto start = [&](const std::string& json, const Words& more) {
    Words words{"run",        case_path("thd-plain-bearing").string(),
                "--set",      "model.grid=[60,9]",
                "--json",     json,
                "--transient"};
    words.insert(words.end(), more.begin(), more.end());
    return Process(words, scratch.path("out"), err);
  };
  const Words till{"--until", "2000 s"};
  const std::string whole = scratch.path("whole.json");
  REQUIRE(start(whole, till).wait() == kDone);
  const std::string cut = scratch.path("cut.json");
  const std::string state = cut + ".state";
  for (int k = 0; k < 100 && !fs::exists(state); ++k) {
    const Process process = start(cut, till);
    let_run(process, 20.0, [&] { return fs::exists(state); });
    ::kill(process.pid(), SIGINT);
    const int code = process.wait();
    if (code != kDone) CHECK(code == kInterrupted);
  }
  REQUIRE(fs::exists(state));
  check_parts(text_of(err), {state, "--resume"});

  CHECK(start(cut, {"--resume", "--until", "1000 s"}).wait() == kBadInput);
  check_parts(text_of(err), {"another case", "--until"});
  CHECK(start(cut, {"--resume", "--speeds", "2000 rpm", "--hold", "2000 s"}).wait() == kBadInput);
  check_parts(text_of(err), {"state of a warm-up", "this is a course"});
  CHECK(start(cut, {"--resume", "--until", "2000 s"}).wait() == kDone);
  check_parts(text_of(err), {"goes on from", state});
  CHECK_FALSE(fs::exists(state));
  nlohmann::json a = result(cut);
  nlohmann::json b = result(whole);
  CHECK(a == b);
}

TEST_CASE("AStateOfACourseIsOfItsSpeeds") {
  const ScratchFolder scratch;
  const bearing::Case c = read_case(case_path("thd-plain-bearing").string(), {});
  const auto speeds = [](double second) {
    return RunOptions{{"--speeds", {100.0, second}}, {"--hold", {60.0}}};
  };
  const std::string path =
      scratch.write("s", run_state(c, RunOf::course, {{1.0}, {2}, "x"}, speeds(200.0)));
  CHECK(read_run_state(path, c, RunOf::course, speeds(200.0)).text == "x");
  CHECK_THROWS_WITH(read_run_state(path, c, RunOf::course, speeds(201.0)),
                    Catch::Contains("--speeds differ"));
  CHECK_THROWS_WITH(read_run_state(path, c, RunOf::warm_up), Catch::Contains("state of a course"));
}

TEST_CASE("AStateIsOfOneKindOfRun") {
  const ScratchFolder scratch;
  bearing::Case c = read_case(case_path("running-in-cycle").string(), {});
  const std::string path = scratch.write("s", run_state(c, RunOf::load_cycle, {{1.0}, {2}, "x"}));
  CHECK(read_run_state(path, c, RunOf::load_cycle).text == "x");
  CHECK_THROWS_WITH(read_run_state(path, c, RunOf::running_in),
                    Catch::Contains("state of a load cycle") && Catch::Contains("running-in"));
  scratch.write("s", run_state(c, RunOf::running_in, {{1.0}, {2}, "x"}));
  CHECK(read_run_state(path, c, RunOf::running_in).text == "x");
  c.running_in->wear_coefficient *= 2.0;
  CHECK_THROWS_WITH(read_run_state(path, c, RunOf::running_in),
                    Catch::Contains("running_in.wear_coefficient"));
}

TEST_CASE("AStateOfAnotherRunStaysUntilThisOneHasItsOwn") {
  const ScratchFolder scratch;
  const bearing::Case c = read_case(case_path("running-in").string(), {});
  Request request;
  request.json = scratch.path("a.json");
  const std::string bytes = run_state(c, RunOf::running_in, {{1.0}, {2}, "x"});
  const std::string path = scratch.write("a.json.state", bytes);
  RunKeeper keeper(request, c, RunOf::running_in);
  for (const int code : {kDone, kNotConverged, kInterrupted, kBadFile}) {
    keeper.end(code);
    CHECK(text_of(path) == bytes);
  }
  keeper.kept()->keep([](Tape& tape) {
    double x = 3.0;
    tape(x);
  });
  CHECK(text_of(path) != bytes);
  keeper.end(kInterrupted);
  CHECK(fs::exists(path));
  keeper.end(kDone);
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("ASearchThatFollowsIsKeptBesideWhatItFollows") {
  const ScratchFolder scratch;
  const bearing::Case c = read_case(case_path("running-in-cycle").string(), {});
  Request request;
  request.json = scratch.path("a.json");
  request.resume = true;
  double x = 0.0;
  const auto members = [&](Tape& tape) { tape(x); };
  const auto number_in = [&](bearing::KeptRun* kept) {
    x = 0.0;
    return bearing::take_up_noted(kept, members) ? x : 0.0;
  };
  {
    RunKeeper keeper(request, c, RunOf::warm_up);
    x = 3.0;
    keeper.kept()->keep(members);
    x = 4.0;
    keeper.kept()->note(members);  // too soon for the file
    bearing::KeptRun* next = keeper.next();
    CHECK(number_in(next) == 0.0);
    x = 5.0;
    next->keep(members);
  }
  RunKeeper keeper(request, c, RunOf::warm_up);
  CHECK(number_in(keeper.kept()) == 4.0);
  CHECK(number_in(keeper.next()) == 5.0);
}

namespace {

/// What a command over load cycles that is interrupted again and again writes in the end, and how
/// often it was. `whole`: what it takes without [s].
int go_on_until_done(const Words& words, const ScratchFolder& scratch, double whole) {
  int interrupted = 0;
  double seconds = 0.1 * whole;
  for (Words next = words; interrupted < 20; ++interrupted, seconds *= 1.5) {
    Process process(next, scratch.path("out"), scratch.path("err"));
    let_run(process, seconds);
    kill(process.pid(), SIGINT);
    const int code = process.wait();
    if (code == kDone) return interrupted;
    const bool not_begun = code == 1000 + SIGINT;  // stopped before it minds signals
    REQUIRE((code == kInterrupted || not_begun));
    if (next.size() == words.size()) next.push_back("--resume");
  }
  return interrupted;
}

/// Files in the folder whose names hold ".state".
int count_states(const ScratchFolder& scratch) {
  int n = 0;
  for (const auto& entry : fs::directory_iterator(scratch.path(""))) {
    if (entry.path().filename().string().find(".state") != std::string::npos) ++n;
  }
  return n;
}

}  // namespace

TEST_CASE("ASweepOverCyclesAndAComparisonGoOnWhereTheyWere") {
  const ScratchFolder scratch;
  const std::string subject = case_path("rotating-load").string();
  const auto numbers = [&](const std::string& name) {
    return nlohmann::json::parse(text_of(scratch.path(name)));
  };
  const auto points = [&](const std::string& name) {
    nlohmann::json json = numbers(name)["points"];
    for (nlohmann::json& p : json) {
      for (const char* clock : {"wall_s", "cost"}) p.erase(clock);
    }
    return json;
  };
  const Words sweep{
      "sweep", subject, "--set", "model.grid=[24,5]", "--vary", "load_cycle.factor=0.5,0.8",
      "-j",    "2",     "--json"};
  const auto writing = [&](Words words, const std::string& name) {
    words.push_back(scratch.path(name));
    return words;
  };
  const auto took = [&](const Words& words) {
    const auto begin = Clock::now();
    REQUIRE(Process(words, scratch.path("out"), scratch.path("err")).wait() == kDone);
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  const double whole = took(writing(sweep, "whole.json"));
  CHECK(go_on_until_done(writing(sweep, "pieces.json"), scratch, whole) > 0);
  CHECK(points("pieces.json") == points("whole.json"));
  CHECK(count_states(scratch) == 0);

  const Words compare{"compare",           subject, "--set", "model.grid=[24,5]", "--tiers",
                      "isothermal,lumped", "--json"};
  const double both = took(writing(compare, "both.json"));
  CHECK(go_on_until_done(writing(compare, "parts.json"), scratch, both) > 0);
  const auto compared = [&](const std::string& name) {
    nlohmann::json json = numbers(name);
    for (nlohmann::json& r : json["results"]) r.erase("cost");
    return std::pair{json["results"], json["friction_split"]};
  };
  CHECK(compared("parts.json") == compared("both.json"));
  CHECK(count_states(scratch) == 0);
}

TEST_CASE("ARunWithoutAStateSaysSo") {
  const ScratchFolder scratch;
  const std::string steady = scratch.write("case.toml", kSampleCase);
  const auto refused = [&](const Words& words) {
    const Ended ended = run_words(words);
    CHECK(ended.code == kBadInput);
    return ended.err;
  };
  check_parts(refused({"run", steady, "--resume"}), {"--resume", "load cycle"});
  check_parts(refused({"run", steady, "--state", scratch.path("s")}), {"--state", "load cycle"});
  check_parts(refused({"run", case_path("pulse").string(), "--resume"}), {"--resume", "--state"});
  check_parts(refused({"compare", steady, "--resume"}), {"--resume", "load cycle"});
  check_parts(
      refused({"sweep", steady, "--vary", "operation.speed=900 rpm", "--state", scratch.path("s")}),
      {"--state", "load cycle"});
}
