#include "bearing/over_time/drillings.hpp"

#include <cmath>

namespace shellback::bearing {

Drillings::Drillings(const BearingModel& model, const LoadCourse& course) : course_(course) {
  const auto& patches = model.supply.patches;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    if (!patches[k].moving) continue;
    of_patch_.push_back(static_cast<int>(k));
    begun_.push_back(model.input.supplies[k].angle);
  }
}

void Drillings::take(const BearingModel& model, const FilmEquilibrium& film) {
  fluid::GapTransport gap;
  fluid::gap_transport(model.domain.rough, film.gap.cell, gap);
  conductance_ = film.oil.density;
  for (std::size_t c = 0; c < conductance_.size(); ++c) {
    conductance_[c] *= std::sqrt(gap.h3_x[c] * gap.h3_z[c]) * film.oil.fluidity[c];
  }
}

void Drillings::place(double t, fluid::FilmScene& scene) const {
  const double turned = course_.turned(t);
  for (std::size_t k = 0; k < of_patch_.size(); ++k) {
    scene.supply.patches[of_patch_[k]].phi = begun_[k] + turned;
  }
  fluid::place_mouths(scene.grid, conductance_, scene.supply);
}

std::vector<note::MouthWidened> Drillings::widened(const fluid::FilmScene& scene) const {
  std::vector<note::MouthWidened> all;
  const double least = fluid::cell_diagonal(scene.grid);
  for (const int k : of_patch_) {
    const double diameter = scene.supply.patches[k].length;
    if (diameter < least) all.push_back({k, diameter, least});
  }
  return all;
}

}  // namespace shellback::bearing
