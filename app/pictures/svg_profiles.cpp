#include "app/pictures/svg_profiles.hpp"

#include <algorithm>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_film.hpp"

namespace shellback::app {
namespace {

using bearing::Fields;

struct ProfileCurve {
  Field Fields::*field;
  const char* suffix;  ///< of the name in the legend
  const char* dash;
};

struct Recipe {
  const char* title;
  const char* y_title;
  DisplayUnit unit;
  bool from_zero;
  bool hide_supplied;
  std::vector<ProfileCurve> curves;
};

Recipe recipe(Profile which) {
  const DisplayUnit celsius = display_unit("T_mean", "K");
  switch (which) {
    case Profile::pressure:
      return {"Film pressure",       "p [MPa]", display_unit("p", "Pa"), true, false,
              {{&Fields::p, "", ""}}};
    case Profile::gap:
      return {"Gap", "h [µm]", display_unit("h", "m"), true, true, {{&Fields::h, "", ""}}};
    case Profile::film_temperature:
      return {"Mean film temperature",    "T [°C]", celsius, false, false,
              {{&Fields::T_mean, "", ""}}};
    case Profile::shell_temperature:
      break;
  }
  return {"Shell temperature",
          "T [°C]",
          celsius,
          false,
          false,
          {{&Fields::T_shell_surface, " bore", ""}, {&Fields::T_shell_back, " back", "5 3"}}};
}

/// That of its tier; of a tier that is shown again another one.
const std::string& colour_of(const bearing::Comparison& comparison, std::size_t k,
                             const Theme& theme) {
  const auto& results = comparison.results;
  const auto same = [&](const auto& r) { return r.tier == results[k].tier; };
  const bool again = std::any_of(results.begin(), results.begin() + k, same);
  return again ? theme.series.back() : tier_colour(results[k].tier, theme);
}

std::string title_of(const bearing::Comparison& comparison, const std::string& what) {
  if (comparison.results.empty()) return what;
  return what + " " + words_of_mid_line(comparison.results.front());
}

}  // namespace

const std::string& tier_colour(bearing::Tier tier, const Theme& theme) {
  return theme.series[static_cast<std::size_t>(tier)];
}

std::optional<LinePlot> profile_plot(const bearing::Comparison& comparison, Profile which,
                                     const Theme& theme) {
  const Recipe r = recipe(which);
  const auto names = column_names(comparison.results);
  LinePlot plot{title_of(comparison, r.title), degree_axis(), r.y_title, {}, r.from_zero};
  for (std::size_t k = 0; k < comparison.results.size(); ++k) {
    const auto& result = comparison.results[k];
    for (const auto& curve : r.curves) {
      const Field& field = result.fields.*curve.field;
      if (field.empty()) continue;
      Series series = mid_line(result, field, r.unit, r.hide_supplied);
      series.name = names[k] + curve.suffix;
      series.colour = colour_of(comparison, k, theme);
      series.dash = curve.dash;
      plot.series.push_back(std::move(series));
    }
  }
  return plot.series.empty() ? std::nullopt : std::optional(plot);
}

}  // namespace shellback::app
