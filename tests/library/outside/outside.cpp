/// Eigen's objects pass the border of the library both ways, between code compiled for different
/// vector registers. Wrong alignment ends this program; wrong values give exit code 1.
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "core/harmonics.hpp"
#include "core/make_grid.hpp"

using namespace shellback;

namespace {

bool aligned(const double* data) {
  return reinterpret_cast<std::uintptr_t>(data) % kEigenAlignment == 0;
}

/// Made by the library, freed here; made here, grown and freed by the library.
bool harmonics_come_back(int nz) {
  const FilmGrid grid = make_grid(0.025, 0.02, 36, nz, false);
  const Harmonics harmonics(grid, 5);
  Field field(grid.cells());
  for (int i = 0; i < grid.nt; ++i) {
    for (int j = 0; j < grid.nz; ++j) field[grid.index(i, j)] = 2.0 + std::cos(3.0 * grid.phi[i]);
  }
  Eigen::MatrixXd coefficients = harmonics.fit(field);
  const Field back = harmonics.synthesise(coefficients);
  double worst = 0.0;
  for (std::size_t k = 0; k < field.size(); ++k) {
    worst = std::fmax(worst, std::abs(back[k] - field[k]));
  }
  const bool good = aligned(coefficients.data()) && worst < 1e-12;
  coefficients.resize(3 * nz, 7);  // frees the library's memory with this program's allocator
  return good && aligned(coefficients.data());
}

}  // namespace

int main() {
  bool good = true;
  for (int nz = 1; nz <= 20; ++nz) good = harmonics_come_back(nz) && good;
  std::printf(good ? "good\n" : "bad\n");
  return good ? 0 : 1;
}
