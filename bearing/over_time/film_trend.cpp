#include "bearing/over_time/film_trend.hpp"

namespace shellback::bearing {

FilmTrend::FilmTrend(const State& from, const State& to, double dt) {
  p.assign(to.film.p.size(), 0.0);
  theta = p;
  for (std::size_t c = 0; c < p.size(); ++c) {
    if (from.film.full[c] != to.film.full[c]) continue;
    p[c] = (to.film.p[c] - from.film.p[c]) / dt;
    theta[c] = (to.film.theta[c] - from.film.theta[c]) / dt;
  }
  elastic = to.elastic;
  for (std::size_t c = 0; c < elastic.size(); ++c) {
    elastic[c] = (to.elastic[c] - from.elastic[c]) / dt;
  }
  for (int k = 0; k < 4; ++k) q[k] = (to.position.q[k] - from.position.q[k]) / dt;
}

}  // namespace shellback::bearing
