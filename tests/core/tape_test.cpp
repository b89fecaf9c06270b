// What is put on a tape comes off it bit by bit.
#include "core/tape.hpp"

#include <catch2/catch.hpp>

#include "core/outcome.hpp"
#include "core/replay.hpp"

using namespace shellback;

namespace {

Verdict nested() {
  const ending::LimitMoves moves{{{{72, 12}, {ending::Raised::speed, 0.1, 300.0}},
                                  {{48, 8}, {ending::Raised::speed, 0.7, 300.0}}}};
  const Verdict within{
      Status::invalid_number, ending::NotANumber{FieldName::gap, true}, {1.5, -2e-3}};
  return {Status::iteration_limit, moves, {NAN, 1e-3}, {within}};
}

}  // namespace

TEST_CASE("AnEndingComesBackFromATapeWithTheOneWithin", "[tape]") {
  Verdict kept = nested();
  Tape written;
  written(kept);
  Tape read(written.content());
  Verdict back;
  read(back);
  CHECK(read.ended());
  CHECK(back.status == kept.status);
  CHECK(std::isnan(back.place.phi));
  CHECK(back.place.z == 1e-3);
  const auto* moves = back.as<ending::LimitMoves>();
  REQUIRE(moves != nullptr);
  REQUIRE(moves->limits.size() == 2);
  CHECK(moves->limits[1].grid == std::array{48, 8});
  CHECK(moves->limits[1].carried.part == 0.7);
  REQUIRE(back.cause.size() == 1);
  const auto* within = back.cause.front().as<ending::NotANumber>();
  REQUIRE(within != nullptr);
  CHECK(within->field == FieldName::gap);
  CHECK(within->other_method);
  CHECK(back.cause.front().place == FilmPlace{1.5, -2e-3});
}

TEST_CASE("AnAlternativeThatIsNotKnownIsRefused", "[tape]") {
  Ending ending = ending::Plain::given_up;
  Tape written;
  written(ending);
  Tape::Content content = written.content();
  content.counts.front() = 1000;
  Tape read(content);
  CHECK_THROWS_AS(read(ending), FileError);
}

TEST_CASE("ARunThatGoesOnIsToldWhatItWasToldBefore", "[tape]") {
  Replay<double> answers;
  CHECK_FALSE(answers.next());
  answers.add(3.0);
  answers.add(5.0);
  CHECK_FALSE(answers.next());  // what has just been worked out is not told again
  Tape written;
  written(answers);
  Tape read(written.content());
  Replay<double> back;
  read(back);
  CHECK(back.next() == 3.0);
  CHECK(back.next() == 5.0);
  CHECK_FALSE(back.next());
}
