#include "bearing/columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "core/lanes.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/density.hpp"
#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

namespace {

/// Whether every stress belongs to one shear rate.
[[maybe_unused]] bool stress_rises(const rheology::Oil& oil) {
  const auto* law = std::get_if<rheology::Cross>(&oil.shear);
  return law == nullptr || rheology::stress_is_monotone(*law);
}

/// Columns that are worked on together: their nodes stay in the first-level cache, and the loops
/// over them fill the vector unit [-].
constexpr std::size_t kBlock = 32;
constexpr std::size_t kLanes = kBlock / kLane;

/// A value of every column.
struct Row {
  Lane lane[kLanes];
  void fill(double x) { std::fill_n(data(), kBlock, x); }
  [[nodiscard]] double* data() { return reinterpret_cast<double*>(lane); }
  [[nodiscard]] const double* data() const { return reinterpret_cast<const double*>(lane); }
  [[nodiscard]] double& operator[](std::size_t i) { return data()[i]; }
  [[nodiscard]] double operator[](std::size_t i) const { return data()[i]; }
};

/// Some columns, node by node: a node of all of them stands in one row.
class ColumnBlock {
 public:
  ColumnBlock(const rheology::Oil& oil, const CrossFilmNodes& gl, double speed)
      : oil_(oil), gl_(gl), speed_(speed), eta_(gl.n), fluidity_(gl.n) {
    if (!rheology::thins(oil)) return;
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
      for (std::size_t l = 0; l < kLanes; ++l) {
        Lane& fluidity = fluidity_[k].lane[l];
        fluidity = gl_.v[k] / eta_[k].lane[l];
        g0_.lane[l] += fluidity;
        centre_.lane[l] += fluidity * gl_.s[k];
      }
    }
    for (std::size_t l = 0; l < kLanes; ++l) centre_.lane[l] /= g0_.lane[l];
    for (int k = 0; k < gl_.n; ++k) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        const Lane arm = gl_.s[k] - centre_.lane[l];
        g_.lane[l] += fluidity_[k].lane[l] * arm * arm;
      }
    }
  }

  /// What the flow of columns that thin() follows the slopes of pressure by (film_flux.hpp): (4)
  /// with r = 0 and tau changed by the slope; g is least at its centre, whose moves do not change
  /// it.
  void slopes(std::size_t cell, fluid::FilmCoefficients& out) const {
    Row around, along;
    for (std::size_t l = 0; l < kLanes; ++l) {
      Lane t11 = Lane{} + 1.0, t12{}, t21{}, t22 = t11, x1{}, x2{}, z1{};
      Lane by_drag{}, by_centre{}, by_x{}, by_z{};
      for (int k = 0; k < gl_.n; ++k) {
        const Lane slope = lanes(&slope_[k * kBlock])[l];
        Lane arm;
        from_centre(k, l, arm);
        const Lane part = fluidity_[k].lane[l] / g0_.lane[l] * slope;
        const Lane of_g = fluidity_[k].lane[l] * arm * arm / g_.lane[l] * slope;
        const Lane along_tau =  // z^2/tau^2
            1.0 - gx_.lane[l] * by_x_[k].lane[l] - by_drag_[k].lane[l];
        t11 -= part * by_drag_[k].lane[l];
        t12 -= part * by_centre_[k].lane[l];
        t21 += part * arm * by_drag_[k].lane[l];
        t22 += part * arm * by_centre_[k].lane[l];
        x1 += part * by_x_[k].lane[l];
        x2 -= part * arm * by_x_[k].lane[l];
        z1 += part * along_tau;
        by_drag -= of_g * by_drag_[k].lane[l];
        by_centre -= of_g * by_centre_[k].lane[l];
        by_x -= of_g * by_x_[k].lane[l];
        by_z -= of_g * along_tau;
      }
      const Lane over = 1.0 / (t11 * t22 - t12 * t21);
      const Lane drag = over * (x1 * t22 - x2 * t12);
      const Lane centre = over * (x2 * t11 - x1 * t21);
      around.lane[l] = gx_.lane[l] * (by_x + by_drag * drag + by_centre * centre);
      along.lane[l] = by_z + by_drag * z1 / t11;
      if (speed_ == 0.0) continue;
      around.lane[l] += speed_ * centre / (h_.lane[l] * h_.lane[l] * g_.lane[l]);
    }
    const std::size_t m = std::min(kBlock, out.thins_around.size() - cell);
    std::copy_n(around.data(), m, &out.thins_around[cell]);
    std::copy_n(along.data(), m, &out.thins_along[cell]);
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
    for (std::size_t l = 0; l < kLanes && speed_ != 0.0; ++l) {
      couette_.lane[l] = speed_ / (h_.lane[l] * g0_.lane[l]);
    }
    const Lane tiny = std::numeric_limits<double>::min() - Lane{};
    for (int k = 0; k < gl_.n; ++k) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        Lane arm;
        from_centre(k, l, arm);
        arm *= h_.lane[l];
        const Lane x = gx_.lane[l] * arm + couette_.lane[l];
        const Lane z = gz_.lane[l] * arm;
        Lane square = x * x + z * z;
        const Lane over = 1.0 / (square < tiny ? tiny : square);
        take_root(square);
        lanes(&rate_[k * kBlock])[l] = square / eta_[k].lane[l];
        by_drag_[k].lane[l] = couette_.lane[l] * x * over;
        by_centre_[k].lane[l] = -h_.lane[l] * (gx_.lane[l] * x + gz_.lane[l] * z) * over;
        by_x_[k].lane[l] = arm * x * over;
      }
    }
  }

  /// s - centre [-]. What round-off leaves of it where they are one would be seen by laws whose
  /// slope at rest has no bound (Cross, m < 1).
  void from_centre(int k, std::size_t l, Lane& arm) const {
    constexpr double kNoArm = 1e-12;
    arm = gl_.s[k] - centre_.lane[l];
    arm = ((arm < kNoArm) & (arm > -kNoArm)) ? Lane{} : arm;
  }

  /// (4): the system of a column's two unknowns, then the step of its nodes; the largest of all.
  double step() {
    Row largest;
    for (std::size_t l = 0; l < kLanes; ++l) {
      Lane t11 = Lane{} + 1.0, t12{}, t21{}, t22 = t11, t1{}, t2{};
      for (int k = 0; k < gl_.n; ++k) {
        Lane& off = lanes(&rate_[k * kBlock])[l];
        Lane& slope = lanes(&slope_[k * kBlock])[l];
        off = low_[k].lane[l] * lanes(&factor_[k * kBlock])[l] / eta_[k].lane[l] - 1.0;
        Lane arm;
        from_centre(k, l, arm);
        const Lane part = fluidity_[k].lane[l] / g0_.lane[l];
        arm *= part;
        const Lane over = 1.0 / (1.0 + slope);
        t1 += part * over * off;
        t2 -= arm * over * off;
        slope *= over;
        t11 -= part * slope * by_drag_[k].lane[l];
        t12 -= part * slope * by_centre_[k].lane[l];
        t21 += arm * slope * by_drag_[k].lane[l];
        t22 += arm * slope * by_centre_[k].lane[l];
      }
      const Lane over = 1.0 / (t11 * t22 - t12 * t21);
      take(l, over * (t1 * t22 - t2 * t12), over * (t2 * t11 - t1 * t21), largest.lane[l]);
    }
    return shellback::largest({largest.data(), kBlock});
  }

  /// The step of the nodes, of the changes of ln tau by drag and of the centre.
  void take(std::size_t l, const Lane& drag, const Lane& centre, Lane& largest) {
    constexpr double kNearlyAll = 0.9;
    Lane longest{};
    largest = Lane{};
    for (int k = 0; k < gl_.n; ++k) {
      const Lane off = lanes(&rate_[k * kBlock])[l];
      // off/(1 + slope) = off (1 - slope/(1 + slope))
      Lane step = off + lanes(&slope_[k * kBlock])[l] *
                            (by_drag_[k].lane[l] * drag + by_centre_[k].lane[l] * centre - off);
      step_[k].lane[l] = step;
      take_magnitude(step);
      take_larger(longest, step);
    }
    const auto all = longest >= kNearlyAll;  // a step that is no number is taken, and seen
    for (int k = 0; k < gl_.n; ++k) {
      const Lane& step = step_[k].lane[l];
      Lane& eta = eta_[k].lane[l];
      eta = all ? low_[k].lane[l] * lanes(&factor_[k * kBlock])[l] : eta * (1.0 + step);
      Lane change = all ? lanes(&rate_[k * kBlock])[l] : step;
      take_magnitude(change);
      take_larger(largest, change);
    }
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

/// Whether no column has more than one temperature.
bool have_one_temperature(const CrossFilmNodes& gl, const std::vector<double>& T) {
  if (gl.one_temperature) return true;
  for (std::size_t k = 0; k < T.size(); k += gl.n) {
    for (int l = 1; l < gl.n; ++l) {
      if (T[k + l] != T[k]) return false;
    }
  }
  return true;
}

/// Viscosity at low shear rates at every node; takes the columns' mean temperatures. `even`: no
/// column has another one.
std::vector<double> viscosity_at_rest(const rheology::Oil& oil, const CrossFilmNodes& gl,
                                      const std::vector<int>& supply, const Field& p, bool even,
                                      OilColumns& c) {
  const auto n = static_cast<std::size_t>(gl.n);
  const std::size_t cells = p.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double* T = &c.T[cell * n];
    const bool mixed = supply[cell] >= 0;  // between walls that are as warm as they are
    c.T_mean[cell] = mixed ? T[1] : gl.mean(T);
  }
  std::vector<double> low(cells * n);
  if (even) {
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
  const bool even = have_one_temperature(gl, c.T);
  const std::vector<double> low = viscosity_at_rest(oil, gl, supply, state.p, even, c);
  out.fluidity.resize(cells);
  out.chi.resize(cells);
  out.alpha.resize(cells);
  out.density.resize(cells);
  out.compressibility.resize(cells);
  c.mismatch = 0.0;
  const bool thinning = rheology::thins(oil);
  out.thins_around.resize(thinning ? cells : 0);
  out.thins_along.resize(thinning ? cells : 0);
  if (!thinning) c.eta = low;
  const bool constant = !thinning && even;  // all across
  for (std::size_t cell = 0; constant && cell < cells; ++cell) {
    const double fluidity = 1.0 / low[cell * n];
    c.g0[cell] = fluidity;
    c.centre[cell] = 0.5;
    out.fluidity[cell] = fluidity / 12.0;
  }
  ColumnBlock block(oil, gl, speed);
  for (std::size_t cell = 0; !constant && cell < cells; cell += kBlock) {
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
