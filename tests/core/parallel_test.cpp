/// Tasks on several threads.
#include "core/parallel.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

using shellback::parallel_for;

TEST_CASE("EveryTaskIsDoneOnce") {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> done(37);
    parallel_for(37, threads, [&](int k) { ++done[k]; });
    for (const auto& times : done) CHECK(times == 1);
  }
}

TEST_CASE("NoTaskIsNoWork") {
  parallel_for(0, 4, [](int) { throw std::runtime_error("called"); });
}

TEST_CASE("TheFirstFailureIsThrownOn") {
  const auto task = [](int k) {
    if (k == 3) throw std::runtime_error("the third");
  };
  CHECK_THROWS_WITH(parallel_for(10, 2, task), "the third");
}
