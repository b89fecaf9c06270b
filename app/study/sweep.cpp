#include "app/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "app/study/curve.hpp"
#include "bearing/bearing.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"

namespace shellback::study {

using bearing::Case;

namespace {

/// Points from all threads, counted.
class Counter {
 public:
  Counter(std::size_t total, const SweepOptions& options) : options_(options), failed_(total, 0) {
    now_.total = static_cast<int>(total);
  }

  /// A point may fail first and be won later.
  void tell(std::size_t index, bool good) {
    const std::lock_guard lock(guard_);
    if (good) ++now_.done;
    now_.failed += (good ? 0 : 1) - failed_[index];
    failed_[index] = good ? 0 : 1;
    if (options_.progress) options_.progress(now_);
  }

 private:
  const SweepOptions& options_;
  std::vector<char> failed_;
  SweepProgress now_;
  std::mutex guard_;
};

/// All cases, judged, in the order of the points. Throws InputError at the first that is wrong.
std::vector<Case> all_cases(const Sweep& sweep, const CaseAt& case_at, bool alone_can_be_solved) {
  using bearing::Tier;
  std::vector<Case> cases;
  for (int k = 0; k < sweep.axes.front().size(); ++k) {
    for (int c = 0; c < sweep.curves(); ++c) {
      cases.push_back(case_at({static_cast<double>(k), across(sweep.axes, c)}));
      const Tier tier = cases.back().model.tier;
      if (!alone_can_be_solved && (tier == Tier::estimate || tier == Tier::automatic)) {
        throw InputError("model.tier", fmt::format("the tier {} cannot be swept; name one of "
                                                   "isothermal, lumped, thd, tehd",
                                                   to_string(tier)));
      }
      // What the grid cannot carry is bad input too, and shows only here.
      static_cast<void>(make_bearing(cases.back(), {}, cases.back().model.grid));
    }
  }
  return cases;
}

struct Piece {
  int curve = 0;
  int low = 0;
  int high = 0;
};

/// Every curve cut evenly.
std::vector<Piece> cut(int curves, int points, int pieces) {
  std::vector<Piece> all;
  for (int c = 0; c < curves; ++c) {
    for (int p = 0; p < pieces; ++p) {
      all.push_back({c, p * points / pieces, (p + 1) * points / pieces});
    }
  }
  return all;
}

std::vector<std::unique_ptr<Curve>> make_curves(Sweep& sweep, const std::vector<Case>& cases,
                                                const CaseAt& case_at, Counter& counter,
                                                const SweepOptions& options) {
  std::vector<std::unique_ptr<Curve>> curves;
  const int n = sweep.curves();
  for (int c = 0; c < n; ++c) {
    const auto index = [n, c](int k) { return static_cast<std::size_t>(k * n + c); };
    std::vector<SweepPoint*> points;
    for (int k = 0; k < sweep.axes.front().size(); ++k) points.push_back(&sweep.points[index(k)]);
    const auto along = [&cases, &case_at, index, on = across(sweep.axes, c)](double at) {
      const double whole = std::round(at);
      return at == whole ? cases[index(static_cast<int>(whole))] : case_at({at, on});
    };
    const auto told = [&counter, index](int k, bool good) { counter.tell(index(k), good); };
    const auto alone = [&options, index](int k, const Case& one,
                                         const bearing::SolveControl& control) {
      return options.solve_alone(static_cast<int>(index(k)), one, control);
    };
    const auto finished = [told](int k, const Curve::Known& s) { told(k, s != nullptr); };
    curves.push_back(std::make_unique<Curve>(sweep.axes.front(), along, std::move(points), options,
                                             finished, alone, told));
  }
  return curves;
}

}  // namespace

int Sweep::curves() const {
  int n = 1;
  for (std::size_t a = 1; a < axes.size(); ++a) n *= axes[a].size();
  return n;
}

const SweepPoint& Sweep::at(int along, int curve) const {
  return points[static_cast<std::size_t>(along * curves() + curve)];
}

int Sweep::count_good() const {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [](const auto& p) { return p.good(); }));
}

int Sweep::count_failed() const {
  return static_cast<int>(std::count_if(points.begin(), points.end(), [](const auto& p) {
    return p.tried() && !p.good() && p.result.verdict.status != Status::interrupted;
  }));
}

std::vector<int> across(const std::vector<Axis>& axes, int curve) {
  std::vector<int> indices(axes.size() - 1);
  for (std::size_t a = axes.size() - 1; a > 0; --a) {
    indices[a - 1] = curve % axes[a].size();
    curve /= axes[a].size();
  }
  return indices;
}

int pieces_per_curve(int curves, int points, int threads) {
  constexpr int kShortest = 6;  // points of a piece
  constexpr int kPlenty = 4;    // tasks per thread from which cutting gains nothing
  int pieces = 1;
  while (curves * pieces % threads != 0 && curves * pieces < kPlenty * threads &&
         points / (pieces + 1) >= kShortest) {
    ++pieces;
  }
  return pieces;
}

Sweep run_sweep(std::vector<Axis> axes, const CaseAt& case_at, const SweepOptions& options) {
  EXPECTS(!axes.empty() && options.threads >= 1);
  const Stopwatch watch;
  Sweep sweep;
  sweep.axes = std::move(axes);
  sweep.threads = options.threads;
  const std::vector<Case> cases = all_cases(sweep, case_at, static_cast<bool>(options.solve_alone));
  sweep.points.resize(cases.size());
  Counter counter(cases.size(), options);
  const auto curves = make_curves(sweep, cases, case_at, counter, options);
  const int n = sweep.axes.front().size();
  // Points that stand alone have no cold start to share: each is a piece.
  const bool alone = std::all_of(cases.begin(), cases.end(), stands_alone);
  const int each = alone ? n : pieces_per_curve(sweep.curves(), n, options.threads);
  const auto pieces = cut(sweep.curves(), n, each);
  const auto count = static_cast<int>(pieces.size());
  parallel_for(count, options.threads,
               [&](int t) { curves[pieces[t].curve]->solve_piece(pieces[t].low, pieces[t].high); });
  parallel_for(sweep.curves(), options.threads, [&](int c) { curves[c]->mend(); });
  sweep.interrupted = options.stop != nullptr && options.stop->load();
  sweep.wall_s = watch.seconds();
  return sweep;
}

}  // namespace shellback::study
