#include "app/run_state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

#include "app/case_json.hpp"
#include "app/hdf5_parts.hpp"
#include "app/provenance.hpp"
#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace hdf5;
using Sorted = nlohmann::json;

constexpr const char* kFormat = "shellback state";
constexpr int kVersion = 41;  ///< of the order in which values stand on the tape

/// The bits of numbers, as text.
std::string bits_of(const std::vector<double>& x) {
  return fnv1a_64({reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)});
}

Sorted running_in_json(const bearing::RunningIn& r) {
  Sorted json{{"wear_coefficient", r.wear_coefficient},
              {"hardness", r.hardness},
              {"until", r.duration ? Sorted(*r.duration) : Sorted("worn_in")},
              {"limit_pressure", r.limit_pressure},
              {"worn_after", r.worn_after}};
  if (r.worn) {
    json["worn"] = {r.worn->roughness, r.worn->orientation, r.worn->summit_roughness,
                    r.worn->summit_height};
  }
  return json;
}

const char* run_name(RunOf run) {
  switch (run) {
    case RunOf::running_in:
      return "a running-in (run --running-in)";
    case RunOf::warm_up:
      return "a warm-up (run --transient)";
    case RunOf::course:
      return "a course (run --transient --speeds)";
    case RunOf::comparison:
      return "a comparison of tiers (compare)";
    case RunOf::load_cycle:
      break;
  }
  return "a load cycle (run)";
}

/// All on which the numbers of a run depend.
Sorted identity(const bearing::Case& c, RunOf run, const RunOptions& options) {
  const Provenance p = provenance(c);
  Sorted program{{"version", p.version}, {"git", p.git}, {"state", kVersion}};
  for (const auto& [name, version] : p.libraries) program[name] = version;
  Sorted subject = case_json(c);
  const auto add_table = [&](const char* key, const std::optional<bearing::Profile>& t) {
    if (t) subject["bearing"][key] = {bits_of(t->phi), bits_of(t->z), bits_of(t->height)};
  };
  add_table("profile", c.bearing.profile);
  add_table("shape", c.bearing.shape);
  add_table("wear", c.bearing.wear);
  subject["model"]["grid_given"] = c.model.grid_given;
  subject["equivalent_temperature"] = bearing::equivalent_temperature(c);  // by what was measured
  if (c.cycle) subject["load_cycle"]["crank_speed"] = c.cycle->crank_speed;
  if (run == RunOf::running_in) subject["running_in"] = running_in_json(*c.running_in);
  for (const auto& [option, values] : options) subject[option] = bits_of(values);
  return {{"program", program}, {"run", run_name(run)}, {"case", subject}};
}

/// Keys by which two of them differ, "load_cycle.load_x", each once.
std::vector<std::string> different(const Sorted& kept, const Sorted& now) {
  constexpr std::size_t kMost = 5;   // that are told
  constexpr std::size_t kDepth = 2;  // of keys: below are values, units and rows
  std::vector<std::string> keys;
  std::set<std::string> known;
  for (const Sorted& change : Sorted::diff(kept, now)) {
    const std::string path = change["path"].get<std::string>().substr(1);
    std::string key;
    std::size_t depth = 0;
    for (const char letter : path) {
      if (letter == '/' && ++depth > kDepth) break;
      key += letter == '/' ? '.' : letter;
    }
    if (known.insert(key).second && keys.size() < kMost)
      keys.push_back(key.substr(key.find('.') + 1));
  }
  return keys;
}

template <class List>
List read_list(hid_t file, const char* name, hid_t type) {
  const Handle id(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose, name);
  const Handle space(H5Dget_space(id), H5Sclose, name);
  const hssize_t size = H5Sget_simple_extent_npoints(space);
  check(size < 0 ? -1 : 0, name);
  List list;
  list.resize(static_cast<std::size_t>(size));
  if (size > 0) check(H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, list.data()), name);
  return list;
}

struct Read {
  std::string identity;
  Tape::Content kept;
  std::string sum;
};

Read read_file(const std::string& path) {
  const QuietErrors quiet;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
  Read r;
  r.identity = read_list<std::string>(file, "identity", H5T_NATIVE_CHAR);
  r.sum = text_attribute(file, "sum");
  r.kept.numbers = read_list<std::vector<double>>(file, "numbers", H5T_NATIVE_DOUBLE);
  r.kept.counts = read_list<std::vector<std::int64_t>>(file, "counts", H5T_NATIVE_INT64);
  r.kept.text = read_list<std::string>(file, "text", H5T_NATIVE_CHAR);
  return r;
}

std::string sum_of(const std::string& identity, const Tape::Content& kept) {
  const auto bytes = reinterpret_cast<const char*>(kept.counts.data());
  return bits_of(kept.numbers) + fnv1a_64({bytes, kept.counts.size() * sizeof(std::int64_t)}) +
         fnv1a_64(kept.text) + fnv1a_64(identity);
}

}  // namespace

std::string run_state(const bearing::Case& c, RunOf run, const Tape::Content& kept,
                      const RunOptions& options) {
  return file_bytes([&](hid_t file) {
    attribute(file, "format", std::string(kFormat));
    attribute(file, "title", c.title);
    const std::string who = identity(c, run, options).dump();
    attribute(file, "sum", sum_of(who, kept));
    dataset(file, "identity", H5T_NATIVE_CHAR, who.data(), {who.size()},
            {"-", "case and program, JSON", "", ""});
    doubles(file, "numbers", kept.numbers, "-",
            "numbers of the state, in the order of the program");
    dataset(file, "counts", H5T_NATIVE_INT64, kept.counts.data(), {kept.counts.size()},
            {"-", "whole numbers and lengths of lists", "", ""});
    dataset(file, "text", H5T_NATIVE_CHAR, kept.text.data(), {kept.text.size()},
            {"-", "texts of the state", "", ""});
  });
}

Tape::Content read_run_state(const std::string& path, const bearing::Case& c, RunOf run,
                             const RunOptions& options) {
  if (const std::string format = format_of(path); !format.empty() && format != kFormat) {
    throw FileError(
        fmt::format("{} is no state of a run but a {}; give the file that the "
                    "interrupted run named",
                    path, format));
  }
  const auto damaged = [&](const std::string& why) {
    return FileError(
        fmt::format("{} cannot be gone on with: it is damaged or no state of a run "
                    "({}); take the file away and leave out --resume to begin anew",
                    path, why));
  };
  Read r;
  try {
    r = read_file(path);
  } catch (const FileError&) {
    throw damaged("it is cut short, or no HDF5 file");
  }
  const Sorted kept = Sorted::parse(r.identity, nullptr, false);
  if (!kept.is_object() || r.sum != sum_of(r.identity, r.kept))
    throw damaged("its check sum is wrong");
  const Sorted now = identity(c, run, options);
  if (kept.value("program", Sorted()) != now["program"]) {
    throw InputError("--resume",
                     fmt::format("{} was written by another version of shellback, whose numbers "
                                 "may differ; go on with that one, or leave out --resume to begin "
                                 "anew",
                                 path));
  }
  if (kept.value("run", Sorted()) != now["run"]) {
    throw InputError("--resume",
                     fmt::format("{} is the state of {}, and this is {}; give the options of that "
                                 "run, or leave out --resume to begin this one anew (which "
                                 "replaces the state)",
                                 path, kept.value("run", "another run"), run_name(run)));
  }
  if (kept.value("case", Sorted()) != now["case"]) {
    throw InputError(
        "--resume",
        fmt::format("{} is the state of another case: {} differ; go on with the case as it was, or "
                    "leave out --resume to begin this one anew (which replaces the state)",
                    path, fmt::join(different(kept, now), ", ")));
  }
  return std::move(r.kept);
}

}  // namespace shellback::app
