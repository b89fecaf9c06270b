#pragma once
/// A case made ready to solve: grid, oil, contact, solids; fixed for one geometry.
#include <functional>
#include <memory>
#include <optional>

#include "bearing/case.hpp"
#include "bearing/physics.hpp"
#include "core/gauss_lobatto.hpp"
#include "fluid/film_flux.hpp"
#include "fluid/resultants.hpp"
#include "solid/asperity_contact.hpp"

namespace shellback::bearing {

class Solids;

/// A bearing: what no solve changes. What it is asked to do is its OperatingPoint
/// (operating_point.hpp).
struct BearingModel {
  Case input;
  Physics physics;
  CrossFilmNodes gl;
  fluid::FilmDomain domain;
  fluid::SupplyMap supply;  ///< as the case gives it; drillings and vessels move it in time
  Field profile;            ///< designed deviation of the shell per cell; empty: none [m]
  fluid::Gap shape;         ///< the same where it is smooth; empty: a cylinder [m]
  double clearance = 0.0;   ///< cold radial clearance [m]
  rheology::Oil oil;        ///< with the switched-off effects taken out
  std::optional<solid::AsperityContact> contact;
  std::shared_ptr<const Solids> solids;  ///< set if the physics needs them
  fluid::CavitatedShear shear_rule = fluid::CavitatedShear::filled;
};

/// Its oil with the effects taken out that `physics` does not have.
[[nodiscard]] rheology::Oil oil_of(const Case& c, const Physics& physics);

/// Its two surfaces' contact with its limit, whatever the tier; none: not given.
[[nodiscard]] std::optional<solid::AsperityContact> contact_of(const Case& c);

/// As the case says; otherwise graded where surfaces can touch under a load that stands still,
/// whatever the tier: at the edges contact and elastic pressure are steepest. Load cycles stay on
/// even cells: on their coarse grids graded ones lose TEHD cycles (docs/decisions/031). One case
/// has one spacing, so that tiers and effects can be compared cell by cell.
[[nodiscard]] AxialSpacing axial_spacing(const Case& c);

/// True if nothing in the case distinguishes z from -z.
[[nodiscard]] bool symmetric_about_mid_width(const Case& c);

/// Most cells along the axis that can be solved [-].
[[nodiscard]] int most_axial_cells(const Case& c);

/// The cells of a grid of around x along cells over the width. Throws InputError where they are too
/// few for the edges of the supplies.
[[nodiscard]] FilmGrid film_grid(const Case& c, std::array<int, 2> grid);
/// The cells of it that supplies take, as the case gives them. Throws as film_grid() does.
[[nodiscard]] fluid::SupplyMap supply_map(const Case& c, std::array<int, 2> grid);
/// Whether the cells are enough for them, and for the lands beside those that have a vessel.
[[nodiscard]] bool holds_supplies(const Case& c, std::array<int, 2> grid);

/// Builds the model on a grid of nt x nz cells over the full width (half of it is solved if the
/// case is symmetric). Solids are built if the physics needs them, unless given. Throws
/// InputError for supplies that the grid cannot carry.
[[nodiscard]] BearingModel make_bearing(const Case& c, const Physics& physics,
                                        std::array<int, 2> grid,
                                        std::shared_ptr<const Solids> solids = nullptr);

/// Summits reach this many times the combined roughness [-]: three deviations of a Gaussian height,
/// beyond which a thousandth of it lies (textbook).
inline constexpr double kSummits = 3.0;

/// The gap at a position of the journal, with a smooth displacement of the walls (cells; empty:
/// none) [m].
[[nodiscard]] fluid::Gap gap_at(const BearingModel& m, const fluid::JournalPosition& position,
                                const Field& displacement);

/// Gap with which the film shears [m]: the nominal gap, for rough surfaces the average gap, which
/// is positive even in contact.
[[nodiscard]] Field shear_gap(const BearingModel& model, const Field& h);

}  // namespace shellback::bearing
