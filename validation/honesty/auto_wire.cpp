#include "validation/honesty/auto_wire.hpp"

#include "app/json_parts.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;

Json answer_json(const AutoAnswer& a) {
  return {{"tolerance", a.tolerance},
          {"converged", a.converged},
          {"met", a.met},
          {"within", a.within()},
          {"friction_torque", a.friction},
          {"h_min", a.h_min},
          {"error_friction", a.error_friction},
          {"error_h_min", a.error_h_min},
          {"bar_friction", a.bar_friction},
          {"bar_h_min", a.bar_h_min},
          {"seconds", a.seconds},
          {"factorizations", a.factorizations},
          {"tier", a.tier},
          {"chosen", a.chosen},
          {"off_friction", a.off_friction},
          {"off_h_min", a.off_h_min},
          {"holds_truth", a.holds_truth},
          {"holds_limit", a.holds_limit}};
}

AutoAnswer answer_from(const Json& j) {
  AutoAnswer a;
  a.tolerance = j.at("tolerance");
  a.converged = j.at("converged");
  a.met = j.at("met");
  a.friction = number_from(j.at("friction_torque"));
  a.h_min = number_from(j.at("h_min"));
  a.error_friction = number_from(j.at("error_friction"));
  a.error_h_min = number_from(j.at("error_h_min"));
  a.bar_friction = number_from(j.at("bar_friction"));
  a.bar_h_min = number_from(j.at("bar_h_min"));
  a.seconds = j.at("seconds");
  a.factorizations = j.at("factorizations");
  a.tier = j.at("tier");
  a.chosen = j.at("chosen");
  a.off_friction = number_from(j.at("off_friction"));
  a.off_h_min = number_from(j.at("off_h_min"));
  a.holds_truth = j.at("holds_truth");
  a.holds_limit = j.at("holds_limit");
  return a;
}

CaseEnd end_from(const std::string& words) {
  for (const CaseEnd end : {CaseEnd::done, CaseEnd::over_budget, CaseEnd::failed}) {
    if (words == to_string(end)) return end;
  }
  return CaseEnd::stopped;
}

}  // namespace

Json trial_json(const AutoTrial& t) {
  Json one{{"seed", t.seed},
           {"end", to_string(t.end)},
           {"why", t.why},
           {"processor_s", t.processor_s},
           {"truth_converged", t.truth_converged},
           {"seconds_800x100", t.truth_seconds},
           {"seconds_400x50", t.usual_seconds},
           {"factorizations_800x100", t.truth_factorizations},
           {"off_friction_400x50", t.usual_friction},
           {"off_h_min_400x50", t.usual_h_min},
           {"answers", Json::array()}};
  for (const AutoAnswer& a : t.answers) one["answers"].push_back(answer_json(a));
  return one;
}

std::string to_text(const AutoTrial& trial) {
  return trial_json(trial).dump(-1, ' ', false, Json::error_handler_t::replace);
}

AutoTrial auto_trial_from(const std::string& text) {
  const Json j = Json::parse(text);
  AutoTrial t;
  t.seed = j.at("seed");
  t.end = end_from(j.at("end"));
  t.why = j.at("why");
  t.truth_converged = j.at("truth_converged");
  t.truth_seconds = j.at("seconds_800x100");
  t.usual_seconds = j.at("seconds_400x50");
  t.truth_factorizations = j.at("factorizations_800x100");
  t.usual_friction = number_from(j.at("off_friction_400x50"));
  t.usual_h_min = number_from(j.at("off_h_min_400x50"));
  for (const Json& a : j.at("answers")) t.answers.push_back(answer_from(a));
  return t;
}

}  // namespace shellback::validation
