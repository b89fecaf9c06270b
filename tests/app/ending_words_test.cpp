// Every ending has words; nested ones tell what is within; the sentences are those that users know.
#include "app/words/ending_words.hpp"

#include <catch2/catch.hpp>

#include "core/constants.hpp"

using namespace shellback;
using app::reason_of;
using app::words_of;

namespace {

constexpr auto kNone = Status::no_steady_state;
constexpr auto kLimit = Status::iteration_limit;

bool has_reason(const Ending& e) { return !reason_of({kLimit, e}).empty(); }

template <std::size_t... k>
void check_each(std::index_sequence<k...>) {
  // the first is Plain::none, of which the status says all
  for (const bool has : {(k == 0 || has_reason(std::variant_alternative_t<k, Ending>{}))...}) {
    CHECK(has);
  }
}

/// All enumerators up to the last.
template <class E, class Check>
void check_up_to(E last, Check has_words) {
  for (int k = 0; k <= static_cast<int>(last); ++k) {
    INFO(k);
    CHECK(has_words(static_cast<E>(k)));
  }
}

}  // namespace

TEST_CASE("EveryEndingHasAReason", "[words]") {
  check_each(std::make_index_sequence<std::variant_size_v<Ending>>());
  check_up_to(ending::Plain::steps_too_short,
              [](ending::Plain e) { return e == ending::Plain::none || has_reason(e); });
  check_up_to(ending::Iteration::wear, [](ending::Iteration e) {
    return has_reason(ending::Unsettled{e, 1, 1.0, true});
  });
  check_up_to(ending::Thermal::unbalanced_cycle, [](ending::Thermal e) {
    return has_reason(ending::AtTemperature{e, 350.0});
  });
  check_up_to(FieldName::film_flow, [](FieldName e) {
    return has_reason(ending::NotANumber{e, false});
  });
  CHECK(reason_of({}).empty());
  CHECK(reason_of({Status::interrupted}) == "stopped by the user");
}

TEST_CASE("AFilmThatIsNotPeriodicTellsWhereItsOilGoes", "[words]") {
  const auto told = [](double gathered) {
    return reason_of(
        {kLimit, ending::Unsettled{ending::Iteration::cycles, 40, 2e-3, false, gathered}});
  };
  CHECK(told(-0.013).find("lost 1.3 % of its oil") != std::string::npos);
  CHECK(told(0.02).find("gained 2 % of its oil") != std::string::npos);
  CHECK(told(1e-6).find("of its oil") == std::string::npos);
}

TEST_CASE("PlacesAreToldFromZeroToAFullTurn", "[words]") {
  CHECK(words_of(FilmPlace{-0.5 * kPi, 0.31e-3}) == "phi 270.0 deg, z 0.31 mm");
  CHECK(words_of(FilmPlace{2.5 * kPi, -2e-3}) == "phi 90.0 deg, z -2.00 mm");
  CHECK(words_of(FilmPlace{NAN, 1e-3}) == "z 1.00 mm");  // a ring
  CHECK(words_of(FilmPlace{}).empty());
}

TEST_CASE("AClosedGapTellsWhatClosedIt", "[words]") {
  const ending::GapClosed e{-0.0888e-6, 5.74e-6, -6.12e-6, 0.291e-6, -0.00839e-6};
  CHECK(reason_of({kNone, e}) ==
        "the clearance is used up by thermal growth: smooth surfaces touch before a film is "
        "sought: the smallest gap is -0.0888 um; position and profile leave 5.74 um there, thermal "
        "growth takes 6.12 um, elasticity gives 0.291 um; across the bearing 0.00839 um are "
        "missing, which no position of the journal mends");
  const ending::GapClosed rigid{-0.6e-6, -0.6e-6, NAN, NAN, 50e-6};
  CHECK(reason_of({kNone, rigid}) ==
        "smooth surfaces touch before a film is sought: the smallest gap is -0.6 um; position and "
        "profile leave -0.6 um there");
}

TEST_CASE("ABranchTellsHowFarItWasFollowedAndWhatCameThen", "[words]") {
  const ending::BranchEnded bound{
      ending::BranchEnd::unbounded, {ending::Raised::load, 0.549, 6e4}, 4.24e-6, false};
  CHECK(reason_of({kNone, bound}) ==
        "the film cannot carry 6e+04 N: followed from a light load, steady states are found up to "
        "3.294e+04 N of 6e+04 N (smallest gap 4.24 um); closer the pressure grows without bound "
        "(with rigid surfaces the reduced pressure, the integral of eta(0)/eta(p) over p, has a "
        "bound, of Barus' law 1/alpha)");
  const Verdict within{kLimit, ending::Unsettled{ending::Iteration::heat, 25, 3.6e-3}};
  const ending::Carried rpm{ending::Raised::speed, 0.3123, 100.0 * kPi};  // 3000 rpm
  const ending::BranchEnded lost{ending::BranchEnd::lost, rpm, 1.16e-6, true};
  CHECK(
      reason_of({kLimit, lost, {}, {within}}) ==
      "no steady state was found: followed from a low speed, steady states are found up to 936.9 "
      "rpm of 3000 rpm (smallest gap 1.16 um); there the search was given up, which proves no end "
      "(film and heat did not settle in 25 iterations (last change 3.6e-03 of 10 K))");
  const ending::LimitMoves moves{{{{72, 12}, {ending::Raised::speed, 1.33 / 3000.0, 100.0 * kPi}},
                                  {{48, 8}, {ending::Raised::speed, 5.098 / 3000.0, 100.0 * kPi}}}};
  CHECK(reason_of({kLimit, moves, {}, {{kNone, ending::Plain::no_pressure}}}) ==
        "not resolved: the limit moves with the grid (1.33 rpm of 3000 rpm on 72 x 12 cells, 5.098 "
        "rpm of 3000 rpm on 48 x 8 cells); the film has no steady pressure at this gap: with the "
        "pressure-viscosity law chosen, the reduced pressure would have to exceed its bound "
        "1/alpha (q = (1 - exp(-alpha p))/alpha)");
  const ending::LimitMoves alike{{{{72, 12}, {ending::Raised::speed, 0.664, 100.0 * kPi}},
                                  {{48, 8}, {ending::Raised::speed, 0.665, 100.0 * kPi}}}};
  const ending::BranchEnded fed{
      ending::BranchEnd::lost, {ending::Raised::supply, 0.9, 70e5}, 1e-5, true};
  CHECK(reason_of({kLimit, fed})
            .find("from a low supply pressure, steady states are found up to "
                  "63 bar of 70 bar") != std::string::npos);
  CHECK(reason_of({kLimit, alike}).find("not resolved: the grids end at the same place") == 0);
  const auto both = [](double first, double second) {
    const ending::LimitMoves at{{{{90, 14}, {ending::Raised::load, first, 8e3}},
                                 {{60, 9}, {ending::Raised::load, second, 8e3}}}};
    return reason_of({kLimit, at});
  };
  CHECK(both(1.0, 0.95).find("not resolved: another grid comes to what is asked for (8000 N") == 0);
  CHECK(both(0.93, 0.95).find("not resolved: the limit is no farther from what is asked for") == 0);
}

TEST_CASE("ARunawayThatSpeaksOfNoMoreSaysSo", "[words]") {
  const ending::RanAway fled{{ending::Raised::speed, 0.01, 100.0 * kPi}, 1.1e-6, 700.0, true};
  const Verdict hot{kLimit, ending::Unsettled{ending::Iteration::heat, 25, 3.6e-3}};
  const char* kAbove = "with a higher speed the film may carry again, which was not seen";
  CHECK_THAT(reason_of({kLimit, fled, {}, {hot}}), Catch::Contains(kAbove));
  CHECK_THAT(reason_of({kNone, fled, {}, {hot}}), !Catch::Contains(kAbove));
}

TEST_CASE("AnUnstableOrbitTellsBothGrids", "[words]") {
  using Elsewhere = ending::UnstableOrbit::Elsewhere;
  const auto told = [](Elsewhere elsewhere) {
    return reason_of({kLimit, ending::UnstableOrbit{1.005, {200, 25}, elsewhere, {100, 13}}});
  };
  CHECK(told(Elsewhere::departs) ==
        "no journal keeps to its orbit: on 200 x 25 cells a journal that is off the orbit that "
        "repeats itself departs from it by 0.5 % more with every cycle (whirl), and so does one "
        "that is a tenth heavier on 100 x 13 cells");
  for (const Elsewhere e : {Elsewhere::keeps_to_it, Elsewhere::not_judged, Elsewhere::no_orbit}) {
    CHECK(told(e).find("not resolved: on 200 x 25 cells") == 0);
    CHECK(told(e).find("on 100 x 13 cells") != std::string::npos);
  }
  CHECK(reason_of({kLimit, ending::UnstableOrbit{1.005, {200, 25}}})
            .find("it was not looked at on another grid") != std::string::npos);
}

TEST_CASE("AStepTellsItsInstantAndItsCauseAndHasACureOfItsOwn", "[words]") {
  const Verdict within{kLimit, ending::Plain::overdrawn};
  ending::NoStep step{0.01, 100.0 * kPi};
  const auto cure = [&] { return words_of({kLimit, step, {}, {within}}).cure; };
  const auto told = words_of({kLimit, step, {}, {within}});
  CHECK(told.reason ==
        "no step in time is found at 180 deg of the cycle: a step takes more oil out of a cell "
        "than it holds");
  // What the case has already is no cure.
  CHECK(cure().find("load_cycle.journal_mass") == std::string::npos);
  CHECK(cure().find("model.elastic_deformation") == std::string::npos);
  step.massless = step.rigid = true;
  CHECK(cure().find("load_cycle.journal_mass") != std::string::npos);
  CHECK(cure().find("model.elastic_deformation") != std::string::npos);
}

TEST_CASE("AFilmThatIsNoMoreIsCuredByContactNotByCells", "[words]") {
  ending::FilmUnsettled e{34, 4.9e-2, 3.8e-8, 1.7e-5, 1.2e-6};
  CHECK(words_of({kLimit, e}).cure.find("finer grid") != std::string::npos);
  e.h_min = -1.02e-16;
  e.no_film = true;
  CHECK(words_of({kLimit, e}).cure.find("give roughness and contact data") == 0);
  CHECK(words_of({kLimit, e}).cure.find("grid") == std::string::npos);
}

TEST_CASE("AHeatBalanceWithoutARootTellsBothEndsAndWhetherFilmsEnd", "[words]") {
  ending::NoHeatBalance e{313.15, 713.15, 8.0, 4.0, INFINITY};
  CHECK(reason_of({kNone, e}) ==
        "thermal runaway: from 40.0 to 440.0 degC the film makes more heat than its oil carries "
        "off, by 8 W at the one end and 4 W at the other");
  e.surplus_low = -8.0;
  e.T_none = 353.15;
  CHECK(reason_of({kLimit, e, {}, {{kLimit, ending::Plain::given_up}}}) ==
        "from 40.0 to 440.0 degC the film makes less heat than its oil carries off, by 8 W at the "
        "one end and -4 W at the other; at 80.0 degC there is no film: the search was given up "
        "after twenty times the work of a usual solve on this grid");
}
