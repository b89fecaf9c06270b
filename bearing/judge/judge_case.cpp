#include "bearing/judge/judge_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/bearing.hpp"
#include "bearing/case_limits.hpp"
#include "bearing/judge/judge_parts.hpp"
#include "bearing/shown.hpp"
#include "core/contract.hpp"
#include "solid/boundary_friction.hpp"

namespace shellback::bearing {
namespace {

void judge_bearing(const Bearing& b, Findings& to) {
  const BearingLimits& limits = kBearingLimits;
  compare(to, "bearing.diameter", b.radius, limits.radius,
          fmt::format("the diameter is {}", shown(2.0 * b.radius, "mm")), "check its unit");
  compare(to, "bearing.radial_clearance", b.radial_clearance / b.radius, limits.clearance,
          fmt::format("the radial clearance is {:.3g} of the radius ({} of {})",
                      b.radial_clearance / b.radius, shown(b.radial_clearance, "mm"),
                      shown(b.radius, "mm")),
          "usual is 0.0005 to 0.003; check its unit, and that it is the radial, not the "
          "diametral clearance");
  const double aspect = b.width / (2.0 * b.radius);
  compare(to, "bearing.width", aspect, limits.aspect,
          fmt::format("the width is {:.3g} of the diameter", aspect), "check the units of both");
  judge_bore(b, to);
}

void judge_speed(const Case& c, Findings& to) {
  const double omega = c.operation.omega;
  if (omega == 0.0 && std::holds_alternative<LoadGiven>(c.operation.position)) {
    to.refuse("operation.speed",
              "at zero speed no film forms that could carry the load: the journal rests on the "
              "shell, and there is no steady lubricated state to solve for",
              "give a speed");
  } else if (omega == 0.0) {
    to.refuse("operation.speed",
              "at zero speed nothing is dragged into the film: there is neither friction nor a "
              "hydrodynamic pressure to solve for",
              "give a speed");
  }
  const double u = std::abs(omega) * c.bearing.radius;
  compare(to, "operation.speed", u, kBearingLimits.surface_speed,
          fmt::format("the surface speed is {:.4g} m/s", u), "check the unit of the speed");
}

void judge_load(const Case& c, Findings& to) {
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  if (load == nullptr) return;
  const double specific = load->force / (2.0 * c.bearing.radius * c.bearing.width);
  compare(to, "operation.load", specific, kBearingLimits.specific_load,
          fmt::format("the load over the projected area is {}", shown(specific, "MPa")),
          "check the unit of the load");
}

void judge_moment(const Case& c, Findings& to) {
  const auto* moment = std::get_if<MomentGiven>(&c.operation.alignment);
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  if (moment == nullptr) return;
  if (load == nullptr) {
    to.refuse("operation.moment",
              "the journal's place is given, and the tilt that a moment makes is only sought along "
              "with the place that a load makes",
              "give operation.tilt, or operation.load in place of eccentricity_ratio");
    return;
  }
  const double lever = std::hypot(moment->about_x, moment->about_y) / load->force;
  compare(to, "operation.moment", lever / c.bearing.width, kBearingLimits.lever,
          fmt::format("the moment is that of the load {} beside mid-width, {:.3g} of the width",
                      shown(lever, "mm"), lever / c.bearing.width),
          "beyond 0.5 the load's line lies outside the bearing; check the unit of the moment");
}

void judge_tilt(const Case& c, Findings& to) {
  const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment);
  if (tilt == nullptr) return;
  const Bearing& b = c.bearing;
  const double edge = std::hypot(tilt->about_x, tilt->about_y) * 0.5 * b.width / b.radial_clearance;
  compare(to, "operation.tilt", edge, kBearingLimits.edge_tilt,
          fmt::format("the tilt moves the journal by {:.3g} radial clearances at the edges", edge),
          "above 1 it cannot fit into the bearing; check the unit (mrad?)");
}

/// A measured table of factors against the surfaces that are to take it.
void judge_flow_factors(const Case& c, Findings& to) {
  const Surfaces& s = c.surfaces;
  if (!s.flow_factors) return;
  const double sigma = combined_roughness(s);
  const char* const key = "surfaces.flow_factors";
  if (const auto fault = fluid::fault_of(*s.flow_factors); !fault.problem.empty()) {
    to.refuse(key, fault.problem, "write the table anew with shellback surface");
    return;
  }
  if (sigma <= 0.0) {
    to.refuse(key, "there are flow factors, but both surfaces are smooth",
              "give surfaces.shell or surfaces.shaft its roughness");
    return;
  }
  if (c.model.switches.flow_factors == false) {
    to.suspect(key, "the table is not used: model.flow_factors is false");
  }
  constexpr double kAlike = 0.2;  // of the roughness: what maps of one surface differ by [-]
  const double measured = s.flow_factors->sigma;
  if (measured > 0.0 && std::abs(measured / sigma - 1.0) > kAlike) {
    to.suspect(key,
               fmt::format("the factors were measured on a roughness of {:.3g} um and are used, "
                           "by h/sigma, for a combined one of {:.3g} um",
                           1e6 * measured, 1e6 * sigma),
               "is it the same surface?");
  }
  // Far off phi_x - 1 = 3 (1 - 3/(1 + gamma))/H^2 (Tripp 1983, textbook): -6 to 3; ten times that.
  constexpr double kFarFromWall = 60.0;
  const double H = s.flow_factors->H.back();
  const double phi = std::max(std::abs(s.flow_factors->phi_x.back() - 1.0),
                              std::abs(s.flow_factors->phi_z.back() - 1.0));
  if (phi * H * H > kFarFromWall) {
    to.suspect(
        key,
        fmt::format("at its largest gap, h/sigma = {:.3g}, a factor of pressure flow differs "
                    "from 1 by {:.3g}; those of any surface come to 1 far from the wall",
                    H, phi),
        "write the table anew with shellback surface");
  }
  if (s.shell.roughness > 0.0 && s.shaft.roughness > 0.0) {
    to.suspect(key,
               "both surfaces are rough and take the factors of one table: its texture is taken "
               "for both",
               "exact only if one is smooth against the other");
  }
}

/// 1/E* = (1 - nu^2)/E of the shell's first layer and of the shaft (Hertz, textbook).
void judge_composite_modulus(const Case& c, Findings& to) {
  if (!c.shell || c.shell->layers.empty() || !c.shaft) return;
  const auto compliance = [](const solid::Material& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  };
  const double of_materials =
      1.0 / (compliance(c.shell->layers.front().material) + compliance(c.shaft->material));
  const double apart = c.surfaces.contact->composite_modulus / of_materials;
  if (std::max(apart, 1.0 / apart) <= kBearingLimits.modulus_apart) return;
  to.suspect(
      "surfaces.contact.composite_modulus",
      fmt::format("it is {}, and that of the shell's first layer on the shaft {}",
                  shown(c.surfaces.contact->composite_modulus, "GPa"), shown(of_materials, "GPa")),
      fmt::format("for these materials write \"{}\"", shown(of_materials, "GPa")));
}

/// Summits of a surface that another one touches.
void judge_summits(const solid::RoughSurface& s, const std::string& key, Findings& to) {
  if (s.roughness <= 0.0) return;
  if (s.summit_roughness <= 0.0) {
    to.suspect(key + ".summit_roughness",
               fmt::format("the surface is rough ({}) and touches another one, but its summits are "
                           "not given and count as none",
                           shown(s.roughness, "um")),
               "give summit_roughness and summit_height (shellback surface finds them on a height "
               "map)");
    return;
  }
  const double spread = s.summit_roughness / s.roughness;
  compare(to, key + ".summit_roughness", spread, kBearingLimits.summit_spread,
          fmt::format("the heights of the summits scatter by {:.3g} roughnesses", spread),
          "check the units of both");
  const double over = s.summit_height / s.roughness;
  compare(to, key + ".summit_height", over, kBearingLimits.summit_height,
          fmt::format("the summits lie {:.3g} roughnesses above the mean plane", over),
          "check the units of both");
}

void judge_surfaces(const Case& c, Findings& to) {
  const Surfaces& s = c.surfaces;
  const double sigma = combined_roughness(s);
  const auto judge_roughness = [&](const char* key, double combined) {
    const double part = combined / c.bearing.radial_clearance;
    compare(to, key, part, kBearingLimits.roughness,
            fmt::format("the combined roughness is {:.3g} of the radial clearance", part),
            "check the units");
  };
  judge_roughness("surfaces", sigma);
  if (c.running_in && c.running_in->worn) {
    judge_roughness("running_in.worn",
                    std::hypot(c.running_in->worn->roughness, s.shaft.roughness));
  }
  const double summits = std::hypot(s.shell.summit_roughness, s.shaft.summit_roughness);
  if (s.contact && summits <= 0.0) {
    to.refuse("surfaces.contact",
              "asperity contact needs summit_roughness (and summit_height) of surfaces.shell and "
              "surfaces.shaft");
  }
  if (s.contact && summits > 0.0) {
    judge_summits(s.shell, "surfaces.shell", to);
    judge_summits(s.shaft, "surfaces.shaft", to);
    if (c.running_in && c.running_in->worn)
      judge_summits(*c.running_in->worn, "running_in.worn", to);
    compare(to, "surfaces.contact.elastic_factor", s.contact->elastic_factor,
            kBearingLimits.elastic_factor,
            fmt::format("the elastic factor is {:.3g}", s.contact->elastic_factor),
            "engineering surfaces have 1e-4 to 5e-3");
  }
  if (s.contact && s.contact->friction_law && summits > 0.0) {
    const double density = solid::summit_product(s.contact->elastic_factor, summits,
                                                 s.contact->friction_law->summit_radius);
    compare(to, "surfaces.contact.friction_law.summit_radius", density,
            kBearingLimits.summit_product,
            fmt::format("summit density times radius times summit roughness is {:.3g}", density),
            "it follows from elastic_factor, the summit roughnesses and this radius");
  }
  if (s.contact && summits > 0.0) judge_composite_modulus(c, to);
  const Switches& on = c.model.switches;
  if (on.asperity_contact.value_or(false) && !s.contact) {
    to.refuse("model.asperity_contact", "contact is switched on without [surfaces] contact",
              "give it, or write \"auto\"");
  }
  if (on.flow_factors.value_or(false) && sigma <= 0.0) {
    to.refuse("model.flow_factors", "flow factors are switched on, but both surfaces are smooth",
              "give [surfaces], or write \"auto\"");
  }
  judge_flow_factors(c, to);
}

/// The smallest of finer grids that tells the supplies apart; none within memory: they touch.
std::optional<std::array<int, 2>> grid_for_supplies(const Case& c) {
  std::array<int, 2> grid = c.model.grid;
  while (!holds_supplies(c, grid)) {
    grid = {grid[0] + (grid[0] + 9) / 10, grid[1] + (grid[1] + 9) / 10};
    if (grid[0] * grid[1] > kBearingLimits.most_cells) return std::nullopt;
  }
  return grid;
}

void judge_grid(const Case& c, const std::vector<Tier>& tiers, Findings& to) {
  const auto [nt, nz] = c.model.grid;
  if (nt < kBearingLimits.fewest_cells_round) {
    to.refuse("model.grid", fmt::format("{} cells round the bearing cannot show a film", nt),
              fmt::format("take {} or more", kBearingLimits.fewest_cells_round));
  }
  if (nt * nz > kBearingLimits.most_cells) {
    to.refuse("model.grid", fmt::format("{} x {} cells are more than memory holds", nt, nz),
              "800 x 100 is fine already");
    return;
  }
  const auto takes_it = [&](Tier tier) {  // else another grid, or none
    const bool chosen = !c.model.grid_given && tier == Tier::automatic;
    return !chosen && tier != Tier::estimate;
  };
  if (std::none_of(tiers.begin(), tiers.end(), takes_it)) return;
  const int most = most_axial_cells(c);
  if (nz > most) {
    const bool symmetric = symmetric_about_mid_width(c);
    to.refuse("model.grid",
              fmt::format("{} cells along the axis are more than can be solved{}", nz,
                          symmetric ? "" : " (the bearing is not symmetric about mid-width)"),
              fmt::format("take {} or fewer; axial_spacing = \"graded\" gathers them at the edges",
                          most));
    return;
  }
  if (to.refused() || holds_supplies(c, c.model.grid)) return;
  const auto finer = grid_for_supplies(c);
  const std::string apart = "supplies whose edges lie further apart";
  to.refuse("model.grid",
            fmt::format("{} x {} cells cannot have a face at every edge of the supplies", nt, nz),
            finer ? fmt::format("take {} x {}, or {}", (*finer)[0], (*finer)[1], apart)
                  : "give " + apart);
}

}  // namespace

std::vector<Finding> judge(const Case& c, const std::vector<Tier>& tiers) {
  Findings to;
  judge_values(c, to);
  if (to.refused()) return to.list;
  judge_bearing(c.bearing, to);
  if (c.cycle) {
    judge_cycle(c, to);
  } else {
    judge_speed(c, to);
    judge_load(c, to);
    judge_moment(c, to);
  }
  judge_tilt(c, to);
  judge_supplies(c, to);
  judge_oil(c, to);
  judge_surfaces(c, to);
  judge_solids(c, tiers, to);
  judge_grid(c, tiers, to);
  for (const Tier tier : tiers) {
    if (auto lack = lack_for(c, tier)) to.list.push_back(std::move(*lack));
  }
  return to.list;
}

std::vector<Finding> judge(const Case& c) { return judge(c, {c.model.tier}); }

void expect_solvable(const Case& c) {
  for (const Finding& f : judge(c)) {
    if (f.refused()) throw InputError(f.key, f.words());
  }
}

}  // namespace shellback::bearing
