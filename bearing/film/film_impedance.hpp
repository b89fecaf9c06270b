#pragma once
/// Force of a solved film on a journal that swings about its place with any frequency nu.
///
/// With x(t) = dx exp(i nu t) and m the change of the oil in the cells [kg], the linearised film
/// (bearing/film/film_response.hpp) answers
///   u = R dx + S (i nu m),   m = m_0 dx + L S (i nu m)                               (1)
/// R, m_0: answer and content of a slow displacement; S: answer to stored oil; L: content that an
/// answer brings, rho {theta hT' d + hT theta} per area. So (I - i nu L S) m = m_0 dx, one operator
/// for all frequencies: Arnoldi's basis V of its Krylov space from m_0 (L S V_k = V_k+1 H) is built
/// once, and a frequency costs a least-squares problem of a few unknowns,
///   min | |m_0| e_1 - (I - i nu H) y |,   F = -Z dx,  Z = Z_0 - i nu (force of S V) y.   (2)
/// The force of Z's terms of order 0 and 1 in nu is that of K and C in bearing/coefficients.hpp.
/// Held at the solved state what is held there. The space has as many dimensions as the oil needs
/// that travels through the cavitated film within a swing. Source: shifted systems by one Krylov
/// space [textbook]; (1) is ours.
#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

#include "bearing/film/film_response.hpp"
#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Force and moment by one component of the journal's motion.
class ForceByMotion {
 public:
  /// Until (1) is met within `tolerance` of m_0 for all frequencies up to `highest` [rad/s]; 0: the
  /// terms of order 0 and 1 alone. `component`: as of gap_slope in fluid/gap.hpp.
  ForceByMotion(LinearFilm& film, const Solution& s, int component, double highest,
                double tolerance);
  [[nodiscard]] bool converged() const { return converged_; }
  /// Of a slow motion, per displacement [N/m], and per velocity [N s/m]; with their sign: -K, -C.
  [[nodiscard]] const fluid::Wrench& by_place() const { return by_place_; }
  [[nodiscard]] fluid::Wrench by_velocity() const;
  /// At the frequency nu [rad/s], per displacement: -Z.
  [[nodiscard]] std::array<std::complex<double>, 4> at(double nu) const;
  /// Part of by_velocity() that comes from the content of cavitated cells, to a few per cent.
  [[nodiscard]] const fluid::Wrench& by_cavitated() const { return by_cavitated_; }

 private:
  struct Combination {
    Eigen::VectorXcd y;
    double left = 0.0;  ///< of (1), over m_0 [-]
  };
  [[nodiscard]] Combination combination(double nu) const;

  fluid::Wrench by_place_{};
  std::vector<fluid::Wrench> by_basis_;  ///< force of S V
  Eigen::MatrixXd H_;                    ///< one row more than columns [s]
  double size_ = 0.0;                    ///< |m_0|
  fluid::Wrench by_cavitated_{};
  bool converged_ = true;
};

}  // namespace shellback::bearing
