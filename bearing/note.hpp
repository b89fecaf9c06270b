#pragma once
/// What a result says of itself beside its numbers: warnings and assumptions. Their words are made
/// in app/words; texts are told as they are.
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "bearing/case.hpp"
#include "bearing/effect_kind.hpp"
#include "core/outcome.hpp"

namespace shellback::bearing {

namespace note {

enum class Plain {
  orientation_beyond_table,  ///< of the roughness, for the tabulated flow factors
  pressure_beyond_law,       ///< of the oil
  rigid_layer,               ///< elasto-plastic, under surfaces taken as rigid
  layer_keeps_thickness,     ///< elasto-plastic, as the shell's mean temperature changes
  edge_oil_as_supply,        ///< oil that comes in again at a side edge
  edge_oil_as_film,          ///< the same where the film has one temperature
  planes_overlap,            ///< mean planes of rough surfaces, where the film is smallest
  marks_begin_anew,          ///< of an elasto-plastic layer that wears under a standing load
  roughness_stays,           ///< of a shell that wears
  nothing_wears,             ///< in a running-in: a millionth of the summits at most
  tilt_without_inertia,      ///< of a journal with mass under a moment
  torque_both_ways,          ///< of a journal that turns both ways, in the mean
  // Where an event of a load cycle begins.
  event_from_steady,    ///< state of its first row
  event_at_rest,        ///< asperities carrying the load of its first row
  event_in_the_middle,  ///< of a full film: no steady state of its first row
  event_without_heat,   ///< walls and film at the supply's temperature: no steady state with heat
  event_in_lumps,       ///< its heat leaves with the oil that is fed over it
  estimate_in_the_middle,  ///< as event_in_the_middle, by mobility
  // Of error bars.
  bars_interrupted,
  bars_unknown,        ///< no other grid gave a solution
  cycle_bars_unknown,  ///< no coarser grid carries the cycle
  time_bars_unknown,   ///< with other steps no periodic state was found
  march_bars_unknown,  ///< no coarser grid passes the warm-up or course
  orbit_not_judged,    ///< led on, and whether a displaced journal comes back is not known
  nodes_not_judged,    ///< more nodes across the film gave no solution
  nothing_richer,      ///< than this physics
  walls_not_judged,    ///< no data of shell and shaft
  // Of tier estimate.
  estimate_of_cycle,
  estimate_vessel_open,
  estimate_drilling,
  supply_temperature_unused,  ///< by tier isothermal with a temperature of the oil that is given
};

/// Error bars made with a finer grid: no coarser one has given a solution, or summits make most of
/// the friction.
struct BarsFromFinerGrid {
  std::array<int, 2> grid{0, 0};
};

/// Richer physics that gave no solution on the coarse grid: no bars of the physics left out.
struct RicherNotFound {
  std::vector<EffectKind> effects;
};

/// Effects that cannot be judged for want of data of shell and shaft.
struct EffectsNotJudged {
  std::vector<EffectKind> effects;
};

/// Scalars of a finer grid than the fields, by tier `auto`.
struct ScalarsOfFinerGrid {
  std::array<int, 2> scalars{0, 0};
  std::array<int, 2> fields{0, 0};
  std::vector<std::string> solved;  ///< on the way
};

/// The tolerance of tier `auto` is not met: what the bars leave, and why.
struct ToleranceNotMet {
  enum class Why { no_walls, grid_given, grid_limit, cycle_grid, not_laminar };
  double tolerance = 0.0;  ///< [-]
  double friction = 0.0;   ///< [-]
  double h_min = 0.0;      ///< [-]
  Why why = Why::grid_limit;
  bool of_cycle = false;  ///< the mean friction torque
};

/// A tier without thermal deformation: the gap is that of the cold bearing.
struct ColdClearance {
  double part = 0.0;  ///< of the clearance by which heat may change it, of the order of [-]
};

/// The shaft's surface is at its mean: over the cycle, or around it over an event.
struct ShaftSwing {
  double T = 0.0;  ///< by which it would swing [K]
  bool over_event = false;
  double standing = 0.0;  ///< by which, at most, it stays warmer or colder around [K]
};

/// Load that a given step in time passes over.
struct LoadMissed {
  double part = 0.0;  ///< mean over the step less that of its ends, over the largest load [-]
  double from = 0.0, to = 0.0;  ///< the step [s]
};

/// Heat of an event goes deeper than skins, in which it goes straight, stand for bodies.
struct LongEvent {
  double reach = 0.0;     ///< how deep [m]
  double straight = 0.0;  ///< and how deep it may [m]
};

/// Cycles that go on differing by more than kClosed, by chance.
struct CyclesWander {
  double closure = 0.0;  ///< CycleResult::closure [-]
};

/// Shell and housing are joined in the model; as warm as they are nothing presses them together.
struct JointPulls {
  double pressure = 0.0;  ///< by which the joint would pull [Pa]
  double joined = 0.0;    ///< opening of the bore by heat, as it is told [m]
  double loose = 0.0;     ///< of a shell that grows by itself [m]
};

/// Tier estimate of a steady bearing.
struct EstimateOfFilm {
  std::string regime;
};

/// Tier estimate leaves the journal's mass out.
struct EstimateWithoutMass {
  double mass = 0.0;  ///< [kg]
};

/// The film is colder at one place than everything around it.
struct ColdSpot {
  double T = 0.0;  ///< [K]
};

/// Stiffness and damping were asked for and are not given.
struct NoCoefficients {
  Verdict why;
};

/// Damping by oil that comes and goes in the cavitated film, which only slow motions feel so.
struct CavitatedDamping {
  double share = 0.0;  ///< of all [-]
};

/// The heat balance of the whole bearing is met elsewhere, too.
struct OtherRoots {
  struct Root {
    double T = 0.0;  ///< [K]
    bool stable = false;
    bool taken = false;
  };
  std::vector<Root> roots;
};

/// Gaps below the smallest of the measured flow factors.
struct FactorsContinued {
  long cells = 0;
  double h = 0.0;         ///< the smallest measured [m]
  double H = 0.0;         ///< the same over sigma [-]
  bool measured = false;  ///< else the lower end of the fits
};

/// Sliding over film beyond the largest shear rate of the oil's law.
struct ShearBeyondLaw {
  double rate = 0.0;   ///< [1/s]
  double limit = 0.0;  ///< [1/s]
};

/// Film temperatures outside the range in which the oil's viscosity is known.
struct BeyondOilRange {
  double T_low = 0.0, T_high = 0.0;  ///< of the film; T_low not-a-number: not known [K]
  double T_min = 0.0, T_max = 0.0;   ///< of the oil [K]
};

/// Surfaces pressed deeper into each other than the contact law describes.
struct BeyondContactLaw {
  long cells = 0;
  double h = 0.0;      ///< smallest, negative [m]
  double sigma = 0.0;  ///< roughness of the summits [m]
  double least = 0.0;  ///< gap at which the law ends, negative [m]
  FilmPlace place{};   ///< of the smallest gap
};

/// The gap at a side edge, continued from the last cells, is closed while no cell's is; of smooth
/// elastic surfaces: it is less than half of any cell's.
struct EdgeNotResolved {
  double edge = 0.0;  ///< [m]
  double cell = 0.0;  ///< smallest of all cells [m]
};

/// The smooth bore changes within cells by more than they can show.
struct ShapeBetweenCells {
  double missed = 0.0;  ///< largest [m]
  double h_min = 0.0;   ///< smallest film, or the roughness [m]
  FilmPlace place{};    ///< of the largest
};

/// The designed profile, taken at the middles of cells, is not that of the table.
struct ProfileBetweenCells {
  double part = 0.0;  ///< of its volume that is missed or too much [-]
};

/// Rough surfaces without data of contact are nearer than their summits bear without touching.
struct ContactLeftOut {
  double lambda = 0.0;  ///< smallest film over the combined roughness [-]
};

/// Oil that is driven faster than a laminar film bears.
struct NotLaminar {
  double reynolds = 0.0;  ///< Re of the clearance [-]
  double limit = 0.0;     ///< beyond which vortices or turbulence begin [-]
};

/// A film whose inertia is no longer small beside its viscous forces.
struct FilmInertia {
  double reduced = 0.0;   ///< rho omega c^2/eta, of a squeezed film rho v c/eta [-]
  bool squeezed = false;  ///< by a journal that moves by v
};

/// A layer that is pressed beyond its hardness and taken as elastic.
struct LayerBeyondHardness {
  std::string name;       ///< of its material
  double p_max = 0.0;     ///< film pressure [Pa]
  double hardness = 0.0;  ///< [Pa]
};

/// Oil that is pressed out of a supply so fast that its inertia counts.
struct FedFlow {
  double velocity = 0.0;  ///< where its head is most of what drives it [m/s]
  double head = 0.0;      ///< there [Pa]
  double part = 0.0;      ///< head over what drives it [-]
  double reynolds = 0.0;  ///< largest of all such oil [-]
  FilmPlace place{};
};

/// Viscous shear stress beyond what oils bear.
struct OilSheared {
  double stress = 0.0;    ///< where it is most of what oil bears there [Pa]
  double pressure = 0.0;  ///< film pressure there [Pa]
  double part = 0.0;      ///< stress over what oil bears [-]
  FilmPlace place{};
};

/// Contact pressure held at the hardness: summits flow.
struct HeldAtHardness {
  double hardness = 0.0;  ///< [Pa]
  long cells = 0;
  double flow = 0.0;  ///< deepest [m]
  FilmPlace place{};  ///< there
};

/// A layer of the shell that the largest pressure compresses beyond small strains.
struct LayerPressed {
  int layer = 0;
  double strain = 0.0;   ///< of its thickness [-]
  bool sheared = false;  ///< else compressed
};

/// Wear that has gone through the shell's first layer.
struct WornThrough {
  double depth = 0.0;      ///< [m]
  double thickness = 0.0;  ///< of that layer [m]
};

/// Wear deeper than the radial clearance.
struct WornBeyondClearance {
  double depth = 0.0;      ///< [m]
  double clearance = 0.0;  ///< [m]
};

/// A worn shape that is deeper at the side edges, to which it is led on, than in any cell.
struct WearLedOn {
  double depth = 0.0;  ///< in the cells [m]
  double edge = 0.0;   ///< at the edges [m]
};

/// A running-in whose states ended at a time, and which went on in another one of that shape.
struct StatesEnd {
  double t = 0.0;              ///< [s]
  double torque_before = 0.0;  ///< [N m]
  double torque = 0.0;         ///< [N m]
  int times = 0;               ///< that it did so; the others are of the first
  bool flows = false;          ///< an elasto-plastic layer has marks
};

/// An elasto-plastic layer that has flowed by more than half of its thickness.
struct LayerFlown {
  double depth = 0.0;      ///< [m]
  double thickness = 0.0;  ///< [m]
};

/// The shell's surface is hotter than its material bears.
struct LiningTooHot {
  std::string material;
  double T = 0.0;      ///< largest [K]
  double limit = 0.0;  ///< [K]
};

/// A bearing in time came to rest in another steady state than the one solved for itself.
struct OtherSteadyState {
  double torque = 0.0;             ///< in the end [N m]
  double T_film_max = 0.0;         ///< [K]
  double steady_torque = 0.0;      ///< of the one solved [N m]
  double steady_T_film_max = 0.0;  ///< [K]
};

/// A vessel of a supply at the cavitation pressure.
struct VesselEmpty {
  double part = 0.0;  ///< of the time [-]
};

/// The mouth of a hole or drilling that is finer than the grid.
struct MouthWidened {
  int supply = 0;
  double diameter = 0.0;  ///< [m]
  double taken = 0.0;     ///< [m]
};

/// A groove or hole whose land to a side edge no cell of the grid is in.
struct LandUnseen {
  int supply = 0;
  double land = 0.0;  ///< [m]
};

/// Supplies of different pressure or temperature without a film between them.
struct SuppliesJoined {
  int first = 0, second = 0;
};

/// A supply into which more oil is pressed back than it feeds.
struct SupplyTakesBack {
  int supply = 0;
  double flow = 0.0;  ///< back into it [m3/s]
  double fed = 0.0;   ///< by all that feed [m3/s]
};

/// Summits in contact that hardly slide: their friction is not all there.
struct HardlySliding {
  double speed = 0.0;  ///< [m/s]
  double part = 0.0;   ///< of the friction of summits that slide [-]
};

/// Tier `auto`: what richer physics would change is not known, its tier being not found.
struct NothingRicher {
  Tier tier = Tier::tehd;
  std::array<int, 2> grid{0, 0};  ///< on which it was tried
  Verdict why;
};

/// What tier `auto` took for a load cycle.
struct TierTaken {
  Tier tier = Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  double friction = 0.0;  ///< most that the physics left out is worth, of the mean torque [-]
  double h_min = 0.0;     ///< the same of the smallest film [-]
  std::vector<NothingRicher> unjudged;  ///< one, if that is not known; or none
  std::vector<std::string> solved;      ///< on the way
};

}  // namespace note

using Note = std::variant<
    std::string, note::Plain, note::ColdSpot, note::NoCoefficients, note::CavitatedDamping,
    note::OtherRoots, note::FactorsContinued, note::ShearBeyondLaw, note::BeyondOilRange,
    note::BeyondContactLaw, note::HeldAtHardness, note::EdgeNotResolved, note::ShapeBetweenCells,
    note::ProfileBetweenCells, note::ContactLeftOut, note::NotLaminar, note::FilmInertia,
    note::LayerBeyondHardness, note::FedFlow, note::OilSheared, note::VesselEmpty,
    note::MouthWidened, note::WornThrough, note::LayerFlown, note::WornBeyondClearance,
    note::WearLedOn, note::StatesEnd, note::LiningTooHot, note::OtherSteadyState,
    note::LayerPressed, note::NothingRicher, note::TierTaken, note::BarsFromFinerGrid,
    note::RicherNotFound, note::EffectsNotJudged, note::ScalarsOfFinerGrid, note::ToleranceNotMet,
    note::LandUnseen, note::SuppliesJoined, note::HardlySliding, note::SupplyTakesBack,
    note::ColdClearance, note::ShaftSwing, note::LongEvent, note::CyclesWander, note::JointPulls,
    note::LoadMissed, note::EstimateOfFilm, note::EstimateWithoutMass>;

}  // namespace shellback::bearing
