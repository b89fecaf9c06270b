// Which cells of the stability map are contradicted, by whom, and by whom not.
#include "validation/stress/stress_judge.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "validation/stress/stress_expectation.hpp"
#include "validation/stress/stress_question.hpp"
#include "validation/stress/stress_refusal.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

constexpr const char* kRunaway = "thermal runaway: the film is 420 K above the supply and rises";
constexpr const char* kBarus = "the reduced pressure would have to exceed its bound 1/alpha";
constexpr const char* kNobody = "followed from a light load, the steady film ends at 2708 N";

std::size_t method(const std::string& name) {
  const auto& methods = stress_methods();
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m].name == name) return m;
  }
  throw std::logic_error("no method " + name);
}

StressCell refusal(StressClass c, const std::string& why) {
  StressCell cell;
  cell.result = c;
  cell.why = why;
  return cell;
}
StressCell none(const std::string& why) { return refusal(StressClass::no_steady_state, why); }

StressCell solution(double friction = 1.0) {
  StressCell cell;
  cell.result = StressClass::converged;
  cell.answer.status = "converged";
  cell.answer.quantities = {{"friction_torque", friction}, {"h_min", 2e-6}};
  return cell;
}

/// One value, nothing run yet.
StressRow row_with(const StressCell& ours) {
  StressRow row;
  row.scene.name = "a";
  row.scene.case_path = std::string(SHELLBACK_SOURCE_DIR) + "/validation/stress/plain.toml";
  row.scene.steps = {{"3 kN", {"operation.load=3 kN"}}};
  row.cells.assign(stress_methods().size(), std::vector<StressCell>(1));
  row.cells[0] = {ours};
  row.asked.resize(1);
  return row;
}

/// The default's class once the row is judged.
StressClass judged(StressRow row) {
  judge_row(row);
  return row.cells[0][0].result;
}

StressClass beside(const StressCell& ours, const std::string& name, const StressCell& theirs) {
  StressRow row = row_with(ours);
  row.cells[method(name)] = {theirs};
  return judged(row);
}

StressClass beside(const StressCell& ours, QuestionKind question, const StressCell& theirs) {
  StressRow row = row_with(ours);
  row.asked[0].push_back({question, "w", theirs});
  return judged(row);
}

}  // namespace

TEST_CASE("ARefusalBesideASteadyStateOfTheSameEquationsIsWrong") {
  for (const char* name : {"fischer-burmeister", "p-theta", "fixed-point", "layers"}) {
    INFO(name);
    CHECK(beside(none(kNobody), name, solution()) == StressClass::wrong_refusal);
    CHECK(beside(none(kBarus), name, solution()) == StressClass::wrong_refusal);
    CHECK(beside(refusal(StressClass::not_found, "stuck"), name, solution()) ==
          StressClass::missed);
    CHECK(beside(none(kNobody), name, none(kNobody)) == StressClass::no_steady_state);
  }
  for (const QuestionKind grid : {QuestionKind::coarser_grid, QuestionKind::finer_grid}) {
    CHECK(beside(none(kNobody), grid, solution()) == StressClass::wrong_refusal);
  }
  CHECK(is_fault(StressClass::wrong_refusal));
  CHECK_FALSE(is_fault(StressClass::missed));
}

TEST_CASE("AFaultyResultContradictsNothing") {
  StressCell leaky = solution();
  leaky.result = StressClass::wrong;
  CHECK(beside(none(kNobody), "p-theta", leaky) == StressClass::no_steady_state);
  CHECK(beside(none(kNobody), QuestionKind::finer_grid, leaky) == StressClass::no_steady_state);
}

TEST_CASE("AWitnessThatHangsOrErrsIsNoneThatFoundNothing") {
  StressRow row = row_with(none(kBarus));
  StressCell hung = solution();
  hung.result = StressClass::timed_out;
  row.asked[0] = {{QuestionKind::coarser_grid, "a grid of 32x5", none(kBarus)},
                  {QuestionKind::finer_grid, "a grid of 72x12", hung}};
  const Witnesses w = witnesses_of(row, 0);
  CHECK(w.silent == 1);
  CHECK(w.faulty == std::vector<std::string>{"a grid of 72x12: hang"});
}

TEST_CASE("ACoarserGridContradictsNothingThatTheFinerOneConfirms") {
  const auto between = [](const StressCell& coarser, const StressCell& finer) {
    StressRow row = row_with(none(kBarus));
    row.asked[0] = {{QuestionKind::coarser_grid, "32x5", coarser},
                    {QuestionKind::finer_grid, "72x12", finer}};
    const std::string overruled = overruled_by_finer(row, 0);
    return std::pair{judged(row), overruled};
  };
  CHECK(between(solution(), none(kBarus)) ==
        std::pair{StressClass::no_steady_state, std::string("32x5")});
  // What the finer grid did not find it does not confirm.
  CHECK(between(solution(), refusal(StressClass::not_found, "stuck")).first ==
        StressClass::wrong_refusal);
  // But a bound that it meets is one, though its limit is elsewhere and no third grid agrees.
  StressCell moves = refusal(StressClass::not_found, "not resolved: the limit moves with the grid");
  moves.answer.meets_bound = true;
  CHECK(between(solution(), moves).first == StressClass::no_steady_state);
  CHECK(between(none(kBarus), solution()) == std::pair{StressClass::wrong_refusal, std::string()});
  CHECK(between(none(kBarus), none(kBarus)) ==
        std::pair{StressClass::no_steady_state, std::string()});
}

TEST_CASE("LessPhysicsContradictsNothing") {
  for (const char* name : {"swift-stieber", "mean"}) {
    CHECK(beside(none(kNobody), name, solution()) == StressClass::no_steady_state);
    CHECK(beside(none(kRunaway), name, solution()) == StressClass::no_steady_state);
  }
}

TEST_CASE("RicherHeatContradictsARefusalOfHeatAndNoOther") {
  CHECK(beside(none(kRunaway), QuestionKind::richer_heat, solution()) ==
        StressClass::wrong_refusal);
  CHECK(beside(none(kBarus), QuestionKind::richer_heat, solution()) ==
        StressClass::no_steady_state);
  // One temperature across the film is the poorer heat: the default contradicts its runaway.
  StressRow row = row_with(solution());
  row.cells[method("mean")] = {none(kRunaway)};
  judge_row(row);
  CHECK(row.cells[method("mean")][0].result == StressClass::wrong_refusal);
  CHECK(ground_of("thermal runaway: followed to 5 kN; then: the film has no steady pressure: the "
                  "reduced pressure would have to exceed its bound 1/alpha") ==
        RefusalGround::other);
}

TEST_CASE("TheExpectationOfASceneJudgesEveryCell") {
  StressRow row = row_with(none(kNobody));
  row.scene.expects = expectation_from("steady", {"3 kN"});
  CHECK(judged(row) == StressClass::wrong_refusal);
  row.cells[0] = {refusal(StressClass::not_found, "stuck")};
  CHECK(judged(row) == StressClass::missed);
  row.cells[0] = {refusal(StressClass::refused_input, "no")};
  CHECK(judged(row) == StressClass::wrong_refusal);
  row.scene.expects = expectation_from("none from 3 kN", {"3 kN"});
  row.cells[0] = {solution()};
  CHECK(judged(row) == StressClass::wrong);
  row.cells[0] = {none(kBarus)};
  CHECK(judged(row) == StressClass::no_steady_state);
  // A method of less physics is not held to it.
  row.cells[method("swift-stieber")] = {solution()};
  judge_row(row);
  CHECK(row.cells[method("swift-stieber")][0].result == StressClass::converged);
}

TEST_CASE("AnExpectationIsReadAlongTheValues") {
  const std::vector<std::string> labels{"1 N", "2 N", "3 N", "4 N"};
  const StressExpectation e = expectation_from("steady to 2 N; none from 4 N", labels);
  CHECK(e.steady(1));
  CHECK_FALSE(e.steady(2));
  CHECK_FALSE(e.none(2));
  CHECK(e.none(3));
  const StressExpectation open;
  CHECK_FALSE(open.steady(0));
  CHECK_FALSE(open.none(1000));
  for (const char* wrong : {"", "stedy", "steady to 5 N", "steady to 4 N; none from 2 N"}) {
    INFO(wrong);
    CHECK_THROWS_AS(expectation_from(wrong, labels), std::invalid_argument);
  }
}

TEST_CASE("ADifferenceByFullShearIsAConventionAndNoDisagreement") {
  const std::size_t swift = method("swift-stieber");
  StressRow row = row_with(solution(1.0));
  row.cells[swift] = {solution(1.3)};  // 10 % are allowed
  row.asked[0].push_back({QuestionKind::full_shear, "full shear", solution(1.29)});
  judge_row(row);
  CHECK(row.cells[swift][0].result == StressClass::by_convention);
  CHECK(row.cells[swift][0].convention);
  // What full shear does not explain stays a disagreement.
  row.cells[swift] = {solution(1.3)};
  row.asked[0][0].cell = solution(1.1);
  judge_row(row);
  CHECK(row.cells[swift][0].result == StressClass::wrong);
  CHECK_FALSE(row.cells[swift][0].convention);
  // And a film that loses oil stays wrong, with both told.
  row.cells[swift] = {solution(1.3)};
  row.cells[swift][0].result = StressClass::wrong;
  row.cells[swift][0].why = "mass audit 6.1e-01";
  row.asked[0][0].cell = solution(1.29);
  judge_row(row);
  CHECK(row.cells[swift][0].result == StressClass::wrong);
  CHECK(row.cells[swift][0].convention);
  CHECK(row.cells[swift][0].why.find("mass audit") == 0);
  CHECK(row.cells[swift][0].why.find("by convention") != std::string::npos);
}

TEST_CASE("TwoOthersThatAgreeAgainstTheDefaultMakeItWrong") {
  StressRow row = row_with(solution(1.0));
  row.cells[method("p-theta")] = {solution(1.2)};
  CHECK(judged(row) == StressClass::converged);  // one other alone is the one that is off
  row.cells[method("fischer-burmeister")] = {solution(1.3)};
  CHECK(judged(row) == StressClass::converged);  // nor two that do not agree
  row.cells[method("fischer-burmeister")] = {solution(1.2)};
  CHECK(judged(row) == StressClass::wrong);
}

TEST_CASE("ATrendWithoutAValueIsBroken") {
  StressRow row = row_with(solution());
  row.scene.trend = {"no_such_quantity", true};
  CHECK(judged(row) == StressClass::wrong);
}

TEST_CASE("BesideARefusalACoarserAndAFinerGridAreAsked") {
  StressRow row = row_with(none(kNobody));
  row.scene.words = {"model.grid=[48, 8]"};
  const auto questions = questions_about(row, 0);
  REQUIRE(questions.size() == 2);
  CHECK(questions[0].words ==
        std::vector<std::string>{"operation.load=3 kN", "model.grid=[32, 5]"});
  CHECK(questions[1].name == "a grid of 72x12");
  CHECK(questions_about(row_with(solution()), 0).empty());
  // Tier thd is asked beside a lumped refusal of heat.
  row = row_with(none(kRunaway));
  row.scene.tier = bearing::Tier::lumped;
  REQUIRE(questions_about(row, 0).size() == 3);
  CHECK(questions_about(row, 0)[2].scene.tier == bearing::Tier::thd);
  // Full shear where a method that has it gives a result, whatever its audits say.
  row = row_with(solution());
  row.cells[method("swift-stieber")] = {solution()};
  row.cells[method("swift-stieber")][0].result = StressClass::wrong;
  REQUIRE(questions_about(row, 0).size() == 1);
  CHECK(questions_about(row, 0)[0].words.back() == "model.cavitated_shear=full");
}
