#include "app/program/many_cases.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "app/json_parts.hpp"
#include "app/pending_file.hpp"
#include "app/program/session.hpp"
#include "app/provenance.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/overrides.hpp"
#include "app/reading/read_axis.hpp"
#include "app/reading/read_case.hpp"
#include "app/result_mark.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;
using json_parts::Json;
namespace fs = std::filesystem;

namespace {

constexpr const char* kPlan = "study.json";
constexpr const char* kPoints = "points";

/// All combinations of the axes' values, the first axis changing slowest.
std::vector<PlannedPoint> combinations(int of_case, const std::vector<study::Axis>& axes) {
  std::vector<PlannedPoint> all{{of_case, {}}};
  for (const study::Axis& axis : axes) {
    std::vector<PlannedPoint> longer;
    for (const PlannedPoint& begun : all) {
      for (const std::string& value : axis.words) {
        longer.push_back(begun);
        longer.back().varied.emplace_back(axis.key, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

[[noreturn]] void not_understood(const std::string& path, const char* why) {
  throw InputError(path, fmt::format("this is no plan of a study ({}); plan it again", why));
}

}  // namespace

std::string PlannedPoint::words(const std::vector<std::string>& cases) const {
  std::string all = fs::path(cases[of_case]).filename().string();
  for (const auto& [key, value] : varied) all += " " + key + "=" + value;
  return all;
}

std::string ManyCases::file(std::size_t k, const std::string& ending) const {
  return (fs::path(folder) / kPoints / fmt::format("{:04d}.{}", k + 1, ending)).string();
}

ManyCases plan_cases(const Request& request) {
  ManyCases study;
  study.folder = request.output;
  study.set = request.set;
  study.tier = request.tier;
  const std::vector<Override> of_all = overrides_of(request);
  std::vector<study::Axis> axes;
  if (!request.vary.empty()) axes = parse_axes(request.vary, of_all);
  for (const std::string& path : request.names) {
    const std::string text = read_text_file(path);
    study.cases.push_back(fs::absolute(path).lexically_normal().string());
    const int number = static_cast<int>(study.cases.size()) - 1;
    for (PlannedPoint& point : combinations(number, axes)) {
      std::vector<Override> changes = of_all;
      for (const auto& [key, value] : point.varied)
        changes.push_back({key, value, "--vary " + key});
      for (const std::string& file : files_of_case(text, study.cases.back(), changes)) {
        study.files.emplace(file, fnv1a_64(read_text_file(file)));
      }
      study.points.push_back(std::move(point));
    }
  }
  return study;
}

void write_plan(const ManyCases& study, bool force) {
  const fs::path folder(study.folder);
  if (fs::exists(folder) && !fs::is_directory(folder)) {
    throw InputError("-o", study.folder + " is a file; give a folder");
  }
  const bool planned = fs::exists(folder / kPlan);
  if (planned && !force) {
    throw InputError("-o", study.folder +
                               " holds a study already; give another folder, or --force "
                               "to take its points away");
  }
  if (!planned && fs::exists(folder / kPoints)) {
    throw InputError("-o", (folder / kPoints).string() +
                               " is there and no study's; give another "
                               "folder");
  }
  std::error_code refused;
  if (planned) fs::remove_all(folder / kPoints, refused);
  fs::create_directories(folder / kPoints, refused);
  if (refused) {
    throw FileError(study.folder + ": the folder cannot be made (" + refused.message() + ")");
  }
  Json plan{{"set", study.set},
            {"tier", study.tier},
            {"cases", study.cases},
            {"files", study.files},
            {"points", Json::array()}};
  for (const PlannedPoint& p : study.points) {
    Json varied = Json::object();
    for (const auto& [key, value] : p.varied) varied[key] = value;
    plan["points"].push_back({{"case", p.of_case}, {"varied", varied}});
  }
  write_file((folder / kPlan).string(), marked(Format::json, json_parts::dump(plan)));
}

ManyCases read_plan(const std::string& folder) {
  const std::string path = (fs::path(folder) / kPlan).string();
  std::ifstream file(path);
  if (!file) {
    throw FileError(path +
                    ": there is no such file; plan a study with `shellback study plan CASE "
                    "--vary KEY=VALUES -o " +
                    folder + "`");
  }
  ManyCases study;
  study.folder = folder;
  try {
    const Json plan = Json::parse(file);
    study.set = plan.at("set").get<std::vector<std::string>>();
    study.tier = plan.at("tier").get<std::string>();
    study.cases = plan.at("cases").get<std::vector<std::string>>();
    study.files = plan.at("files").get<std::map<std::string, std::string>>();
    for (const Json& p : plan.at("points")) {
      PlannedPoint point{p.at("case").get<int>(), {}};
      for (const auto& [key, value] : p.at("varied").items()) {
        point.varied.emplace_back(key, value.get<std::string>());
      }
      if (point.of_case < 0 || point.of_case >= static_cast<int>(study.cases.size())) {
        not_understood(path, "a point of no case");
      }
      study.points.push_back(std::move(point));
    }
  } catch (const Json::exception& error) {
    not_understood(path, error.what());
  }
  return study;
}

void expect_cases_as_planned(const ManyCases& study) {
  for (const auto& [path, fingerprint] : study.files) {
    if (fnv1a_64(read_text_file(path)) == fingerprint) continue;
    throw InputError(path,
                     "the file has changed since the study was planned; plan it again "
                     "(study plan ... -o FOLDER --force)");
  }
}

PointEnd end_of_point(const ManyCases& study, std::size_t k) {
  std::ifstream file(study.file(k, "code"));
  int code = 0;
  if (!(file >> code)) return PointEnd::open;
  if (code == kDone) {  // a result that has been lost since is none
    return fs::exists(study.file(k, "json")) ? PointEnd::converged : PointEnd::open;
  }
  if (code == kNotConverged) return PointEnd::not_converged;
  return code == kBadInput ? PointEnd::refused : PointEnd::failed;
}

const char* to_string(PointEnd end) {
  switch (end) {
    case PointEnd::converged:
      return "converged";
    case PointEnd::not_converged:
      return "not converged";
    case PointEnd::refused:
      return "refused";
    case PointEnd::failed:
      return "failed";
    case PointEnd::open:
      break;
  }
  return "open";
}

}  // namespace shellback::program
