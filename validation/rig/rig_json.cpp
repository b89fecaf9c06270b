#include <cmath>

#include "app/json_parts.hpp"
#include "validation/rig/rig_bands.hpp"
#include "validation/rig/rig_page.hpp"
#include "validation/rig/rig_statements.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;

template <class T>
void add_unknown(Json& json, const T& item) {
  if (item.unknown == nullptr) return;
  json["unknown"] = item.unknown->name;
  json["end"] = item.end == 0 ? "low" : "high";
}

Json course_json(const RigCourse& c, int k) {
  Json json;
  json["peak_load"] = with_unit(c.peak, "N");
  add_unknown(json, c);
  json["bearing"] = to_string(kRigBearings[k]);
  add_status(json, c.tried[k] ? c.run[k].end.verdict
                              : Verdict{Status::interrupted, ending::Plain::not_run});
  json["energy_imbalance"] = number(c.run[k].imbalance_at_ends());
  json["steps"] = Json::array();
  for (std::size_t n = 0; n < c.run[k].ends.size(); ++n) {
    const bearing::Instant& i = c.run[k].instants[c.run[k].ends[n]];
    json["steps"].push_back({{"speed_rpm", c.rpm[n]},
                             {"t", with_unit(i.t, "s")},
                             {"friction_torque", with_unit(i.torque, "N m")},
                             {"h_min", with_unit(i.h_min, "m")},
                             {"T_shell_back", with_unit(i.T_shell_back, "K")},
                             {"T_shell_max", with_unit(i.T_shell_max, "K")},
                             {"T_shaft", with_unit(i.T_shaft, "K")}});
  }
  return json;
}

Json cycle_json(const RigCycle& c, RigBearing bearing) {
  Json json;
  json["bearing"] = to_string(bearing);
  add_status(json, c.verdict);
  json["T"] = with_unit(c.T, "K");
  if (!c.verdict.good()) return json;
  json["friction_torque"] = with_unit(c.torque, "N m");
  json["friction_torque_asperity"] = with_unit(c.asperity, "N m");
  json["p_max"] = with_unit(c.p_max, "Pa");
  json["h_min"] = with_unit(c.h_min, "m");
  json["shear_rate_mid_width"] = with_unit(c.shear, "1/s");
  return json;
}

Json point_json(const RigPoint& p) {
  Json json;
  json["peak_load"] = with_unit(p.peak, "N");
  json["speed_rpm"] = p.rpm;
  json["oil"] = to_string(p.oil);
  json["warmer"] = with_unit(p.warmer, "K");
  add_unknown(json, p);
  json["torque"] = with_unit(p.torque(), "N m");
  json["bearings"] = {cycle_json(p.cycle[0], RigBearing::test),
                      cycle_json(p.cycle[1], RigBearing::support)};
  return json;
}

Json start_json(const RigStart& s) {
  Json json;
  json["surface"] = s.worn ? "worn" : "new";
  json["T"] = with_unit(s.T, "K");
  for (int k = 0; k < 2; ++k) {
    Json one;
    one["bearing"] = to_string(kRigBearings[k]);
    add_status(one, s.verdict[k]);
    json["bearings"].push_back(one);
  }
  json["breakaway_torque"] = with_unit(s.series.empty() ? NAN : s.breakaway, "N m");
  json["boundary_torque"] = with_unit(s.boundary, "N m");
  json["full_film"] = with_unit(s.full_film, "s");
  Json t = Json::array();
  Json torque = Json::array();
  for (const RigInstant& i : s.series) {
    t.push_back(i.t);
    torque.push_back(i.torque);
  }
  json["time"] = {{"unit", "s"}, {"values", t}};
  json["torque"] = {{"unit", "N m"}, {"values", torque}};
  return json;
}

}  // namespace

std::string rig_json(const RigStudy& study) {
  Json json;
  json["study"] = "ks-rig";
  json["status"] = study.interrupted          ? "interrupted"
                   : study.count_failed() > 0 ? "points not found"
                                              : "converged";
  json["load"] = "substitute: the published trace is not available";
  json["grid"] = study.plan.grid;
  json["statements"] = Json::array();
  for (const RigStatement& s : rig_statements(study)) {
    json["statements"].push_back({{"section", s.section},
                                  {"statement", s.words},
                                  {"asked", s.range},
                                  {"ours", s.ours},
                                  {"verdict", to_string(s.met)}});
  }
  json["not_found"] = rig_failures(study);
  json["effects"] = Json::array();
  for (const RigEffect& e : rig_effects(study)) {
    Json one;
    add_unknown(one, e);
    one["range"] = e.unknown->range;
    one["smallest_change"] = number(e.low);
    one["largest_change"] = number(e.high);
    one["missing"] = e.missing;
    json["effects"].push_back(one);
  }
  json["courses"] = Json::array();
  for (const RigCourse& c : study.courses) {
    for (int k = 0; k < 2; ++k) json["courses"].push_back(course_json(c, k));
  }
  json["points"] = Json::array();
  for (const RigPoint& p : study.points) json["points"].push_back(point_json(p));
  json["starts"] = Json::array();
  for (const RigStart& s : study.starts) json["starts"].push_back(start_json(s));
  json["threads"] = study.threads;
  json["wall_s"] = study.wall_s;
  json["provenance"] =
      provenance_json(rig_case(RigBearing::test, {80e3, 1000.0, study.plan.grid, nullptr, 0}));
  return dump(json);
}

}  // namespace shellback::validation
