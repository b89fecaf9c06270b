#include <cmath>

#include "app/json_parts.hpp"
#include "app/write_identify.hpp"
#include "bearing/quantities.hpp"

namespace shellback::app {

using namespace json_parts;

namespace {

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

Json keys_json(const IdentifyView& v) {
  const study::Fit& fit = v.end.fit;
  Json list = Json::array();
  for (std::size_t k = 0; k < v.keys.size(); ++k) {
    const FittedKey& key = v.keys[k];
    const bool judged = k < fit.deviation.size();
    list.push_back({{"key", key.key},
                    {"unit", key.unit},
                    {"start", key.value.start},
                    {"value", number(fit.computed() ? fit.x[k] : NAN)},
                    {"deviation", number(judged ? fit.deviation[k] : NAN)},
                    {"bounds", {key.value.low, key.value.high}},
                    {"coordinate", in_logarithms(key.value) ? "logarithm" : "value"},
                    {"at_bound", judged && fit.at_bound[k] != 0},
                    {"set", fit.computed() ? Json(key.words(fit.x[k])) : Json(nullptr)}});
  }
  return list;
}

Json points_json(const IdentifyView& v) {
  Json list = Json::array();
  for (std::size_t i = 0; i < v.end.points.size(); ++i) {
    const auto& measured = v.table.points[i];
    const auto& p = v.end.points[i];
    Json point{{"name", measured.name}, {"found", p.used()}};
    if (!p.used()) add_status(point, p.verdict);
    for (const MeasuredInput& input : v.table.inputs) {
      point["inputs"][input.column] = {{"value", input.axis.numbers[i]}, {"unit", input.axis.unit}};
    }
    for (std::size_t k = 0; k < measured.values.size(); ++k) {
      const auto& m = measured.values[k];
      point["values"].push_back({{"quantity", m.quantity},
                                 {"unit", bearing::find_quantity(m.quantity)->unit},
                                 {"measured", m.value},
                                 {"deviation", number(m.deviation)},
                                 {"start", number(k < p.start.size() ? p.start[k] : NAN)},
                                 {"fitted", number(k < p.fitted.size() ? p.fitted[k] : NAN)}});
    }
    list.push_back(std::move(point));
  }
  return list;
}

}  // namespace

std::string identify_json(const IdentifyView& v) {
  const study::Fit& fit = v.end.fit;
  const std::vector<std::string> why = complaints(v);
  Json json{{"status", to_string(fit.status)},
            {"determined", fit.determined()},
            {"sound", why.empty() && fit.status == study::FitStatus::settled},
            {"complaints", why},
            {"misfit", misfit(v)},
            {"jumps", jumps(v)},
            {"title", v.subject.title},
            {"tier", to_string(v.subject.model.tier)},
            {"measured", v.table.path},
            {"keys", keys_json(v)}};
  json["correlation"] = Json::array();
  for (const auto& row : fit.correlation) json["correlation"].push_back(numbers(row));
  json["covariance"] = Json::array();  // in the units of the keys
  for (std::size_t i = 0; i < fit.correlation.size(); ++i) {
    std::vector<double> row = fit.correlation[i];
    for (std::size_t k = 0; k < row.size(); ++k) row[k] *= fit.deviation[i] * fit.deviation[k];
    json["covariance"].push_back(numbers(row));
  }
  json["directions"] = Json::array();
  for (const auto& d : fit.directions) {
    json["directions"].push_back({{"singular_value", number(d.singular_value)},
                                  {"deviation", number(d.deviation)},
                                  {"parts", numbers(d.part)},
                                  {"determined", d.determined},
                                  {"words", direction_words(v, d)}});
  }
  json["chi2"] = {
      {"start", number(fit.chi2_start)}, {"end", number(fit.chi2)}, {"freedom", fit.freedom}};
  json["deviation_found"] = number(found_deviation(v));
  json["search"] = {{"iterations", fit.iterations},
                    {"evaluations", fit.evaluations},
                    {"refused_steps", fit.refused_steps},
                    {"remaining", number(fit.remaining)},
                    {"accuracy", v.end.accuracy},
                    {"scale", number(fit.scale)},
                    {"difference_step", std::cbrt(v.end.accuracy)},
                    {"wall_s", v.end.wall_s}};
  json["points"] = points_json(v);
  json["provenance"] = provenance_json(v.subject);
  add_case(json, v.subject);
  return dump(json);
}

}  // namespace shellback::app
