#include "app/reading/sections.hpp"

namespace shellback::app {
namespace {

using solid::ContactIntegral;

solid::GenericFriction read_friction_law(const Section& section) {
  section.only(
      {"abrasive", "adhesive", "a", "b", "c", "summit_radius", "orientation", "reference_length"},
      "surfaces.contact.friction_law");
  solid::GenericFriction law;
  law.abrasive = section.quantity("abrasive", kNumber, kUpToOne);
  law.adhesive = section.quantity("adhesive", kNumber, kUpToOne);
  law.a = section.quantity("a", kNumber.such_as("10.0"), kAboveOne);
  law.b = section.quantity("b", kNumber.such_as("300.0"), kNotNegative);
  law.c = section.quantity("c", kNumber.such_as("2000.0"), kNotNegative);
  law.summit_radius = section.quantity("summit_radius", kLength.such_as("10 um"), kPositive);
  law.L_s = section.maybe_quantity("reference_length", kLength.such_as("1 um"), kPositive);
  if (law.L_s && section.has("orientation")) {
    section.fail("orientation",
                 "orientation only serves to find reference_length, which is given; keep one");
  }
  if (!law.L_s) {
    law.orientation = section.quantity_or(
        "orientation", kNumber.such_as("1.0"), law.orientation,
        "surfaces.contact.friction_law: the summits' orientation is taken as 1", kPositive);
  }
  return law;
}

solid::ContactParameters read_contact(const Section& section) {
  section.only(
      {"elastic_factor", "composite_modulus", "friction", "friction_law", "integral", "hardness"},
      "surfaces.contact");
  solid::ContactParameters contact;
  contact.elastic_factor = section.quantity("elastic_factor", kNumber.such_as("0.001"), kPositive);
  contact.composite_modulus =
      section.quantity("composite_modulus", kPressure.such_as("50 GPa"), kPositive);
  if (const auto law = section.maybe_section("friction_law")) {
    if (section.has("friction")) {
      section.fail("friction",
                   "friction is a constant coefficient and friction_law a law; keep one of them");
    }
    contact.friction_law = read_friction_law(*law);
  } else {
    contact.friction = section.quantity("friction", kNumber, kUpToOne);
  }
  contact.hardness =
      section.quantity_or("hardness", kPressure.such_as("150 MPa"), 0.0, "", kPositive);
  if (section.has("integral")) {
    contact.integral = section.choice<ContactIntegral>(
        "integral", {{"exact", ContactIntegral::exact}, {"power-law", ContactIntegral::power_law}});
  }
  return contact;
}

}  // namespace

solid::RoughSurface read_surface(const Section& section, const std::string& what, bool by_table) {
  section.only({"roughness", "orientation", "summit_roughness", "summit_height"}, what);
  solid::RoughSurface surface;
  surface.roughness = section.quantity("roughness", kLength.such_as("0.3 um"), kNotNegative);
  surface.orientation = section.quantity_or(
      "orientation", kNumber.such_as("1.0"), surface.orientation,
      by_table ? "" : what + ": the roughness is taken as isotropic (orientation = 1)", kPositive);
  if (by_table && section.has("orientation")) {
    section.warn("orientation",
                 "is not used: the flow between the surfaces is that of surfaces.flow_factors");
  }
  surface.summit_roughness =
      section.quantity_or("summit_roughness", kLength.such_as("0.3 um"), 0.0, "", kNotNegative);
  surface.summit_height = section.quantity_or("summit_height", kLength.such_as("0.3 um"), 0.0, "");
  return surface;
}

bearing::Surfaces read_surfaces(const Section& file) {
  bearing::Surfaces surfaces;
  const auto section = file.maybe_section("surfaces");
  if (!section) {
    file.assume(
        "the surfaces are taken as smooth, without asperity contact ([surfaces] is not "
        "given)");
    return surfaces;
  }
  section->only({"shell", "shaft", "contact", "flow_factors"}, "[surfaces]");
  if (const auto shell = section->maybe_section("shell")) {
    surfaces.shell = read_surface(*shell, "surfaces.shell", section->has("flow_factors"));
  } else {
    section->assume("the shell's surface is taken as smooth (surfaces.shell is not given)");
  }
  if (const auto shaft = section->maybe_section("shaft")) {
    surfaces.shaft = read_surface(*shaft, "surfaces.shaft", section->has("flow_factors"));
  } else {
    section->assume("the shaft's surface is taken as smooth (surfaces.shaft is not given)");
  }
  if (const auto contact = section->maybe_section("contact")) {
    surfaces.contact = read_contact(*contact);
  } else {
    section->assume("asperity contact is left out (surfaces.contact is not given)");
  }
  if (section->has("flow_factors")) {
    surfaces.flow_factors = read_flow_factors(table_beside(*section, "flow_factors"));
    surfaces.flow_factors->name = section->text("flow_factors");
  }
  return surfaces;
}

}  // namespace shellback::app
