#pragma once
/// A study of many cases: a folder that holds the plan and what has come of every point of it.
///
///   study.json        cases and the files that they take in, changes of all of them, points (what
///                     each of them changes more)
///   points/0001.json  result of `run` at point 1, as `run --json` writes it
///   points/0001.txt   its messages
///   points/0001.code  the exit code with which it ended; none: it is open
///
/// A point is a run of the program of its own: one that is killed takes no other with it, and any
/// number of programs, on one machine or many, may work on parts of one folder. What has ended
/// stays; take its `.code` away, and it is run again.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/program/request.hpp"

namespace shellback::program {

/// What a point changes in its case, key and value.
struct PlannedPoint {
  int of_case = 0;
  std::vector<std::pair<std::string, std::string>> varied;
  /// "ks-rig.toml operation.speed=1500 rpm".
  [[nodiscard]] std::string words(const std::vector<std::string>& cases) const;
};

struct ManyCases {
  std::string folder;
  std::vector<std::string> cases;  ///< absolute paths
  std::map<std::string, std::string>
      files;                     ///< these and what they take in, FNV-1a 64 of each text
  std::vector<std::string> set;  ///< --set of all points
  std::string tier;              ///< --tier of all points; empty: the case's
  std::vector<PlannedPoint> points;

  /// Path of a file of point k, counted from 0; `ending`: "json", "txt" or "code".
  [[nodiscard]] std::string file(std::size_t k, const std::string& ending) const;
};

/// Every case that is named at every combination of the values of --vary
/// (app/reading/read_axis.hpp), each of which must be a case that can be read. Throws InputError,
/// FileError.
[[nodiscard]] ManyCases plan_cases(const Request& request);

/// Makes the folder with study.json and an empty folder of points. Throws InputError where there is
/// a study already (unless by force, which takes its points away) or something else.
void write_plan(const ManyCases& study, bool force);

/// Throws FileError where there is no study, InputError where it cannot be understood.
[[nodiscard]] ManyCases read_plan(const std::string& folder);

/// Throws InputError if a case, or a file that it takes in, is no longer what was planned.
void expect_cases_as_planned(const ManyCases& study);

/// What has come of a point.
enum class PointEnd { open, converged, not_converged, refused, failed };
[[nodiscard]] PointEnd end_of_point(const ManyCases& study, std::size_t k);
[[nodiscard]] const char* to_string(PointEnd end);

}  // namespace shellback::program
