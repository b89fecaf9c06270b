// Every figure that docs/figures.toml lists stands on its page, and the command that prints it
// exists.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "app/program/cli.hpp"
#include "app/reading/case_text.hpp"
#include "core/contract.hpp"
#include "validation/chart/chart_scenes.hpp"
#include "validation/stress/stress_scenes.hpp"

using namespace shellback;
using namespace shellback::program;
namespace fs = std::filesystem;

namespace {

const fs::path kRoot = SHELLBACK_SOURCE_DIR;

struct Figure {
  std::string page, text, command;
};

std::vector<Figure> listed_figures() {
  const std::string path = (kRoot / "docs" / "figures.toml").string();
  const toml::table file = app::parse_toml(app::read_text_file(path), path);
  std::vector<Figure> figures;
  for (const toml::node& node : *file.get("figure")->as_array()) {
    const toml::table& t = *node.as_table();
    const auto word = [&](const char* key) { return t.get(key)->value<std::string>().value(); };
    figures.push_back({word("page"), word("text"), word("command")});
  }
  return figures;
}

/// Runs of blanks and line ends as one blank each.
std::string flowing(const std::string& text) {
  std::istringstream stream(text);
  std::string out;
  for (std::string word; stream >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

/// The words of a command line; double quotes keep blanks and go.
std::vector<std::string> words_in(const std::string& command) {
  std::vector<std::string> words;
  bool quoted = false;
  bool open = false;
  for (const char c : command) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c != ' ' || quoted) {
      if (!open) words.emplace_back();
      words.back() += c;
    }
    open = quoted || c != ' ';
  }
  return words;
}

std::string files_ending_in(const std::string& name, const std::vector<const char*>& folders) {
  std::string text;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      const std::string file = entry.path().filename().string();
      if (entry.is_regular_file() && file.ends_with(name))
        text += app::read_text_file(entry.path().string());
    }
  }
  return text;
}

/// What is wrong with the words behind `shellback`; empty: nothing.
std::string wrong_with_request(const std::vector<std::string>& words) {
  const Reading reading = read_command_line(words);
  if (reading.code != kDone || !reading.words.empty()) return reading.words + "no request";
  const Request& r = reading.request;
  if (!r.case_file.empty() && !fs::exists(kRoot / r.case_file)) return "no case " + r.case_file;
  for (const std::string& name : r.names) {
    if (!fs::exists(kRoot / "validation" / name / "entry.toml")) return "no entry " + name;
  }
  for (const std::string& scene : r.scenes) {
    const auto charted = validation::chart_scene_names();
    const bool known = std::find(charted.begin(), charted.end(), scene) != charted.end();
    if (r.command == Command::chart && !known) return "no scene " + scene;
  }
  if (r.command == Command::stress) {
    static_cast<void>(
        validation::chosen_stress_scenes(validation::shipped_stress_scenes(false), r.scenes));
  }
  return "";
}

std::string wrong_with_test_run(const std::vector<std::string>& words) {
  const auto chosen = std::find(words.begin(), words.end(), "-R");
  if (chosen == words.end() || chosen + 1 == words.end()) return "a test is named behind -R";
  const std::string name = "TEST_CASE(\"" + *(chosen + 1);
  const bool known = files_ending_in("_test.cpp", {"tests"}).find(name) != std::string::npos;
  return known ? "" : "there is no test " + *(chosen + 1);
}

bool is_executable(const fs::path& file) {
  return fs::is_regular_file(file) &&
         (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

/// Why there is no such command; empty: there is.
std::string wrong_with(std::vector<std::string> words) {
  if (words.size() > 2 && words[0] == "/usr/bin/time")
    words.erase(words.begin(), words.begin() + 2);
  if (words.empty()) return "no words";
  const std::string program = words.front();
  const std::string name = fs::path(program).filename().string();
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (name == "shellback") return wrong_with_request(rest);
  if (name == "ctest") return wrong_with_test_run(rest);
  if (program.starts_with("scripts/")) return is_executable(kRoot / program) ? "" : "no script";
  const std::string built = files_ending_in("CMakeLists.txt", {"validation", "app/program"});
  const bool known = built.find("add_executable(" + name + " ") != std::string::npos;
  return known ? "" : "nothing of this name is built";
}

}  // namespace

TEST_CASE("EveryListedFigureStandsOnItsPage") {
  const auto figures = listed_figures();
  CHECK(figures.size() > 20);
  for (const Figure& figure : figures) {
    INFO(figure.page << ": " << figure.text);
    const std::string page = flowing(app::read_text_file((kRoot / figure.page).string()));
    CHECK(page.find(flowing(figure.text)) != std::string::npos);
    CHECK(figure.text.find_first_of("0123456789") != std::string::npos);
  }
}

TEST_CASE("EveryCommandBehindAFigureExists") {
  for (const Figure& figure : listed_figures()) {
    INFO(figure.command);
    CHECK(wrong_with(words_in(figure.command)) == "");
  }
}

TEST_CASE("CommandsThatAreNoneAreSeen") {
  for (const char* wrong :
       {"shellback honestly", "shellback honesty --case 3", "shellback run cases/no-such.toml",
        "shellback stress no-such-scene", "shellback validate no-such-entry",
        "shellback chart no-such-scene", "scripts/no-such", "build/release/no_such_program",
        "ctest --preset release -R NoSuchLaw", ""}) {
    INFO(wrong);
    std::string why;
    try {
      why = wrong_with(words_in(wrong));
    } catch (const InputError& error) {
      why = error.what();
    }
    CHECK_FALSE(why.empty());
  }
}

TEST_CASE("TheScriptListsEveryFigureWithItsCommand") {
  const std::string command = (kRoot / "scripts" / "figures").string();
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string said;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) said += buffer.data();
  CHECK(pclose(pipe) == 0);
  for (const Figure& figure : listed_figures()) {
    INFO(figure.text);
    CHECK(said.find(figure.page + ": " + figure.text + "\n    " + figure.command + "\n") !=
          std::string::npos);
  }
}
