#include <fmt/format.h>

#include <algorithm>

#include "bearing/judge/judge_parts.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/shown.hpp"
#include "solid/surface_layer.hpp"

namespace shellback::bearing {
namespace {

/// Possible and usual range of one property of solids, foams to diamond.
struct Property {
  const char* key;
  double solid::Material::*member;
  Limits limits;
  const char* unit;
};
constexpr Property kProperties[] = {
    {"conductivity", &solid::Material::conductivity, {1e-3, 0.1, 1000.0, 1e4}, "W/(m K)"},
    {"density", &solid::Material::density, {1.0, 500.0, 25000.0, 5e4}, "kg/m3"},
    {"heat_capacity", &solid::Material::heat_capacity, {5.0, 50.0, 5000.0, 2e4}, "J/(kg K)"},
    {"youngs_modulus", &solid::Material::youngs_modulus, {1e4, 1e6, 1.2e12, 1e14}, "GPa"},
    {"expansion", &solid::Material::expansion, {0.0, 1e-7, 5e-4, 2e-3}, "1/K"},
};

void judge_material(const solid::Material& material, const std::string& path, Findings& to) {
  for (const Property& p : kProperties) {
    const double value = material.*p.member;
    if (value == 0.0 && p.limits.least == 0.0) continue;  // what does not expand
    if (value < p.limits.least || value > p.limits.most) {
      to.refuse(path + "." + p.key, shown(value, p.unit) + " is no solid's", "check the unit");
    } else if (value < p.limits.usual_least || value > p.limits.usual_most) {
      to.suspect(path + "." + p.key, shown(value, p.unit) + " is unusual for a solid",
                 "check the unit");
    }
  }
  if (material.hardness > 0.0) {
    compare(to, path + ".hardness", material.hardness, kBearingLimits.hardness,
            fmt::format("the hardness is {}", shown(material.hardness, "MPa")), "check the unit");
  }
}

void judge_housing(const Housing& housing, double R, double inner, Findings& to) {
  judge_material(housing.material, "shell.housing.material", to);
  if (housing.outer_radius <= inner) {
    to.refuse("shell.housing.outer_diameter",
              fmt::format("{} does not enclose the shell, whose layers are {} thick and whose back "
                          "has a diameter of {}",
                          shown(2.0 * housing.outer_radius, "mm"), shown(inner - R, "mm"),
                          shown(2.0 * inner, "mm")),
              "check it, and the thickness of shell.layers");
  }
  if (housing.outer_radius > kBearingLimits.housing_most * R) {
    to.refuse("shell.housing.outer_diameter",
              fmt::format("it is more than {:.0f} times the bearing's diameter",
                          kBearingLimits.housing_most),
              "check the unit");
  } else if (housing.outer_radius > kBearingLimits.housing_usual * R) {
    to.suspect("shell.housing.outer_diameter",
               fmt::format("it is {:.3g} times the bearing's diameter, which is unusual",
                           housing.outer_radius / R),
               "check the unit");
  }
  if (housing.joint_conductance != 0.0) {  // else a perfect joint
    compare(to, "shell.housing.joint_conductance", housing.joint_conductance, kBearingLimits.joint,
            fmt::format("the joint conducts {}", shown(housing.joint_conductance, "W/(m2 K)")),
            "check the unit");
  }
}

/// Of a wall to what surrounds it [W/(m2 K)].
void judge_wall_heat(const std::string& key, double heat_transfer, Findings& to) {
  compare(to, key, heat_transfer, kBearingLimits.wall_heat,
          fmt::format("the heat transfer is {}", shown(heat_transfer, "W/(m2 K)")),
          "check the unit");
}

/// An elasto-plastic layer is a coating whose law is known.
void judge_coating(const Case& c, Findings& to) {
  const std::vector<ShellLayer>& layers = c.shell->layers;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (!layers[k].elasto_plastic) continue;
    const std::string path = fmt::format("shell.layers.{}", k);
    const solid::Material& m = layers[k].material;
    if (k > 0) {
      to.refuse(path + ".elasto_plastic", "only the first layer, which the film touches, can be so",
                "take it out, or put the layer first");
    }
    if (layers.size() < 2 && !c.shell->housing) {
      to.refuse(path + ".elasto_plastic", "the layer lies on nothing", "give what it lies on");
    }
    if (!(m.hardness > 0.0) || !(m.damping_ratio > 0.0)) {
      to.refuse(path + ".material",
                fmt::format("an elasto-plastic layer needs the {} of its material",
                            m.hardness > 0.0 ? "damping_ratio" : "hardness"),
                "give hardness (for example \"120 MPa\") and damping_ratio (\"1e-4 s\")");
    }
    const solid::SurfaceLayer law{layers[k].thickness, m.youngs_modulus, m.hardness, m.progression,
                                  m.damping_ratio};
    if (m.hardness > 0.0 && m.youngs_modulus > 0.0 && layers[k].thickness > 0.0 &&
        law.yield_depth() > kMostFlown * law.thickness) {
      to.refuse(path + ".material",
                fmt::format("before it flows at {} the layer would be pressed to less than half of "
                            "its thickness",
                            shown(m.hardness, "MPa")),
                "check hardness and youngs_modulus");
    }
    if (c.cycle && m.damping_ratio > c.cycle->length()) {
      to.suspect(path + ".material",
                 fmt::format("damping_ratio is {:.3g} s, and the load cycle takes {:.3g} s: the "
                             "layer hardly begins to flow",
                             m.damping_ratio, c.cycle->length()),
                 "check the unit");
    }
    if (layers[k].thickness > c.bearing.radial_clearance) {
      to.refuse(
          path + ".thickness",
          fmt::format("an elasto-plastic layer of {} is thicker than the clearance of {} "
                      "allows: its columns yield each for itself",
                      shown(layers[k].thickness, "um"), shown(c.bearing.radial_clearance, "um")),
          "take elasto_plastic out: the layer is then elastic as a whole");
    }
    if (c.model.coefficients) {
      to.refuse("model.coefficients",
                "stiffness and damping of a bearing with an elasto-plastic layer depend on the "
                "frequency",
                "take model.coefficients or elasto_plastic out");
    }
  }
}

/// The load over its projected area is less than the largest pressure.
void judge_strain(const Case& c, Findings& to) {
  const double force = c.cycle ? LoadCourse(*c.cycle, c.operation.omega).largest_load()
                       : std::holds_alternative<LoadGiven>(c.operation.position)
                           ? std::get<LoadGiven>(c.operation.position).force
                           : 0.0;
  const double specific = force / (2.0 * c.bearing.radius * c.bearing.width);
  for (std::size_t k = 0; k < c.shell->layers.size(); ++k) {
    if (c.shell->layers[k].elasto_plastic) continue;  // it has a law of its own
    const double strain = specific * solid::confined_compliance(c.shell->layers[k].material);
    if (strain <= kBearingLimits.strain_usual) continue;
    const std::string what = fmt::format(
        "under the load over its projected area, {}, the layer is compressed by {:.3g} % of its "
        "thickness",
        shown(specific, "MPa"), 100.0 * strain);
    const std::string key = fmt::format("shell.layers.{}.material", k);
    if (strain > kBearingLimits.strain_most) {
      to.refuse(key, what, "check the unit of its youngs_modulus, and the load");
    } else {
      to.suspect(key, what + ": the law of small strains errs",
                 "check the unit of its youngs_modulus");
    }
  }
}

void judge_shell(const Shell& shell, double R, Findings& to) {
  double thickness = 0.0;
  for (std::size_t k = 0; k < shell.layers.size(); ++k) {
    const std::string path = fmt::format("shell.layers.{}", k);
    thickness += shell.layers[k].thickness;
    judge_material(shell.layers[k].material, path + ".material", to);
    compare(to, path + ".thickness", shell.layers[k].thickness, kBearingLimits.layer,
            fmt::format("the layer is {} thick", shown(shell.layers[k].thickness, "um")),
            "check the unit");
    if (thickness > kBearingLimits.wall_most * R) {
      to.refuse(path + ".thickness",
                fmt::format("the layers are {} thick on a bore of radius {}",
                            shown(thickness, "mm"), shown(R, "mm")),
                "check the unit");
    }
  }
  judge_wall_heat("shell.end_heat_transfer", shell.end_heat_transfer, to);
  const auto* back = std::get_if<ConvectiveBack>(&shell.back);
  if (back != nullptr) judge_wall_heat("shell.back.heat_transfer", back->heat_transfer, to);
  if (shell.housing) {
    judge_housing(*shell.housing, R, R + thickness, to);
  } else {
    compare(
        to, "shell.layers", thickness / R, kBearingLimits.free_wall,
        fmt::format("no housing holds the shell, and its wall of {} on a radius of {} is a foil",
                    shown(thickness, "um"), shown(R, "mm")),
        "give shell.housing, or check the unit of the thickness");
  }
}

/// A length of at most `most` radii R [m].
void refuse_longer(const char* key, double length, double most, double R, Findings& to) {
  if (length > most * R) {
    to.refuse(key, fmt::format("it is more than {:.0f} diameters", 0.5 * most), "check the unit");
  }
}

/// The supports stand beside the bearing, and the shaft is a shaft.
void judge_span(const Case& c, bool elastic, Findings& to) {
  if (!c.shaft->span) return;
  if (!elastic) {
    to.suspect("shaft.span", "surfaces are rigid in this tier: the shaft does not bend",
               "tier tehd, or model.elastic_deformation = true");
  }
  const double span = *c.shaft->span;
  if (span < c.bearing.width) {
    to.refuse("shaft.span",
              fmt::format("supports {} apart stand inside the bearing, which is {} wide",
                          shown(span, "mm"), shown(c.bearing.width, "mm")),
              "give the distance between the middles of the supports on either side");
  }
  refuse_longer("shaft.span", span, kBearingLimits.overhang_most, c.bearing.radius, to);
}

/// A length of shaft beyond the bearing, at most `most` radii [m].
void judge_overhang(const char* key, double length, double most, double R, Findings& to) {
  refuse_longer(key, length, most, R, to);
  if (length > 0.0 && length < kBearingLimits.overhang_least * R) {
    to.refuse(key, "it is less than a ten-thousandth of the radius", "give 0, or check the unit");
  }
}

}  // namespace

void judge_solids(const Case& c, const std::vector<Tier>& tiers, Findings& to) {
  const double R = c.bearing.radius;
  if (c.shell) judge_shell(*c.shell, R, to);
  const bool gives_way = std::any_of(tiers.begin(), tiers.end(), [](Tier tier) {
    return tier == Tier::tehd || tier == Tier::automatic;
  });
  const bool elastic = c.model.switches.elastic_deformation.value_or(gives_way);
  if (c.shell && elastic) judge_strain(c, to);
  if (c.shell) judge_coating(c, to);
  if (!c.shaft) return;
  judge_material(c.shaft->material, "shaft.material", to);
  judge_wall_heat("shaft.heat_transfer", c.shaft->heat_transfer, to);
  judge_overhang("shaft.overhang", c.shaft->overhang, kBearingLimits.overhang_most, R, to);
  judge_overhang("shaft.elastic_overhang", c.shaft->elastic_overhang.value_or(0.0),
                 kBearingLimits.elastic_overhang_most, R, to);
  judge_span(c, elastic, to);
}

}  // namespace shellback::bearing
