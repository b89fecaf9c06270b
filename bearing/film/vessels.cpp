#include "bearing/film/vessels.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "rheology/density.hpp"

namespace shellback::bearing {

Vessels::Vessels(const BearingModel& model) : p_cav_(model.domain.p_cavitation) {
  const Case& c = model.input;
  if (!c.cycle) return;
  period_ = c.cycle->period;
  for (std::size_t k = 0; k < c.supplies.size(); ++k) {
    const Supply& s = c.supplies[k];
    if (!s.vessel) continue;
    const double rho = rheology::density(model.oil, s.temperature, 0.0).rho;
    of_patch_.push_back(static_cast<int>(k));
    kappa_.push_back(rho * s.vessel->volume / s.vessel->bulk_modulus);
    p_supply_.push_back(s.pressure);
    given_.push_back(*s.vessel);
  }
  open_.assign(of_patch_.size(), 1);
  conductance_.assign(of_patch_.size(), 0.0);
}

std::vector<double> Vessels::full() const {
  std::vector<double> oil;
  for (std::size_t k = 0; k < kappa_.size(); ++k) {
    oil.push_back(kappa_[k] * (p_supply_[k] - p_cav_));
  }
  return oil;
}

double Vessels::least_pressure(const std::vector<double>& oil) const {
  double least = INFINITY;
  for (std::size_t k = 0; k < oil.size(); ++k) {
    least = std::min(least, p_cav_ + std::max(oil[k], 0.0) / kappa_[k]);
  }
  return least;
}

std::vector<double> Vessels::begin(fluid::FilmScene& scene) const {
  for (std::size_t k = 0; k < of_patch_.size(); ++k) {
    put(static_cast<int>(k), p_supply_[k] - p_cav_, scene);
  }
  return full();
}

bool Vessels::any_empty(const fluid::FilmScene& scene) const {
  for (std::size_t k = 0; k < of_patch_.size(); ++k) {
    if (!open_[k] && !(unknown(static_cast<int>(k), scene) > 0.0)) return true;
  }
  return false;
}

double Vessels::largest_share(const std::vector<double>& oil) const {
  const std::vector<double> most = full();
  double share = 0.0;
  for (std::size_t k = 0; k < oil.size(); ++k) share = larger(share, std::abs(oil[k]) / most[k]);
  return share;
}

std::vector<double> Vessels::switchings() const {
  std::vector<double> times;
  for (const Vessel& v : given_) {
    for (const auto& window : v.open) {
      for (double t : window) {
        const bool at_end = std::isfinite(period_) && std::abs(t - period_) <= kRoundOff * period_;
        if (at_end) t = 0.0;  // of a period: its beginning; an event has none
        times.push_back(t);
      }
    }
  }
  return times;
}

double Vessels::set_lines(double t, std::vector<double>& oil) {
  const std::vector<double> most = full();
  const double within = std::isfinite(period_) ? t - period_ * std::floor(t / period_) : t;
  double taken = 0.0;
  for (std::size_t k = 0; k < given_.size(); ++k) {
    const auto& windows = given_[k].open;
    open_[k] = std::any_of(windows.begin(), windows.end(),
                           [&](const auto& w) { return w[0] <= within && within < w[1]; });
    if (!open_[k]) continue;
    taken += most[k] - oil[k];
    oil[k] = most[k];
  }
  return taken;
}

void Vessels::put(int vessel, double u, fluid::FilmScene& scene) const {
  fluid::SupplyPatch& patch = scene.supply.patches[of_patch_[vessel]];
  patch.pressure = p_cav_ + std::max(u, 0.0);
  patch.fill = 1.0 + std::min(u, 0.0) / (p_supply_[vessel] - p_cav_);
}

double Vessels::unknown(int vessel, const fluid::FilmScene& scene) const {
  const fluid::SupplyPatch& patch = scene.supply.patches[of_patch_[vessel]];
  const double emptied = (1.0 - patch.fill) * (p_supply_[vessel] - p_cav_);
  return patch.fill < 1.0 ? -emptied : patch.pressure - p_cav_;
}

double Vessels::gap_known_to(const std::vector<double>& pockets) const {
  double least = INFINITY;
  for (std::size_t k = 0; k < of_patch_.size(); ++k) {
    const double pocket = pockets[of_patch_[k]];
    if (open_[k] || !(pocket > 0.0)) continue;
    least = std::min(least, kEnough * kappa_[k] * (p_supply_[k] - p_cav_) / pocket);
  }
  return least;
}

/// The search for one vessel's unknown.
struct Vessels::Search {
  double u = 0.0;                           ///< [Pa]
  double low = -INFINITY, high = INFINITY;  ///< between which it lies [Pa]
  double u_before = NAN, out_before = NAN;
  bool found = false;
  double least = 0.0;  ///< u of no fill; of a drilling, whose mouth nothing is dragged from, 0 [Pa]
};

/// (4) with `out` of the vessel flowing at `s.u`: it rises with u, with another slope above zero
/// than below.
void Vessels::advance(int k, double own, double star, double out, Search& s) {
  const double span = p_supply_[k] - p_cav_;
  const double r = kappa_[k] * std::max(s.u, 0.0) - star + own * out;
  const bool holds = s.u > 0.0 || (s.u == 0.0 && r < 0.0);
  const double slope = (out - s.out_before) / (s.u - s.u_before);
  if (std::isfinite(slope)) conductance_[k] = slope;
  // A film that drives oil into the vessel does not feel how empty it is.
  if (!(conductance_[k] > 0.0)) conductance_[k] = std::abs(out) / span;
  const double rate = own * conductance_[k] + (holds ? kappa_[k] : 0.0);
  const bool nothing_left = s.u <= s.least && r > 0.0;  // it takes in all that the journal brings
  s.found = nothing_left || std::abs(r) <= kEnough * rate * span;
  if (s.found) return;
  (r > 0.0 ? s.high : s.low) = s.u;
  if (!(s.high > s.low)) s.low = -INFINITY, s.high = INFINITY;  // other vessels have moved it
  s.u_before = s.u;
  s.out_before = out;
  double next = s.u - r / rate;
  if (next * s.u < 0.0) next = 0.0;  // the law changes there
  if (!(next > s.low && next < s.high)) next = 0.5 * (s.low + s.high);
  s.u = std::isfinite(next) ? std::max(next, s.least) : 0.0;
}

Verdict Vessels::solve(double own, const std::vector<double>& oil_star, fluid::FilmScene& scene,
                       const Film& film) {
  const int n = static_cast<int>(of_patch_.size());
  std::vector<Search> search(n);
  for (int k = 0; k < n; ++k) {
    const bool mouth = scene.supply.patches[of_patch_[k]].moving;
    search[k].least = mouth ? 0.0 : -(p_supply_[k] - p_cav_);
    search[k].u = std::max(unknown(k, scene), search[k].least);
  }
  for (int k = 0; k < n; ++k) {
    if (open_[k]) search[k] = {p_supply_[k] - p_cav_, 0.0, 0.0, 0.0, 0.0, true, 0.0};
  }
  fluid::OilFlows flows;
  for (int i = 0; i < kMostIterations; ++i) {
    for (int k = 0; k < n; ++k) put(k, search[k].u, scene);
    if (Verdict v = film(flows); !v.good()) return v;
    bool all = true;
    for (int k = 0; k < n; ++k) {
      if (open_[k]) continue;
      advance(k, own, oil_star[k], flows.patch[of_patch_[k]], search[k]);
      all = all && search[k].found;
    }
    if (all) return {};
  }
  return {Status::iteration_limit, ending::Plain::no_vessel_pressure};
}

std::vector<double> Vessels::slopes(const fluid::OilFlows& flows) const {
  std::vector<double> k(of_patch_.size(), 0.0);
  for (std::size_t v = 0; v < k.size(); ++v) {
    if (!open_[v]) k[v] = -flows.patch[of_patch_[v]];
  }
  return k;
}

double Vessels::from_lines(const fluid::OilFlows& flows) const {
  double sum = flows.supply;
  for (const double k : slopes(flows)) sum += k;
  return sum;
}

void Vessels::members(Tape& tape) { tape(open_, conductance_); }

}  // namespace shellback::bearing
