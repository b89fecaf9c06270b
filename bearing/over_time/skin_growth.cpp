#include "bearing/over_time/skin_growth.hpp"

#include <array>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::bearing {
namespace {

/// Mean around and first harmonic.
struct Around {
  double mean = 0.0, cosine = 0.0, sine = 0.0;
  void add(double part, double phi, double x) {
    mean += part * x;
    cosine += 2.0 * part * std::cos(phi) * x;
    sine += 2.0 * part * std::sin(phi) * x;
  }
  [[nodiscard]] double first(double phi) const {
    return cosine * std::cos(phi) + sine * std::sin(phi);
  }
};

/// 2 a^2/(b^2 - a^2) of shell and housing; 0: held from outside.
double ring_factor(const Case& c) {
  double b = c.bearing.radius;
  for (const ShellLayer& l : c.shell->layers) b += l.thickness;
  if (c.shell->housing) {
    if (c.shell->housing->support == HousingSupport::clamped) return 0.0;
    b = c.shell->housing->outer_radius;
  }
  const double a = c.bearing.radius;
  return 2.0 * a * a / (b * b - a * a);
}

}  // namespace

thermal::SkinLayer skin_of_shell(const solid::Material& m, double thickness,
                                 const solid::Material& back) {
  const double nu = m.poisson_ratio, stiffer = m.youngs_modulus / back.youngs_modulus;
  return {thickness,
          m.conductivity,
          m.density * m.heat_capacity,
          (1.0 + nu) / (1.0 - nu) * m.expansion,
          stiffer / (1.0 - nu) * m.expansion,
          stiffer * m.expansion};
}

thermal::SkinLayer skin_of_shaft(const solid::Material& m, double radius) {
  return {radius, m.conductivity, m.density * m.heat_capacity, 0.0, 0.0, m.expansion};
}

Field narrowed_by_shell(const BearingModel& model, const std::vector<thermal::SkinGrowth>& skins) {
  const FilmGrid& g = model.domain.grid;
  const double nu = wall_layers(model.input).material.back().poisson_ratio;
  const double local = (1.0 - 2.0 * nu) * (1.0 + nu), ring = ring_factor(model.input);
  Field narrower(skins.size());
  for (int j = 0; j < g.nz; ++j) {
    Around push, stretch;
    for (int i = 0; i < g.nt; ++i) {
      const thermal::SkinGrowth& s = skins[g.index(i, j)];
      const double part = g.dphi[i] / (2.0 * kPi);
      push.add(part, g.phi[i], s.push);
      stretch.add(part, g.phi[i], s.stretch);
    }
    for (int i = 0; i < g.nt; ++i) {
      const thermal::SkinGrowth& s = skins[g.index(i, j)];
      narrower[g.index(i, j)] = s.own + local * s.push -
                                (local + 0.5 * (1.0 + nu)) * push.first(g.phi[i]) -
                                (local + 1.0 + nu) * push.mean - ring * stretch.mean;
    }
  }
  return narrower;
}

double narrowed_by_shaft(const thermal::SkinGrowth& skin) { return 2.0 * skin.stretch; }

}  // namespace shellback::bearing
