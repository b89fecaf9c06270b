#include "app/case_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/constants.hpp"

namespace shellback::app {
namespace {

using namespace bearing;
using Json = nlohmann::ordered_json;

Json si(double value, const char* unit) {
  return {{"value", std::isfinite(value) ? Json(value) : Json(nullptr)}, {"unit", unit}};
}
Json degrees(double radians) { return si(radians * 180.0 / kPi, "deg"); }
Json plain(double value) { return si(value, "1"); }

Json bearing(const Bearing& b) {
  Json json{{"diameter", si(2.0 * b.radius, "m")},
            {"width", si(b.width, "m")},
            {"radial_clearance", si(b.radial_clearance, "m")},
            {"reference_temperature", si(b.reference_temperature, "K")}};
  if (b.profile) json["profile_points"] = {b.profile->phi.size(), b.profile->z.size()};
  if (b.shape) json["shape_points"] = {b.shape->phi.size(), b.shape->z.size()};
  const auto opening = [&](const char* key, const std::optional<EdgeOpening>& e) {
    if (e) json[key] = {{"depth", si(e->depth, "m")}, {"length", si(e->length, "m")}};
  };
  opening("edge_relief", b.edge_relief);
  opening("chamfer", b.chamfer);
  return json;
}

Json supply(const Supply& s) {
  const char* const kinds[] = {"hole", "axial_groove", "circumferential_groove", "drilling"};
  Json json{
      {"kind", kinds[static_cast<int>(s.kind)]}, {"angle", degrees(s.angle)}, {"z", si(s.z, "m")}};
  const bool drilling = s.kind == SupplyKind::drilling;
  if (is_round(s)) {
    json["diameter"] = si(s.diameter, "m");
  } else if (s.kind == SupplyKind::axial_groove) {
    json["arc"] = degrees(s.arc);
    json["length"] = si(s.length, "m");
  } else {
    json["extent"] = degrees(s.arc);
    json["width"] = si(s.length, "m");
  }
  if (!drilling) json["depth"] = si(s.depth, "m");
  json["pressure"] = si(s.pressure, "Pa");
  json["temperature"] = si(s.temperature, "K");
  if (!drilling) json["carry_over"] = plain(s.carry_over);
  if (const double* h = std::get_if<double>(&s.heat_transfer)) {
    if (!drilling) json["heat_transfer"] = si(*h, "W/(m2 K)");
  } else {
    json["heat_transfer"] = "channel";
  }
  if (s.vessel) {
    json["vessel_volume"] = si(s.vessel->volume, "m3");
    json["vessel_bulk_modulus"] = si(s.vessel->bulk_modulus, "Pa");
    json["open"] = {{"unit", "s"}, {"values", s.vessel->open}};
  }
  return json;
}

Json operation(const Operation& o) {
  Json json{{"speed", si(o.omega, "rad/s")}};
  if (const auto* load = std::get_if<LoadGiven>(&o.position)) {
    json["load"] = si(load->force, "N");
    json["load_angle"] = degrees(load->angle);
  } else {
    const auto& e = std::get<EccentricityGiven>(o.position);
    json["eccentricity_ratio"] = plain(e.ratio);
    json["attitude_angle"] = degrees(e.attitude);
    json["load_angle"] = degrees(e.load_angle);
  }
  if (const auto* tilt = std::get_if<TiltGiven>(&o.alignment)) {
    json["tilt"] = {{"about_x", degrees(tilt->about_x)}, {"about_y", degrees(tilt->about_y)}};
  } else {
    const auto& moment = std::get<MomentGiven>(o.alignment);
    json["moment"] = {{"about_x", si(moment.about_x, "N m")},
                      {"about_y", si(moment.about_y, "N m")}};
  }
  return json;
}

/// The rows as they were solved, in SI units, so that the cycle can be run again without its table.
Json load_cycle(const LoadCycle& cycle) {
  const auto column = [](const std::vector<double>& v, const char* unit) {
    return Json{{"unit", unit}, {"values", v}};
  };
  Json json{{"time", column(cycle.t, "s")},
            {"load_x", column(cycle.x, "N")},
            {"load_y", column(cycle.y, "N")}};
  if (!cycle.omega.empty()) json["speed"] = column(cycle.omega, "rad/s");
  if (cycle.repeats()) json["period"] = si(cycle.period, "s");
  json["interpolation"] =
      cycle.interpolation == LoadInterpolation::linear ? "linear" : "periodic_spline";
  json["journal_mass"] = si(cycle.journal_mass, "kg");
  if (cycle.step) json["step"] = si(*cycle.step, "s");
  if (!cycle.fields_at.empty()) json["fields_at"] = column(cycle.fields_at, "s");
  return json;
}

/// One law of the oil, by its alternative.
struct LawJson {
  Json operator()(const rheology::ConstantViscosity& l) const {
    return {{"law", "constant"}, {"eta", si(l.eta, "Pa s")}};
  }
  Json operator()(const rheology::Vogel& l) const {
    return {{"law", "vogel"}, {"A", si(l.A, "Pa s")}, {"B", si(l.B, "K")}, {"C", si(l.C, "K")}};
  }
  Json operator()(const rheology::ReynoldsSlope& l) const {
    return {{"law", "reynolds"},
            {"eta", si(l.eta, "Pa s")},
            {"at", si(l.at, "K")},
            {"beta", si(l.beta, "1/K")}};
  }
  Json operator()(const rheology::Walther& l) const {
    return {{"law", "walther"},    {"a", plain(l.a)},
            {"B", plain(l.B)},     {"rho", si(l.rho, "kg/m3")},
            {"at", si(l.at, "K")}, {"expansivity", si(l.expansivity, "1/K")}};
  }
  Json operator()(const rheology::NoPressureEffect& /*none*/) const { return {{"law", "none"}}; }
  Json operator()(const rheology::Barus& l) const {
    return {{"law", "barus"}, {"alpha", si(l.alpha, "1/Pa")}};
  }
  Json operator()(const rheology::Roelands& l) const {
    return {{"law", "roelands"}, {"Z", plain(l.Z)}};
  }
  Json operator()(const rheology::Houpert& l) const {
    return {
        {"law", "houpert"}, {"Z", plain(l.Z)}, {"beta", si(l.beta, "1/K")}, {"at", si(l.at, "K")}};
  }
  Json operator()(const rheology::NoShearThinning& /*none*/) const { return {{"law", "none"}}; }
  Json operator()(const rheology::Cross& l) const {
    return {{"law", "cross"}, {"r", plain(l.r)}, {"K", si(l.K, "s")}, {"m", plain(l.m)}};
  }
  Json operator()(const rheology::ConstantDensity& l) const {
    return {{"law", "constant"}, {"rho", si(l.rho, "kg/m3")}};
  }
  Json operator()(const rheology::DowsonHigginson& l) const {
    return {{"law", "dowson-higginson"},
            {"rho0", si(l.rho0, "kg/m3")},
            {"at", si(l.at, "K")},
            {"expansivity", si(l.expansivity, "1/K")},
            {"C1", si(1.0 / l.limit, "Pa")},  // rho0 (C1 + C2 p)/(C1 + p)
            {"C2", plain(1.0 + l.rise / l.limit)}};
  }
  Json operator()(const rheology::ConstantConductivity& l) const {
    return {{"law", "constant"}, {"k", si(l.k, "W/(m K)")}};
  }
  Json operator()(const rheology::PressureConductivity& l) const {
    return {{"law", "pressure"},
            {"a", si(l.a, "W/(m K)")},
            {"b", si(l.b, "1/GPa")},
            {"c", si(l.c, "1/GPa")}};
  }
  Json operator()(const rheology::TemperatureConductivity& l) const {
    return {{"law", "temperature"},
            {"a", si(l.a, "W/(m K)")},
            {"b", si(l.b, "1/K")},
            {"s", plain(l.s)}};
  }
  Json operator()(const rheology::ConstantHeatCapacity& l) const {
    return {{"law", "constant"}, {"cp", si(l.cp, "J/(kg K)")}};
  }
  Json operator()(const rheology::TemperatureHeatCapacity& l) const {
    return {{"law", "temperature"},
            {"a", si(l.a, "J/(kg K)")},
            {"b", si(l.b, "J/(kg K2)")},
            {"s", plain(l.s)},
            {"n", plain(l.n)}};
  }
};

Json oil(const Case& c) {
  const rheology::Oil& o = c.oil;
  Json json{{"name", o.name}};
  if (c.oil_temperature) json["temperature"] = si(*c.oil_temperature, "K");
  json["viscosity"] = {{"temperature", std::visit(LawJson{}, o.temperature)},
                       {"pressure", std::visit(LawJson{}, o.pressure)},
                       {"shear", std::visit(LawJson{}, o.shear)}};
  json["density"] = std::visit(LawJson{}, o.density);
  json["conductivity"] = std::visit(LawJson{}, o.conductivity);
  json["heat_capacity"] = std::visit(LawJson{}, o.heat_capacity);
  return json;
}

Json material(const solid::Material& m) {
  Json json{{"name", m.name},
            {"conductivity", si(m.conductivity, "W/(m K)")},
            {"density", si(m.density, "kg/m3")},
            {"heat_capacity", si(m.heat_capacity, "J/(kg K)")},
            {"youngs_modulus", si(m.youngs_modulus, "Pa")},
            {"poisson_ratio", plain(m.poisson_ratio)},
            {"expansion", si(m.expansion, "1/K")},
            {"hardness", m.hardness > 0.0 ? si(m.hardness, "Pa") : Json(nullptr)}};
  if (m.limit_temperature > 0.0) json["limit_temperature"] = si(m.limit_temperature, "K");
  if (m.progression > 0.0) json["progression_rate"] = plain(m.progression);
  if (m.damping_ratio > 0.0) json["damping_ratio"] = si(m.damping_ratio, "s");
  return json;
}

Json shell(const Shell& s) {
  Json json{{"layers", Json::array()}};
  for (const ShellLayer& layer : s.layers) {
    json["layers"].push_back(
        {{"material", material(layer.material)}, {"thickness", si(layer.thickness, "m")}});
    if (layer.elasto_plastic) json["layers"].back()["elasto_plastic"] = true;
  }
  if (s.housing) {
    const char* const supports[] = {"held", "free", "clamped"};
    json["housing"] = {{"material", material(s.housing->material)},
                       {"outer_diameter", si(2.0 * s.housing->outer_radius, "m")},
                       {"support", supports[static_cast<int>(s.housing->support)]}};
    if (s.housing->joint_conductance > 0.0) {
      json["housing"]["joint_conductance"] = si(s.housing->joint_conductance, "W/(m2 K)");
    }
  }
  if (const auto* back = std::get_if<PrescribedBack>(&s.back)) {
    json["back"] = {{"temperature", si(back->temperature, "K")}};
  } else {
    const auto& open = std::get<ConvectiveBack>(s.back);
    json["back"] = {{"heat_transfer", si(open.heat_transfer, "W/(m2 K)")},
                    {"ambient", si(open.ambient, "K")}};
  }
  json["end_heat_transfer"] = si(s.end_heat_transfer, "W/(m2 K)");
  return json;
}

Json shaft(const Shaft& s) {
  Json json{{"material", material(s.material)},
            {"overhang", si(s.overhang, "m")},
            {"heat_transfer", si(s.heat_transfer, "W/(m2 K)")},
            {"ambient", si(s.ambient, "K")}};
  if (s.elastic_overhang) json["elastic_overhang"] = si(*s.elastic_overhang, "m");
  if (s.span) json["span"] = si(*s.span, "m");
  return json;
}

Json surface(const solid::RoughSurface& s) {
  return {{"roughness", si(s.roughness, "m")},
          {"orientation", plain(s.orientation)},
          {"summit_roughness", si(s.summit_roughness, "m")},
          {"summit_height", si(s.summit_height, "m")}};
}

Json friction_law(const solid::GenericFriction& f) {
  Json json{{"abrasive", plain(f.abrasive)},
            {"adhesive", plain(f.adhesive)},
            {"a", plain(f.a)},
            {"b", plain(f.b)},
            {"c", plain(f.c)},
            {"summit_radius", si(f.summit_radius, "m")}};
  if (f.L_s) {
    json["reference_length"] = si(*f.L_s, "m");
  } else {
    json["orientation"] = plain(f.orientation);
  }
  return json;
}

Json surfaces(const Surfaces& s) {
  Json json{{"shell", surface(s.shell)}, {"shaft", surface(s.shaft)}};
  if (s.flow_factors) {
    const fluid::FactorTable& t = *s.flow_factors;
    json["flow_factors"] = {{"table", t.name},
                            {"roughness", si(t.sigma, "m")},
                            {"h_over_sigma", t.H},
                            {"phi_x", t.phi_x},
                            {"phi_z", t.phi_z},
                            {"phi_s", t.phi_s},
                            {"phi_f", t.phi_f},
                            {"phi_fs", t.phi_fs},
                            {"average_gap", t.average_gap}};
    if (!t.phi_fp.empty()) json["flow_factors"]["phi_fp"] = t.phi_fp;
  }
  if (!s.contact) return json;
  const bool exact = s.contact->integral == solid::ContactIntegral::exact;
  const double hardness = s.contact->hardness;
  json["contact"] = {{"elastic_factor", plain(s.contact->elastic_factor)},
                     {"composite_modulus", si(s.contact->composite_modulus, "Pa")},
                     {"integral", exact ? "exact" : "power-law"}};
  if (hardness > 0.0) json["contact"]["hardness"] = si(hardness, "Pa");
  if (s.contact->friction_law) {
    json["contact"]["friction_law"] = friction_law(*s.contact->friction_law);
  } else {
    json["contact"]["friction"] = plain(s.contact->friction);
  }
  return json;
}

const char* spacing_name(const Model& m) {
  if (!m.axial_spacing) return "auto";
  return *m.axial_spacing == AxialSpacing::graded ? "graded" : "even";
}

Json model(const Model& m) {
  Json json{{"tier", to_string(m.tier)},
            {"tolerance", plain(m.tolerance)},
            {"grid", m.grid},
            {"axial_spacing", spacing_name(m)},
            {"film_nodes", m.film_nodes}};
  const auto add = [&](const char* key, const std::optional<bool>& on) {
    json[key] = on ? Json(*on) : Json("auto");  // the choice of the tier
  };
  add("pressure_dependence", m.switches.pressure_dependence);
  add("shear_thinning", m.switches.shear_thinning);
  add("flow_factors", m.switches.flow_factors);
  add("asperity_contact", m.switches.asperity_contact);
  add("elastic_deformation", m.switches.elastic_deformation);
  add("thermal_deformation", m.switches.thermal_deformation);
  json["cavitated_shear"] = m.cavitated_shear == CavitatedShear::filled ? "filled" : "full";
  json["edges"] = m.edges == Edges::flooded ? "flooded" : "dry";
  json["cavitation_pressure"] = si(m.cavitation_pressure, "Pa");
  json["equivalent_temperature"] = {{"kappa", plain(m.kappa)}};
  const char* const cavitation[] = {"active-set", "fischer-burmeister", "p-theta", "swift-stieber"};
  const char* const across[] = {"lobatto", "layers", "mean"};
  json["methods"] = {
      {"cavitation", cavitation[static_cast<int>(m.methods.cavitation)]},
      {"across", across[static_cast<int>(m.methods.across)]},
      {"elastic", m.methods.elastic == ElasticMethod::newton ? "newton" : "fixed-point"},
      {"transport", m.methods.transport == FillTransport::upwind ? "upwind" : "van-leer"}};
  if (m.methods.across == AcrossFilm::layers) json["methods"]["layers"] = m.methods.layers;
  if (m.methods.elastic != ElasticMethod::newton) {
    json["methods"]["relaxation"] = plain(m.methods.relaxation);
  }
  return json;
}

}  // namespace

nlohmann::ordered_json case_json(const Case& c) {
  Json json{{"bearing", bearing(c.bearing)}, {"supply", Json::array()}};
  for (const Supply& s : c.supplies) json["supply"].push_back(supply(s));
  json["operation"] = operation(c.operation);
  if (c.cycle) {
    json["operation"].erase("load");  // it is that of the cycle
    json["operation"].erase("load_angle");
    json["load_cycle"] = load_cycle(*c.cycle);
  }
  json["oil"] = oil(c);
  if (c.shell) json["shell"] = shell(*c.shell);
  if (c.shaft) json["shaft"] = shaft(*c.shaft);
  json["surfaces"] = surfaces(c.surfaces);
  json["model"] = model(c.model);
  return json;
}

nlohmann::ordered_json changes_json(const Case& c) {
  Json json = Json::array();
  for (const Change& change : c.changes) {
    json.push_back({{"key", change.key}, {"value", change.value}});
  }
  return json;
}

}  // namespace shellback::app
