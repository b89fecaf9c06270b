#include "bearing/columns.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/density.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

bool thins(const rheology::Oil& oil) {
  return !std::holds_alternative<rheology::NoShearThinning>(oil.shear);
}

namespace {

/// Integrals (1) of all columns for the viscosities in `c.eta`.
void integrate(const CrossFilmNodes& gl, OilColumns& c, Field& g) {
  const int n = gl.n;
  for (std::size_t cell = 0; cell < c.g0.size(); ++cell) {
    const double* eta = &c.eta[cell * n];
    double f[64];
    double g0 = 0.0;
    double g1 = 0.0;
    for (int k = 0; k < n; ++k) {
      f[k] = gl.v[k] / eta[k];
      g0 += f[k];
      g1 += f[k] * gl.s[k];
    }
    const double centre = g1 / g0;
    double g2 = 0.0;
    for (int k = 0; k < n; ++k) g2 += f[k] * (gl.s[k] - centre) * (gl.s[k] - centre);
    c.g0[cell] = g0;
    c.centre[cell] = centre;
    g[cell] = g2;
  }
}

/// |tau| of (2) at every node.
void stresses(const CrossFilmNodes& gl, double speed, const Field& h, const Field& gx,
              const Field& gz, const OilColumns& c, std::vector<double>& tau) {
  const int n = gl.n;
  for (std::size_t cell = 0; cell < h.size(); ++cell) {
    // Surfaces pressed together on the way to a solution leave no gap: at rest nothing shears it.
    const double couette = speed == 0.0 ? 0.0 : speed / (h[cell] * c.g0[cell]);
    for (int k = 0; k < n; ++k) {
      const double arm = h[cell] * (gl.s[k] - c.centre[cell]);
      const double x = gx[cell] * arm + couette;
      const double z = gz[cell] * arm;
      tau[cell * n + k] = std::sqrt(x * x + z * z);
    }
  }
}

}  // namespace

OilColumns uniform_columns(int cells, int nodes, double T) {
  OilColumns c;
  const auto size = static_cast<std::size_t>(cells) * nodes;
  c.T.assign(size, T);
  c.eta.assign(size, 0.0);
  c.g0.assign(cells, 0.0);
  c.centre.assign(cells, 0.5);
  c.T_mean.assign(cells, T);
  return c;
}

void update_columns(const rheology::Oil& oil, const CrossFilmNodes& gl, double speed,
                    const Field& h, const std::vector<int>& supply, const fluid::FilmState& state,
                    const Field& gx, const Field& gz, double tolerance, OilColumns& c,
                    fluid::FilmCoefficients& out) {
  const int n = gl.n;
  const std::size_t cells = h.size();
  EXPECTS(c.T.size() == cells * n);
  std::vector<double> p(cells * n), low(cells * n);
  std::vector<double> T = c.T;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::fill_n(&p[cell * n], n, state.p[cell]);
    double mean = 0.0;
    for (int k = 0; k < n; ++k) mean += gl.w[k] * c.T[cell * n + k];
    const bool mixed = supply[cell] >= 0;  // between walls that are as warm as they are
    c.T_mean[cell] = mixed ? c.T[cell * n + 1] : mean;
    if (mixed || gl.one_temperature) std::fill_n(&T[cell * n], n, c.T_mean[cell]);
  }
  rheology::viscosity(oil, T, p, low);
  out.fluidity.resize(cells);
  out.chi.resize(cells);
  out.alpha.resize(cells);
  out.density.resize(cells);
  out.compressibility.resize(cells);
  c.mismatch = 0.0;
  if (thins(oil)) {
    if (c.eta.front() <= 0.0) c.eta = low;
    std::vector<double> tau(cells * n), before;
    for (int k = 0; k == 0 || (k < kMostIterations && c.mismatch > tolerance); ++k) {
      before = c.eta;
      integrate(gl, c, out.fluidity);
      stresses(gl, speed, h, gx, gz, c, tau);
      rheology::shear_thinned(oil, low, tau, c.eta, 1);  // the stresses are not final either
      c.mismatch = 0.0;
      for (std::size_t node = 0; node < tau.size(); ++node) {
        c.mismatch = larger(c.mismatch, std::abs(c.eta[node] / before[node] - 1.0));
      }
    }
  } else {
    c.eta = low;
  }
  integrate(gl, c, out.fluidity);
  rheology::pressure_slope(oil, c.T_mean, state.p, out.alpha);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    out.chi[cell] = 1.0 - c.centre[cell];
    const rheology::Density rho = rheology::density(oil, c.T_mean[cell], state.p[cell]);
    out.density[cell] = rho.rho;
    out.compressibility[cell] = rho.dp / rho.rho;
  }
}

std::vector<double> dissipation(const CrossFilmNodes& gl, double speed, const Field& h,
                                const Field& gx, const Field& gz, const OilColumns& c) {
  std::vector<double> phi(c.eta.size());
  stresses(gl, speed, h, gx, gz, c, phi);
  for (std::size_t k = 0; k < phi.size(); ++k) phi[k] *= phi[k] / c.eta[k];
  return phi;
}

VelocityProfiles velocity_profiles(const CrossFilmNodes& gl, const OilColumns& c) {
  const int n = gl.n;
  VelocityProfiles v{std::vector<double>(c.eta.size()), std::vector<double>(c.eta.size())};
  for (std::size_t cell = 0; cell < c.g0.size(); ++cell) {
    double couette_mean = 0.0;
    double poiseuille_mean = 0.0;
    double* u = &v.couette[cell * n];
    double* w = &v.poiseuille[cell * n];
    for (int k = 0; k < n; ++k) {
      double i0 = 0.0;
      double i1 = 0.0;
      for (int l = 0; l < n; ++l) {
        const double f = gl.Q[k * n + l] / c.eta[cell * n + l];
        i0 += f;
        i1 += f * gl.s[l];
      }
      u[k] = i0;
      w[k] = c.centre[cell] * i0 - i1;
      couette_mean += gl.w[k] * u[k];
      poiseuille_mean += gl.w[k] * w[k];
    }
    for (int k = 0; k < n; ++k) {
      u[k] /= couette_mean;
      w[k] /= poiseuille_mean;
    }
  }
  return v;
}

}  // namespace shellback::bearing
