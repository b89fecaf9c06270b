#include "app/judge_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "rheology/shear.hpp"

namespace shellback::app {
namespace {

using namespace coupling;

/// Possible and usual range of one derived number.
struct Limits {
  double least;        ///< below: absurd
  double usual_least;  ///< below: suspicious
  double usual_most;
  double most;
};

// Radii from a watch's pivot to a ship's stern tube [m].
constexpr Limits kRadius{2.5e-4, 2e-3, 1.0, 3.0};
// Plain bearings are made with c/R around 1e-3 [-].
constexpr Limits kClearanceRatio{1e-5, 2e-4, 5e-3, 0.05};
// Width over diameter: below 0.1 a seal, above 2 edges rule [-].
constexpr Limits kAspect{0.02, 0.1, 2.0, 10.0};
// Surface speed [m/s]; turbomachinery reaches about 120.
constexpr Limits kSurfaceSpeed{0.0, 0.0, 120.0, 400.0};
// Load over projected area [Pa]; engine bearings reach about 150 MPa peak.
constexpr Limits kSpecificLoad{0.0, 1e3, 150e6, 2e9};
// Largest tilt at the edge over the clearance [-]: at 1 the journal spans the gap crosswise.
constexpr Limits kEdgeTilt{0.0, 0.0, 0.5, 1.0};
// Combined roughness over clearance [-].
constexpr Limits kRoughness{0.0, 0.0, 0.05, 0.5};
// Viscosity constants [Pa s]: air to pitch; lubricating oils lie between.
constexpr Limits kViscosityLimits{1e-6, 5e-4, 2.0, 1e3};
// Bulk modulus of the oil at no pressure [Pa]: liquids lie between 0.8 (petrol) and 5 GPa.
constexpr Limits kBulkModulus{1e8, 8e8, 6e9, 1e11};
// Thermal expansion of the oil [1/K]: lubricating oils 6.4e-4 to 7.3e-4 (seed 002, after Eq. 28);
// at 5e-3 the density would be gone 200 K above its reference.
constexpr Limits kOilExpansion{0.0, 0.0, 1.5e-3, 5e-3};

/// Refuses or warns about a number; `what` tells number and meaning, `cure` what to check.
void judge(Case& subject, const Reader& reader, const std::string& key, double value,
           const Limits& limits, const std::string& what, const std::string& cure) {
  if (!(value >= limits.least && value <= limits.most)) {
    refuse(reader, key, fmt::format("{}, which no bearing has; {}", what, cure));
  }
  if (value < limits.usual_least || value > limits.usual_most) {
    warn(subject, reader, key, fmt::format("{}, which is unusual; {}", what, cure));
  }
}

void judge_bearing(Case& subject, const Reader& reader) {
  const Bearing& b = subject.bearing;
  judge(subject, reader, "bearing.diameter", b.radius, kRadius,
        fmt::format("the diameter is {}", show(2.0 * b.radius, "mm", kLength)), "check its unit");
  judge(subject, reader, "bearing.radial_clearance", b.radial_clearance / b.radius, kClearanceRatio,
        fmt::format("the radial clearance is {:.3g} of the radius ({} of {})",
                    b.radial_clearance / b.radius, show(b.radial_clearance, "mm", kLength),
                    show(b.radius, "mm", kLength)),
        "usual is 0.0005 to 0.003; check its unit, and that it is the radial, not the "
        "diametral clearance");
  const double aspect = b.width / (2.0 * b.radius);
  judge(subject, reader, "bearing.width", aspect, kAspect,
        fmt::format("the width is {:.3g} of the diameter", aspect), "check the units of both");
  if (!b.profile) return;
  const auto [low, high] = std::minmax_element(b.profile->height.begin(), b.profile->height.end());
  if (*high <= -b.radial_clearance || *high - *low > 0.1 * b.radius) {
    refuse(reader, "bearing.profile",
           fmt::format("heights from {} to {} leave no gap that could be a bearing's; check "
                       "the unit in the header line (positive heights widen the gap)",
                       show(*low, "um", kLength), show(*high, "um", kLength)));
  }
  if (*low <= -b.radial_clearance) {
    warn(subject, reader, "bearing.profile",
         "the profile takes away more than the whole radial clearance somewhere");
  }
}

void judge_load(Case& subject, const Reader& reader) {
  const Bearing& b = subject.bearing;
  const auto* load = std::get_if<LoadGiven>(&subject.operation.position);
  if (load == nullptr) return;
  const double specific = load->force / (2.0 * b.radius * b.width);
  judge(subject, reader, "operation.load", specific, kSpecificLoad,
        fmt::format("the load over the projected area is {}", show(specific, "MPa", kPressure)),
        "check the unit of the load");
}

void judge_speed(Case& subject, const Reader& reader) {
  const double omega = subject.operation.omega;
  if (omega == 0.0 && std::holds_alternative<LoadGiven>(subject.operation.position)) {
    refuse(reader, "operation.speed",
           "at zero speed no film forms that could carry the load: the journal rests on the "
           "shell, and there is no steady lubricated state to solve for; give a speed");
  }
  if (omega == 0.0) {
    refuse(reader, "operation.speed",
           "at zero speed nothing is dragged into the film: there is neither friction nor a "
           "hydrodynamic pressure to solve for; give a speed");
  }
  const double u = std::abs(omega) * subject.bearing.radius;
  judge(subject, reader, "operation.speed", u, kSurfaceSpeed,
        fmt::format("the surface speed is {:.4g} m/s", u), "check the unit of the speed");
}

void judge_tilt(Case& subject, const Reader& reader) {
  const auto* tilt = std::get_if<TiltGiven>(&subject.operation.alignment);
  if (tilt == nullptr) return;
  const Bearing& b = subject.bearing;
  const double edge = std::hypot(tilt->about_x, tilt->about_y) * 0.5 * b.width / b.radial_clearance;
  judge(subject, reader, "operation.tilt", edge, kEdgeTilt,
        fmt::format("the tilt moves the journal by {:.3g} radial clearances at the edges", edge),
        "above 1 it cannot fit into the bearing; check the unit (mrad?)");
}

void judge_surfaces(Case& subject, const Reader& reader) {
  const Surfaces& s = subject.surfaces;
  const double sigma = std::hypot(s.shell.roughness, s.shaft.roughness);
  judge(subject, reader, "surfaces", sigma / subject.bearing.radial_clearance, kRoughness,
        fmt::format("the combined roughness is {:.3g} of the radial clearance",
                    sigma / subject.bearing.radial_clearance),
        "check the units");
  const double summits = std::hypot(s.shell.summit_roughness, s.shaft.summit_roughness);
  if (s.contact && summits <= 0.0) {
    refuse(reader, "surfaces.contact",
           "asperity contact needs summit_roughness (and summit_height) of surfaces.shell and "
           "surfaces.shaft");
  }
  const Switches& on = subject.model.switches;
  if (on.asperity_contact.value_or(false) && !s.contact) {
    refuse(reader, "model.asperity_contact",
           "contact is switched on without [surfaces] contact; "
           "give it, or write \"auto\"");
  }
  if (on.flow_factors.value_or(false) && sigma <= 0.0) {
    refuse(reader, "model.flow_factors",
           "flow factors are switched on, but both surfaces are "
           "smooth; give [surfaces], or write \"auto\"");
  }
}

void judge_laws(Case& subject, const Reader& reader) {
  const Switches& on = subject.model.switches;
  const bool barotropic = std::holds_alternative<rheology::NoPressureEffect>(subject.oil.pressure);
  if (on.pressure_dependence.value_or(false) && barotropic) {
    refuse(reader, "model.pressure_dependence",
           "the pressure dependence is switched on, but the "
           "oil has no viscosity.pressure law");
  }
  const bool newtonian = std::holds_alternative<rheology::NoShearThinning>(subject.oil.shear);
  if (on.shear_thinning.value_or(false) && newtonian) {
    refuse(reader, "model.shear_thinning",
           "shear thinning is switched on, but the oil has no "
           "viscosity.shear law");
  }
  const auto* cross = std::get_if<rheology::Cross>(&subject.oil.shear);
  if (cross != nullptr && !rheology::stress_is_monotone(*cross)) {
    refuse(reader, "oil.viscosity.shear",
           "with these r and m the shear stress falls where the shear rate rises, which no oil "
           "does; m (1 - sqrt r) must be less than 1 + sqrt r");
  }
  const auto* constant = std::get_if<rheology::ConstantViscosity>(&subject.oil.temperature);
  const auto* slope = std::get_if<rheology::ReynoldsSlope>(&subject.oil.temperature);
  const double eta = constant != nullptr ? constant->eta : slope != nullptr ? slope->eta : 0.0;
  if (eta > 0.0) {
    judge(subject, reader, "oil.viscosity.temperature.eta", eta, kViscosityLimits,
          fmt::format("the viscosity is {}", show(eta, "mPa s", kViscosity)),
          "check its unit (Pa s or mPa s?)");
  }
}

void judge_density(Case& subject, const Reader& reader) {
  const auto* law = std::get_if<rheology::DowsonHigginson>(&subject.oil.density);
  if (law == nullptr) return;
  const double modulus = 1.0 / law->rise;
  judge(subject, reader, "oil.density.C1", modulus, kBulkModulus,
        fmt::format("C1 and C2 give a bulk modulus C1/(C2 - 1) of {}",
                    show(modulus, "GPa", kPressure)),
        "check the unit of C1 (Pa, MPa or GPa?)");
  judge(subject, reader, "oil.density.expansivity", law->expansivity, kOilExpansion,
        fmt::format("the oil's expansivity is {:.3g} 1/K", law->expansivity),
        "mineral oils have 6.4e-4 to 7.3e-4 1/K");
}

/// Every temperature at which the oil is sure to be used, by key.
std::vector<std::pair<std::string, double>> film_temperatures(const Case& subject) {
  std::vector<std::pair<std::string, double>> list;
  if (subject.oil_temperature) list.emplace_back("oil.temperature", *subject.oil_temperature);
  for (std::size_t k = 0; k < subject.supplies.size(); ++k) {
    list.emplace_back(fmt::format("supply.{}.temperature", k), subject.supplies[k].temperature);
  }
  if (subject.measured.shell_back_temperature) {
    list.emplace_back("measured.shell_back_temperature", *subject.measured.shell_back_temperature);
  }
  if (subject.shell) {
    if (const auto* back = std::get_if<PrescribedBack>(&subject.shell->back)) {
      list.emplace_back("shell.back.temperature", back->temperature);
    }
  }
  return list;
}

void judge_temperatures(Case& subject, const Reader& reader) {
  const auto& range = subject.oil.range;
  const auto* vogel = std::get_if<rheology::Vogel>(&subject.oil.temperature);
  for (const auto& [key, T] : film_temperatures(subject)) {
    if (vogel != nullptr && T - kZeroCelsius + vogel->C <= 1.0) {
      refuse(reader, key,
             fmt::format("the oil's Vogel law has its pole at -{:.4g} degC; it "
                         "cannot be used at {}",
                         vogel->C, show(T, "degC", kTemperature)));
    }
    if (T < range.T_min || T > range.T_max) {
      warn(subject, reader, key,
           fmt::format("{} lies outside the range in which the oil's laws hold ({} to {})",
                       show(T, "degC", kTemperature), show(range.T_min, "degC", kTemperature),
                       show(range.T_max, "degC", kTemperature)));
    }
  }
}

void judge_grid(Case& subject, const Reader& reader) {
  constexpr int kFewestRound = 16;     // below, not even a full film's maximum is resolved
  constexpr int kMostCells = 2000000;  // memory: some kB per cell
  const auto [nt, nz] = subject.model.grid;
  if (nt < kFewestRound) {
    refuse(reader, "model.grid",
           fmt::format("{} cells round the bearing cannot show a film; "
                       "take {} or more",
                       nt, kFewestRound));
  }
  if (nt * nz > kMostCells) {
    refuse(reader, "model.grid",
           fmt::format("{} x {} cells are more than memory holds; 800 x "
                       "100 is fine already",
                       nt, nz));
  }
}

}  // namespace

void refuse(const Reader& reader, const std::string& key, const std::string& problem) {
  throw error_at(reader.place(key), key, problem);
}

void warn(Case& subject, const Reader& reader, const std::string& key, const std::string& problem) {
  subject.warnings.emplace_back(error_at(reader.place(key), key, problem).what());
}

void judge_case(Case& subject, const Reader& reader) {
  judge_bearing(subject, reader);
  judge_speed(subject, reader);
  judge_load(subject, reader);
  judge_tilt(subject, reader);
  judge_supplies(subject, reader);
  judge_laws(subject, reader);
  judge_density(subject, reader);
  judge_temperatures(subject, reader);
  judge_surfaces(subject, reader);
  judge_solids(subject, reader);
  judge_grid(subject, reader);
}

}  // namespace shellback::app
