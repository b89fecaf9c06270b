#include "validation/stress/stress_refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shellback::validation {
namespace {

bool claims_none(StressClass c) { return c == StressClass::no_steady_state; }
bool may_be_missed(StressClass c) { return c == StressClass::not_found; }

/// True if `theirs` contradicts a refusal of `ours` on this ground.
bool speaks(const StressMethod& theirs, const StressMethod& ours, RefusalGround ground) {
  if (theirs.less_physics) return false;
  return !ours.less_physics || ground == RefusalGround::heat;
}

bool speaks(QuestionKind question, const StressMethod& ours, RefusalGround ground) {
  if (question == QuestionKind::full_shear) return false;
  if (question == QuestionKind::richer_heat) return ground == RefusalGround::heat;
  return !ours.less_physics || ground == RefusalGround::heat;
}

/// A method or a grid that cannot take the case says nothing about it.
bool took_part(const StressCell& cell) {
  return cell.result != StressClass::not_run && cell.result != StressClass::refused_input;
}

/// True if the step's finer grid claims that there is no steady state, either, or meets a bound of
/// the equations before the load asked for.
bool finer_claims_none(const std::vector<StressWitness>& asked) {
  return std::any_of(asked.begin(), asked.end(), [](const StressWitness& w) {
    const bool none = claims_none(w.cell.result) || w.cell.answer.meets_bound;
    return w.question == QuestionKind::finer_grid && none;
  });
}

/// All solves that may speak on the cell, with their names.
struct Voice {
  std::string name;
  const StressCell* cell;
};
std::vector<Voice> voices_on(const StressRow& row, std::size_t method, std::size_t step) {
  const auto& methods = stress_methods();
  const RefusalGround ground = ground_of(row.cells[method][step].why);
  std::vector<Voice> voices;
  for (std::size_t m = 0; m < row.cells.size(); ++m) {
    const StressCell& cell = row.cells[m][step];
    if (m == method || !took_part(cell)) continue;
    if (speaks(methods[m], methods[method], ground)) voices.push_back({methods[m].title, &cell});
  }
  if (step >= row.asked.size()) return voices;
  const bool both_claim =
      claims_none(row.cells[method][step].result) && finer_claims_none(row.asked[step]);
  for (const StressWitness& w : row.asked[step]) {
    if (!took_part(w.cell)) continue;
    if (both_claim && w.question == QuestionKind::coarser_grid) continue;
    if (speaks(w.question, methods[method], ground)) voices.push_back({w.name, &w.cell});
  }
  return voices;
}

void turn(StressCell& cell, const std::string& because) {
  cell.result = may_be_missed(cell.result) ? StressClass::missed : StressClass::wrong_refusal;
  cell.why = because + "; refused: " + cell.why;
}

/// True for a refusal of a case in which there is a steady state.
bool refuses(const StressCell& cell, bool shipped) {
  return claims_none(cell.result) || may_be_missed(cell.result) ||
         (shipped && cell.result == StressClass::refused_input);
}

}  // namespace

RefusalGround ground_of(const std::string& reason) {
  const auto says = [&](const char* word) { return reason.find(word) != std::string::npos; };
  // The pressure law and the gap have limits that richer heat does not lift.
  if (says("1/alpha") || says("grows without bound") || says("surfaces touch")) {
    return RefusalGround::other;
  }
  return says("runaway") || says("heat") ? RefusalGround::heat : RefusalGround::other;
}

void find_contradicted(StressRow& row) {
  const auto before = row.cells;  // a cell that is judged stays a witness as it was
  StressRow seen{row.scene, before, row.asked};
  for (std::size_t m = 0; m < row.cells.size(); ++m) {
    for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
      StressCell& cell = row.cells[m][k];
      if (!claims_none(cell.result) && !may_be_missed(cell.result)) continue;
      const auto voices = voices_on(seen, m, k);
      const auto found = std::find_if(voices.begin(), voices.end(), [](const Voice& v) {
        return v.cell->result == StressClass::converged;
      });
      if (found != voices.end()) turn(cell, found->name + " converges and passes its audits");
    }
  }
}

void find_unexpected(StressRow& row) {
  const StressExpectation& e = row.scene.expects;
  const auto& methods = stress_methods();
  for (std::size_t m = 0; m < row.cells.size(); ++m) {
    if (methods[m].less_physics) continue;
    for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
      StressCell& cell = row.cells[m][k];
      if (e.steady(k) && refuses(cell, methods[m].shipped)) {
        turn(cell, "physics has a steady state here");
      }
      if (e.none(k) && cell.result == StressClass::converged) {
        cell.result = StressClass::wrong;
        cell.why = "converged where physics has no steady state";
      }
    }
  }
}

std::string overruled_by_finer(const StressRow& row, std::size_t step) {
  if (step >= row.asked.size() || !claims_none(row.cells.front()[step].result)) return "";
  if (!finer_claims_none(row.asked[step])) return "";
  for (const StressWitness& w : row.asked[step]) {
    const bool converged = w.cell.result == StressClass::converged;
    if (w.question == QuestionKind::coarser_grid && converged) return w.name;
  }
  return "";
}

Witnesses witnesses_of(const StressRow& row, std::size_t step) {
  Witnesses of;
  for (const Voice& voice : voices_on(row, 0, step)) {
    if (is_fault(voice.cell->result)) {
      of.faulty.push_back(fmt::format("{}: {}", voice.name, to_string(voice.cell->result)));
    } else if (voice.cell->result != StressClass::converged) {
      ++of.silent;
    }
  }
  return of;
}

}  // namespace shellback::validation
