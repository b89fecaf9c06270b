// The state of a film in time taken out of its steps and put back into them: what lasts over many
// periods, the same film under a shell of another shape, and what a tape keeps (core/tape.hpp).
#include <algorithm>
#include <cmath>

#include "bearing/film/equilibrium.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/over_time/film_step.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {

std::vector<double> FilmSteps::oil_of(const FilmInTime& now) const {
  std::vector<double> oil = per_cell(model_.domain.grid, now.oil);
  oil.insert(oil.end(), now.vessels.begin(), now.vessels.end());
  return oil;
}

namespace {

/// Of cell c, with n nodes each; of no nodes: nothing.
void scale_nodes(int c, int n, double by, std::vector<double>& of_nodes) {
  if (of_nodes.empty()) return;
  const auto first = of_nodes.begin() + static_cast<std::ptrdiff_t>(c) * n;
  std::for_each(first, first + n, [by](double& x) { x *= by; });
}

}  // namespace

void FilmSteps::put_oil(const std::vector<double>& oil, FilmInTime& now) const {
  const FilmGrid& g = model_.domain.grid;
  const int n = model_.gl.n;
  fluid::FilmState& film = now.film.film;
  fluid::FilmState whole = film;
  std::fill(whole.theta.begin(), whole.theta.end(), 1.0);
  const Field most = fluid::oil_content(point_.scene, now.film.gap, now.film.oil, whole);
  for (int c = 0; c < g.cells(); ++c) {
    if (film.full[c] || model_.supply.cell[c] >= 0) continue;
    const double held = now.oil[c];
    now.oil[c] = std::clamp(oil[c] / g.area(c), 0.0, most[c]);
    film.theta[c] = now.oil[c] / most[c];
    if (!(held > 0.0)) continue;
    // Heat goes with the oil: its temperature stays. So does what a cell loses with what it holds:
    // one that is emptied loses nothing.
    const double part = now.oil[c] / held;
    const bool loses = part < 1.0;
    if (loses && !now.oil_slope.empty()) now.oil_slope[c] *= part;
    scale_nodes(c, n, part, now.heat.held);
    if (loses) scale_nodes(c, n, part, now.heat.held_slope);
  }
  const std::vector<double> filled = vessels_.full();
  for (std::size_t v = 0; v < now.vessels.size(); ++v) {
    now.vessels[v] = std::clamp(oil[g.cells() + v], std::min(now.vessels[v], 0.0),
                                std::max(filled[v], now.vessels[v]));
  }
}

double FilmSteps::unit_of_place() const {
  const FilmGrid& g = model_.domain.grid;
  double squares = 0.0;
  for (int c = 0; c < g.cells(); ++c) squares += std::pow(g.area(c), 2);
  return reference_density(model_) * std::sqrt(0.5 * squares);
}

double FilmSteps::unit_of_velocity() const {
  return unit_of_place() * model_.input.cycle->length() / (2.0 * kPi);
}

JournalState FilmSteps::journal_of(const FilmInTime& now) const {
  const double place = unit_of_place(), velocity = unit_of_velocity();
  const auto& q = now.film.position.q;
  return {place * q[0], place * q[1], velocity * now.velocity[0], velocity * now.velocity[1]};
}

bool FilmSteps::put_journal(const JournalState& journal, FilmInTime& now) {
  for (int k = 0; k < 2; ++k) now.film.position.q[k] = journal[k] / unit_of_place();
  for (int k = 0; k < 2; ++k) now.velocity[k] = journal[2 + k] / unit_of_velocity();
  if (!reshape(now)) return false;
  renew_heat(now);
  return true;
}

std::vector<double> FilmSteps::lasting_of(const FilmInTime& now) const {
  std::vector<double> lasting = oil_of(now);
  if (!(mass_ > 0.0)) return lasting;
  const JournalState journal = journal_of(now);
  lasting.insert(lasting.end(), journal.begin(), journal.end());
  return lasting;
}

bool FilmSteps::put_lasting(const std::vector<double>& lasting, FilmInTime& now) {
  if (mass_ > 0.0) {
    JournalState journal;
    std::copy(lasting.end() - 4, lasting.end(), journal.begin());
    if (!put_journal(journal, now)) return false;
  }
  put_oil(lasting, now);
  return true;
}

bool FilmSteps::reshape(FilmInTime& now) {
  constexpr double kNearer = 0.9;  // to the middle, where the gap is closed: it is but a start
  constexpr int kMost = 40;        // then it is in the middle within 2 %
  point_.scene.speed = course_.begins().omega * model_.input.bearing.radius;
  for (int k = 0; !evaluate(model_, point_, widening_, options_.viscosity_tolerance, now.film);
       ++k) {
    if (k == kMost) return false;
    for (int i = 0; i < 2; ++i) now.film.position.q[i] *= kNearer;
  }
  now.oil = fluid::oil_content(point_.scene, now.film.gap, now.film.oil, now.film.film);
  now.oil_slope.clear();
  return true;
}

void FilmSteps::members(Tape& tape, double period, double shortest) {
  bool warm = heat_.has_value();
  tape(point_.scene.speed, point_.scene.storage, vessels_, warm);
  for (fluid::SupplyPatch& patch : point_.scene.supply.patches)
    tape(patch.phi, patch.pressure, patch.fill);
  tape(point_.scene.supply.mouths);
  if (!warm) return;
  if (!heat_) heat_.emplace(model_, period, shortest);
  tape(heat_->walls, growth_.from, growth_.begun, growth_.length, widening_);
}

}  // namespace shellback::bearing
