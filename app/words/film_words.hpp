#pragma once
/// Endings of film, journal position and elastic surfaces, by our methods and by those of others.
#include <fmt/format.h>

#include <cmath>

#include "app/words/told.hpp"

namespace shellback::app::told {

/// As messages have always called them.
inline const char* name_of(FieldName field) {
  switch (field) {
    case FieldName::journal_position:
      return "journal position";
    case FieldName::thermal_deformation:
      return "thermal growth";
    case FieldName::elastic_opening:
      return "elastic opening";
    case FieldName::gap:
      return "gap";
    case FieldName::film_pressure:
      return "film pressure";
    case FieldName::fill_ratio:
      return "fill ratio";
    case FieldName::film_temperature:
      return "film temperature";
    case FieldName::viscosity:
      return "viscosity";
    case FieldName::contact_pressure:
      return "contact pressure";
    case FieldName::film_flow:
      return "film flow";
  }
  return "unknown field";
}

inline Told told(const ending::NotANumber& e, const About&) {
  return {fmt::format("not a number in {}", name_of(e.field)),
          e.other_method
              ? "this method has diverged: take model.methods.cavitation = \"active-set\""
              : "report it with the case: this is a defect of the program, not of the bearing"};
}

inline Told told(const ending::BeyondPressureBound& e, const About&) {
  constexpr double kPrinted = 1e-3;  // of the load: closer the two print alike [-]
  const bool alike = std::abs(e.carried - e.wanted) < kPrinted * e.wanted;
  const std::string carried = alike ? "the journal's pressures balance it"
                                    : fmt::format("it carries about {:.4g} N", e.carried);
  return {
      fmt::format("the film cannot carry {:.4g} N: {}, {} the pressure grows without bound ({})",
                  e.wanted, carried, alike ? "but somewhere" : "then", kBoundOfPressure),
      kBeyondBarus};
}

inline Told told(const ending::GapClosed& e, const About&) {
  const auto takes = [](double x) { return x < 0.0 ? "takes" : "gives"; };
  std::string reason = fmt::format(
      "{}smooth surfaces touch before a film is sought: the smallest gap is {:.3g} um; position "
      "and profile leave {:.3g} um there",
      e.by_growth() ? "the clearance is used up by thermal growth: " : "", e.h * 1e6,
      e.by_position * 1e6);
  if (!std::isnan(e.by_heat)) {
    reason +=
        fmt::format(", thermal growth {} {:.3g} um", takes(e.by_heat), std::abs(e.by_heat) * 1e6);
  }
  if (!std::isnan(e.by_elasticity)) {
    reason += fmt::format(", elasticity {} {:.3g} um", takes(e.by_elasticity),
                          std::abs(e.by_elasticity) * 1e6);
  }
  if (e.across <= 0.0) {
    reason += fmt::format(
        "; across the bearing {:.3g} um are missing, which no position of the journal mends",
        -e.across * 1e6);
  }
  return {reason,
          e.by_growth()
              ? "a larger clearance, less heat, or shell and housing that can grow outwards"
              : "give roughness and contact data, a larger clearance, or a smaller eccentricity "
                "or tilt"};
}

inline Told told(const ending::SurfacesInterlocked& e, const About&) {
  return {fmt::format("no oil passes where the surfaces lie in each other: the nominal gap is "
                      "{:.3g} um, {:.0f} times the roughness below zero",
                      e.h * 1e6, -e.h / e.sigma),
          "lower the load, the given eccentricity ratio or the tilt, or give a larger clearance or "
          "stiffer contact"};
}

inline Told told(const ending::FilmUnsettled& e, const About&) {
  return {
      fmt::format("film and journal position did not settle in {} Newton iterations (film {:.1e}, "
                  "load {:.1e}, elasticity {:.1e}, smallest gap {:.3g} um{})",
                  e.iterations, e.film, e.load, e.elastic, e.h_min * 1e6,
                  e.no_film ? ", less than a molecule of oil" : ""),
      e.no_film ? kContactElseElastic : kFinerElseLess};
}

/// Smooth surfaces with less than a molecule of oil between: physics, or what cells make of it.
inline const char* no_film(bool by_cells) {
  return by_cells ? "no film was found that carries the load" : "no film carries the load";
}

inline const char* kept_by_cells(bool by_cells) {
  return by_cells ? "; between rigid surfaces no cells resolve such a film, and coarse ones let it "
                    "carry too little"
                  : "";
}

inline std::string cure_of_no_film(bool by_cells) {
  return fmt::format("{}{}", by_cells ? "finer cells around (model.grid); or " : "",
                     kContactElseElastic);
}

inline Told told(const ending::NotAtRest& e, const About&) {
  if (e.steps == 0) {
    return {
        fmt::format("{}: the journal is pressed towards the shell until less than a molecule of "
                    "oil is left ({:.3g} um){}",
                    no_film(e.by_cells), e.h_min * 1e6, kept_by_cells(e.by_cells)),
        cure_of_no_film(e.by_cells)};
  }
  return {fmt::format("the journal did not come to rest in {} steps in time (smallest gap {:.3g} "
                      "um)",
                      e.steps, e.h_min * 1e6),
          kFinerElseLess};
}

inline Told told(const ending::PositionUnsettled& e, const About&) {
  return {fmt::format("the journal found no position for its load (load residual {:.1e}, smallest "
                      "gap {:.3g} um)",
                      e.load, e.h_min * 1e6),
          "use the active-set method, a finer grid or a lower load"};
}

inline Told told(const ending::FixedPointDiverged& e, const About& a) {
  const std::string how = a.verdict.cause.empty()
                              ? fmt::format("the mismatch grows to {:.2g} gaps", e.mismatch)
                              : fmt::format("round {} has no film: {}", e.round, a.within.reason);
  return {fmt::format("the fixed point between film and displacement diverges: {} (elastic opening "
                      "{:.3g} um, smallest gap {:.3g} um)",
                      how, e.opening * 1e6, e.h_min * 1e6),
          "take elastic = \"newton\", a smaller relaxation, or a lower load"};
}

inline Told told(const ending::FixedPointUnsettled& e, const About&) {
  return {fmt::format("the fixed point between film and displacement did not settle in {} rounds "
                      "(mismatch {:.1e} of the smallest gap, relaxation {:.2g})",
                      e.rounds, e.mismatch, e.relaxation),
          "take elastic = \"newton\""};
}

}  // namespace shellback::app::told
