#pragma once
/// The marks of a chart: one shape and colour per family, and words beside them.
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "validation/chart/chart_settings.hpp"

namespace shellback::validation {

inline constexpr double kMark = 4.2;  ///< radius of a mark [px]

struct Look {
  ChartFamily family;
  const char* colour;  ///< after Okabe and Ito: told apart by colour-blind readers
  const char* words;   ///< in the legend
};
[[nodiscard]] const std::vector<Look>& chart_looks();
[[nodiscard]] const Look& look_of(ChartFamily family);

void draw_mark(app::Svg& svg, app::Point c, ChartFamily family);
/// The cross of a solve that failed.
void draw_cross(app::Svg& svg, app::Point c, const std::string& colour);

/// Puts words beside marks where they cover least.
class WordsBesideMarks {
 public:
  explicit WordsBesideMarks(app::Box inside) : inside_(inside) {}
  /// Keeps words off this mark.
  void block(app::Point c, double r) { taken_.push_back({c.x - r, c.y - r, 2.0 * r, 2.0 * r}); }
  void put(app::Svg& svg, app::Point c, const std::string& words, const std::string& colour);

 private:
  [[nodiscard]] double covered(const app::Box& b) const;
  app::Box inside_;
  std::vector<app::Box> taken_;
};

}  // namespace shellback::validation
