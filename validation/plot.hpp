#pragma once
/// Axes, linear or logarithmic, and marks for the ledger's pictures.
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "validation/ledger/ledger_entry.hpp"

namespace shellback::validation {

struct Scale {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
  std::vector<double> ticks;
  std::string title;
  /// Position of a value, 0 at the low end and 1 at the high one.
  [[nodiscard]] double at(double value) const;
};

/// Scale over the finite values (positive ones if logarithmic), a little wider than they are;
/// `from_zero`: a linear one begins at 0 if all values are positive.
[[nodiscard]] Scale make_scale(const std::vector<double>& values, bool logarithmic, bool from_zero,
                               std::string title);

struct PlotFrame {
  app::Box box;
  Scale x;
  Scale y;
  [[nodiscard]] app::Point at(double vx, double vy) const {
    return {box.x + box.width * x.at(vx), box.bottom() - box.height * y.at(vy)};
  }
  /// True if the value has a place on both scales.
  [[nodiscard]] bool shows(double vx, double vy) const;
};

enum class Labels { both, only_y };

/// Outline, ticks, grid lines, labels and titles.
void draw_frame(app::Svg& svg, const PlotFrame& frame, const app::Theme& theme, Labels labels);

/// The mark of a kind of evidence: filled circle measured, open circle published calculation, plus
/// exact, cross recomputed, square own.
void draw_mark(app::Svg& svg, app::Point at, Evidence evidence, const std::string& colour);

}  // namespace shellback::validation
