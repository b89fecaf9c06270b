#include "bearing/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/density.hpp"
#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

bool thins(const rheology::Oil& oil) {
  return !std::holds_alternative<rheology::NoShearThinning>(oil.shear);
}

namespace {

/// Whether every stress belongs to one shear rate.
[[maybe_unused]] bool stress_rises(const rheology::Oil& oil) {
  const auto* law = std::get_if<rheology::Cross>(&oil.shear);
  return law == nullptr || rheology::stress_is_monotone(*law);
}

/// Columns that are worked on together: their nodes stay in the first-level cache, and the loops
/// over them fill the vector unit [-].
constexpr std::size_t kBlock = 32;

/// A value of every column.
using Row = std::array<double, kBlock>;

/// Some columns, node by node: a node of all of them stands in one row.
class ColumnBlock {
 public:
  ColumnBlock(const rheology::Oil& oil, const CrossFilmNodes& gl, double speed)
      : oil_(oil), gl_(gl), speed_(speed), eta_(gl.n), fluidity_(gl.n) {
    if (!thins(oil)) return;
    for (auto* rows : {&low_, &by_drag_, &by_centre_, &by_x_, &step_}) rows->resize(gl.n);
    for (auto* rows : {&rate_, &factor_, &slope_}) rows->resize(gl.n * kBlock);
  }

  /// The columns from `cell` on; behind the last one stands the last again.
  void read(std::size_t cell, const OilColumns& c, const Field& h, const Field& gx,
            const Field& gz) {
    const auto n = static_cast<std::size_t>(gl_.n);
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::size_t from = std::min(cell + i, h.size() - 1);
      for (std::size_t k = 0; k < n; ++k) eta_[k][i] = c.eta[from * n + k];
      h_[i] = h[from];
      gx_[i] = gx[from];
      gz_[i] = gz[from];
    }
  }

  /// Viscosities that belong to their stresses (3), from these at low rates; the largest relative
  /// change of the last step.
  double thin(std::size_t cell, const std::vector<double>& low, double tolerance) {
    const auto n = static_cast<std::size_t>(gl_.n);
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::size_t from = std::min((cell + i) * n, low.size() - n);
      for (std::size_t k = 0; k < n; ++k) {
        low_[k][i] = low[from + k];
        if (!(eta_[k][i] > 0.0)) eta_[k][i] = low_[k][i];  // none yet, or what was no number
      }
    }
    double change = 0.0;
    for (int k = 0; k == 0 || (k < kMostIterations && change > tolerance); ++k) {
      integrate();
      shear();
      rheology::shear_factors(oil_, rate_, factor_, slope_);
      change = step();
    }
    return change;
  }

  /// Integrals (1).
  void integrate() {
    g0_.fill(0.0);
    centre_.fill(0.0);
    g_.fill(0.0);
    for (int k = 0; k < gl_.n; ++k) {
      const double v = gl_.v[k], s = gl_.s[k];
      for (std::size_t i = 0; i < kBlock; ++i) {
        fluidity_[k][i] = v / eta_[k][i];
        g0_[i] += fluidity_[k][i];
        centre_[i] += fluidity_[k][i] * s;
      }
    }
    for (std::size_t i = 0; i < kBlock; ++i) centre_[i] /= g0_[i];
    for (int k = 0; k < gl_.n; ++k) {
      const double s = gl_.s[k];
      for (std::size_t i = 0; i < kBlock; ++i) {
        g_[i] += fluidity_[k][i] * (s - centre_[i]) * (s - centre_[i]);
      }
    }
  }

  /// What the flow of columns that thin() follows the slopes of pressure by (film_flux.hpp): (4)
  /// with r = 0 and tau changed by the slope; g is least at its centre, whose moves do not change
  /// it.
  void slopes(std::size_t cell, fluid::FilmCoefficients& out) const {
    Row t11, t12{}, t21{}, t22, x1{}, x2{}, z1{}, by_drag{}, by_centre{}, by_x{}, by_z{};
    t11.fill(1.0);
    t22.fill(1.0);
    for (int k = 0; k < gl_.n; ++k) {
      const double* slope = &slope_[k * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        const double arm = from_centre(k, i);
        const double part = fluidity_[k][i] / g0_[i] * slope[i];
        const double of_g = fluidity_[k][i] * arm * arm / g_[i] * slope[i];
        const double along = -(gx_[i] * by_x_[k][i] + by_drag_[k][i] - 1.0);  // z^2/tau^2
        t11[i] -= part * by_drag_[k][i];
        t12[i] -= part * by_centre_[k][i];
        t21[i] += part * arm * by_drag_[k][i];
        t22[i] += part * arm * by_centre_[k][i];
        x1[i] += part * by_x_[k][i];
        x2[i] -= part * arm * by_x_[k][i];
        z1[i] += part * along;
        by_drag[i] -= of_g * by_drag_[k][i];
        by_centre[i] -= of_g * by_centre_[k][i];
        by_x[i] -= of_g * by_x_[k][i];
        by_z[i] -= of_g * along;
      }
    }
    const std::size_t m = std::min(kBlock, out.thins_around.size() - cell);
    for (std::size_t i = 0; i < m; ++i) {
      const double over = 1.0 / (t11[i] * t22[i] - t12[i] * t21[i]);
      const double drag = over * (x1[i] * t22[i] - x2[i] * t12[i]);
      const double centre = over * (x2[i] * t11[i] - x1[i] * t21[i]);
      const double of_g = by_x[i] + by_drag[i] * drag + by_centre[i] * centre;
      const double carried = speed_ == 0.0 ? 0.0 : speed_ * centre / (h_[i] * h_[i] * g_[i]);
      out.thins_around[cell + i] = gx_[i] * of_g + carried;
      out.thins_along[cell + i] = by_z[i] + by_drag[i] * z1[i] / t11[i];
    }
  }

  void write(std::size_t cell, OilColumns& c, Field& g) const {
    const auto n = static_cast<std::size_t>(gl_.n);
    const std::size_t m = std::min(kBlock, g.size() - cell);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < n; ++k) c.eta[(cell + i) * n + k] = eta_[k][i];
      c.g0[cell + i] = g0_[i];
      c.centre[cell + i] = centre_[i];
      g[cell + i] = g_[i];
    }
  }

 private:
  /// Shear rates of (2), and what (4) has of their stresses.
  void shear() {
    couette_.fill(0.0);  // surfaces pressed together leave no gap: at rest nothing shears it
    if (speed_ != 0.0) {
      for (std::size_t i = 0; i < kBlock; ++i) couette_[i] = speed_ / (h_[i] * g0_[i]);
    }
    for (int k = 0; k < gl_.n; ++k) {
      double* rate = &rate_[k * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        const double arm = h_[i] * from_centre(k, i);
        const double x = gx_[i] * arm + couette_[i];
        const double z = gz_[i] * arm;
        const double square = x * x + z * z;
        const double over = 1.0 / std::max(square, std::numeric_limits<double>::min());
        rate[i] = std::sqrt(square) / eta_[k][i];
        by_drag_[k][i] = couette_[i] * x * over;
        by_centre_[k][i] = -h_[i] * (gx_[i] * x + gz_[i] * z) * over;
        by_x_[k][i] = arm * x * over;
      }
    }
  }

  /// s - centre [-]. What round-off leaves of it where they are one would be seen by laws whose
  /// slope at rest has no bound (Cross, m < 1).
  [[nodiscard]] double from_centre(int k, std::size_t i) const {
    constexpr double kNoArm = 1e-12;
    const double arm = gl_.s[k] - centre_[i];
    return std::abs(arm) < kNoArm ? 0.0 : arm;
  }

  /// (4): the system of a column's two unknowns, then the step of its nodes; the largest of all.
  double step() {
    Row t11, t12{}, t21{}, t22, t1{}, t2{};
    t11.fill(1.0);
    t22.fill(1.0);
    for (int k = 0; k < gl_.n; ++k) {
      double* off = &rate_[k * kBlock];
      double* slope = &slope_[k * kBlock];
      const double* factor = &factor_[k * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        off[i] = low_[k][i] * factor[i] / eta_[k][i] - 1.0;
        const double part = fluidity_[k][i] / g0_[i];
        const double arm = part * from_centre(k, i);
        const double over = 1.0 / (1.0 + slope[i]);
        t1[i] += part * over * off[i];
        t2[i] -= arm * over * off[i];
        slope[i] *= over;
        t11[i] -= part * slope[i] * by_drag_[k][i];
        t12[i] -= part * slope[i] * by_centre_[k][i];
        t21[i] += arm * slope[i] * by_drag_[k][i];
        t22[i] += arm * slope[i] * by_centre_[k][i];
      }
    }
    for (std::size_t i = 0; i < kBlock; ++i) {
      const double over = 1.0 / (t11[i] * t22[i] - t12[i] * t21[i]);
      const double drag = over * (t1[i] * t22[i] - t2[i] * t12[i]);
      t2[i] = over * (t2[i] * t11[i] - t1[i] * t21[i]);
      t1[i] = drag;
    }
    return take(t1, t2);
  }

  /// Of the changes of ln tau by drag and of the centre.
  double take(const Row& drag, const Row& centre) {
    constexpr double kNearlyAll = 0.9;
    Row longest{}, largest{};
    for (int k = 0; k < gl_.n; ++k) {
      const double* off = &rate_[k * kBlock];
      const double* slope = &slope_[k * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        // off/(1 + slope) = off (1 - slope/(1 + slope))
        step_[k][i] =
            off[i] + slope[i] * (by_drag_[k][i] * drag[i] + by_centre_[k][i] * centre[i] - off[i]);
        longest[i] = larger(longest[i], std::abs(step_[k][i]));
      }
    }
    for (int k = 0; k < gl_.n; ++k) {
      const double* off = &rate_[k * kBlock];
      const double* factor = &factor_[k * kBlock];
      for (std::size_t i = 0; i < kBlock; ++i) {
        const bool all = longest[i] >= kNearlyAll;  // a step that is no number is taken, and seen
        eta_[k][i] = all ? low_[k][i] * factor[i] : eta_[k][i] * (1.0 + step_[k][i]);
        largest[i] = larger(largest[i], std::abs(all ? off[i] : step_[k][i]));
      }
    }
    return shellback::largest(largest);
  }

  const rheology::Oil& oil_;
  const CrossFilmNodes& gl_;
  double speed_;
  std::vector<Row> eta_, low_, fluidity_, by_drag_, by_centre_, by_x_, step_;
  std::vector<double> rate_, factor_, slope_;
  Row h_{}, gx_{}, gz_{}, g0_{}, centre_{}, g_{}, couette_{};
};

/// |tau| of (2) at every node.
void stresses(const CrossFilmNodes& gl, double speed, const Field& h, const Field& gx,
              const Field& gz, const OilColumns& c, std::vector<double>& tau) {
  const int n = gl.n;
  for (std::size_t cell = 0; cell < h.size(); ++cell) {
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

namespace {

/// Viscosity at low shear rates at every node; takes the columns' mean temperatures.
std::vector<double> viscosity_at_rest(const rheology::Oil& oil, const CrossFilmNodes& gl,
                                      const std::vector<int>& supply, const Field& p,
                                      OilColumns& c) {
  const auto n = static_cast<std::size_t>(gl.n);
  const std::size_t cells = p.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    double mean = 0.0;
    for (std::size_t k = 0; k < n; ++k) mean += gl.w[k] * c.T[cell * n + k];
    const bool mixed = supply[cell] >= 0;  // between walls that are as warm as they are
    c.T_mean[cell] = mixed ? c.T[cell * n + 1] : mean;
  }
  std::vector<double> low(cells * n);
  if (gl.one_temperature) {
    Field one(cells);
    rheology::viscosity(oil, c.T_mean, p, one);
    for (std::size_t cell = 0; cell < cells; ++cell) std::fill_n(&low[cell * n], n, one[cell]);
    return low;
  }
  std::vector<double> T = c.T, at(cells * n);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::fill_n(&at[cell * n], n, p[cell]);
    if (supply[cell] >= 0) std::fill_n(&T[cell * n], n, c.T_mean[cell]);
  }
  rheology::viscosity(oil, T, at, low);
  return low;
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
  EXPECTS(stress_rises(oil));  // judge_oil.cpp refuses others
  const std::vector<double> low = viscosity_at_rest(oil, gl, supply, state.p, c);
  out.fluidity.resize(cells);
  out.chi.resize(cells);
  out.alpha.resize(cells);
  out.density.resize(cells);
  out.compressibility.resize(cells);
  c.mismatch = 0.0;
  const bool thinning = thins(oil);
  out.thins_around.resize(thinning ? cells : 0);
  out.thins_along.resize(thinning ? cells : 0);
  if (!thinning) c.eta = low;
  const bool even = !thinning && gl.one_temperature;  // one viscosity all across
  for (std::size_t cell = 0; even && cell < cells; ++cell) {
    const double fluidity = 1.0 / low[cell * n];
    c.g0[cell] = fluidity;
    c.centre[cell] = 0.5;
    out.fluidity[cell] = fluidity / 12.0;
  }
  ColumnBlock block(oil, gl, speed);
  for (std::size_t cell = 0; !even && cell < cells; cell += kBlock) {
    block.read(cell, c, h, gx, gz);
    if (thinning) c.mismatch = larger(c.mismatch, block.thin(cell, low, tolerance));
    block.integrate();
    if (thinning) block.slopes(cell, out);
    block.write(cell, c, out.fluidity);
  }
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
