#pragma once
/// A flat slider with a pocket, solved by the journal bearing's film equation.
///
/// The slider of length L lies on a ring of circumference 5/4 L, which has no curvature in the film
/// equation; the rest of the ring is a supply at ambient pressure. The wedge is a smooth
/// displacement of the gap, the pocket a step whose edges lie on cell faces.
#include <vector>

#include "core/outcome.hpp"
#include "fluid/reynolds.hpp"

namespace shellback::validation {

struct Slider {
  double length = 0.0;        ///< L [m]
  double width = 0.0;         ///< [m]; 0: endlessly wide, solved on one axial cell
  double h_in = 0.0;          ///< gap at x = 0 [m]
  double h_out = 0.0;         ///< gap at x = L [m]
  double pocket_from = 0.0;   ///< [m]
  double pocket_to = 0.0;     ///< [m]
  double pocket_width = 0.0;  ///< [m]; not used if endlessly wide
  double depth = 0.0;         ///< of the pocket [m]
  double speed = 0.0;         ///< of the surface [m/s]
  double p_ambient = 0.0;     ///< above the cavitation pressure [Pa]
  int cells = 0;              ///< over L [-]
  int cells_across = 1;       ///< over the width [-]
};

struct SliderFilm {
  std::vector<double> x;        ///< cell positions over the slider, ends included [m]
  std::vector<double> p;        ///< pressure at mid-width there, above cavitation [Pa]
  double p_max = 0.0;           ///< of the cells at mid-width [Pa]
  double flow_per_width = 0.0;  ///< mean over the faces of the slider [m2/s]; of mid-width
  double reformation = 0.0;     ///< where the film is full again at mid-width [m]; -1: nowhere
  double load_per_width = 0.0;  ///< above ambient, at mid-width [N/m]
  Verdict verdict;
};

/// Solves the slider's film with an oil of `density` at ambient pressure [kg/m3].
[[nodiscard]] SliderFilm solve_slider(const Slider& slider, const fluid::OilLaw& oil,
                                      double density);

/// Pressure at x, linear between the cells [Pa].
[[nodiscard]] double pressure_at(const SliderFilm& film, double x);

}  // namespace shellback::validation
