#include "validation/chart/chart_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/labels/csv_text.hpp"
#include "app/words/ending_words.hpp"
#include "bearing/possible_methods.hpp"

namespace shellback::validation {
namespace {

using namespace bearing;

std::string csv_number(double x) { return std::isfinite(x) ? fmt::format("{:.8g}", x) : ""; }

std::string across_of(const ChartSetting& s) {
  if (s.methods.across == AcrossFilm::layers) return fmt::format("layers {}", s.methods.layers);
  if (s.methods.across == AcrossFilm::mean) return "mean";
  return fmt::format("lobatto {}", s.film_nodes);
}

std::string elastic_of(const Methods& m) {
  if (m.elastic == ElasticMethod::newton) return "newton";
  return m.relaxation > 0.0 ? fmt::format("fixed-point {}", m.relaxation) : "fixed-point aitken";
}

std::string row(const ChartScene& scene, const ChartPoint& p) {
  const ChartSetting& s = p.setting;
  std::string line = fmt::format("{},{},{},{}", scene.name, to_string(s.family),
                                 app::csv_text(s.mark), to_string(s.tier));
  if (s.family == ChartFamily::automatic) {
    line += ",,,,,";
  } else {
    line += fmt::format(",{},{},{},{},{}", s.grid[0], s.grid[1], across_of(s),
                        to_string(s.methods.cavitation), elastic_of(s.methods));
  }
  line +=
      fmt::format(",{},{}", to_string(p.verdict.status), app::csv_text(app::reason_of(p.verdict)));
  const bool good = p.verdict.good();
  for (const double v : p.value) line += "," + csv_number(good ? v : NAN);
  for (const double e : p.error) line += "," + csv_number(e);
  line += fmt::format(",{},{},{}", csv_number(p.wall_s), p.factorizations, p.sweeps);
  for (const bool on : p.on_front) line += on ? ",1" : ",0";
  return line + "\n";
}

}  // namespace

std::string chart_csv(const std::vector<ChartScene>& scenes) {
  std::string text =
      "scene,family,mark,tier,cells_around,cells_across_width,across_film,cavitation,elastic,"
      "status,reason,friction_torque_Nm,h_min_m,T_film_max_K,error_friction_torque,error_h_min,"
      "error_T_film_max_K,wall_s,factorizations,sweeps,front_friction_torque,front_h_min,"
      "front_T_film_max\n";
  for (const ChartScene& scene : scenes) {
    text += fmt::format("{},reference,,,,,,,,{},{}", scene.name, to_string(scene.verdict.status),
                        app::csv_text(app::reason_of(scene.verdict)));
    for (const ReferenceValue& r : scene.reference) text += "," + csv_number(r.value);
    for (const double f : scene.floor) text += "," + csv_number(f);
    text += ",,,,,,\n";
    for (const ChartPoint& p : scene.points) text += row(scene, p);
  }
  return text;
}

}  // namespace shellback::validation
