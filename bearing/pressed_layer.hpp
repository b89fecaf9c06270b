#pragma once
/// The elasto-plastic layer of the shell (solid/surface_layer.hpp) on the film's cells.
///
/// Its depth adds to the elastic widening of the gap, cell by cell, under film and contact pressure
/// together: (3) of equilibrium.hpp with r(p + p_a). A steady bearing is one that is held under its
/// load from a layer as new: for so long that film and contact exceed the hardness by
///   P - p_plast = (r_p + r_y) delta c_y/own,   a few thousandths of it                     (1)
/// In time r_e and r_p are carried by the stages of film_step.hpp like the oil.
#include <optional>
#include <vector>

#include "bearing/case.hpp"
#include "core/grid.hpp"
#include "solid/surface_layer.hpp"

namespace shellback::bearing {

using Columns = std::vector<solid::LayerColumn>;

/// to + f k
void add(double f, const Columns& k, Columns& to);

/// The layer in the stage that is being solved.
struct PressedLayer {
  solid::SurfaceLayer law;
  double own = 0.0;  ///< length of the stage [s]
  Columns before;    ///< per cell, from which it begins

  /// As new, held for long.
  void hold(int cells);
  /// Every cell under p + p_a [Pa]; an empty field is zero.
  [[nodiscard]] std::vector<solid::PressedColumn> press(const Field& p,
                                                        const Field& p_contact) const;
};

/// The first layer of the shell if it is elasto-plastic, held; none otherwise.
[[nodiscard]] std::optional<PressedLayer> pressed_layer(const Case& c, int cells);

/// The layer at an instant of a load cycle.
struct LayerInTime {
  Columns now;        ///< empty: no layer
  Columns slope;      ///< d/dt at this instant [m/s]; empty: not known
  double loss = 0.0;  ///< what it turns into heat, solved part [W]
};

/// Rates of a solved stage, and its loss by solid::layer_loss.
[[nodiscard]] LayerInTime stage_of(const PressedLayer& layer, const FilmGrid& g, const Field& p,
                                   const Field& p_contact,
                                   const std::vector<solid::PressedColumn>& found);

/// What is left of the layer's depth, per cell [m].
[[nodiscard]] Field lasting_depth(const Columns& columns);
[[nodiscard]] Field lasting_depth(const std::vector<solid::PressedColumn>& found);

}  // namespace shellback::bearing
