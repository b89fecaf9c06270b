#include "core/tape.hpp"

#include "core/contract.hpp"

namespace shellback {
namespace {

void expect_room(std::size_t wanted, std::size_t begin, std::size_t end) {
  if (wanted > end - begin) throw FileError("a kept state ends before all of it is read");
}

}  // namespace

bool Tape::ended() const {
  return number_ == content_.numbers.size() && count_ == content_.counts.size() &&
         letter_ == content_.text.size();
}

void Tape::value(double& x) {
  if (!reads_) {
    content_.numbers.push_back(x);
    return;
  }
  expect_room(1, number_, content_.numbers.size());
  x = content_.numbers[number_++];
}

void Tape::value(std::vector<double>& x) {
  auto n = static_cast<std::int64_t>(x.size());
  count(n);
  if (!reads_) {
    content_.numbers.insert(content_.numbers.end(), x.begin(), x.end());
    return;
  }
  const auto size = static_cast<std::size_t>(n);
  expect_room(size, number_, content_.numbers.size());
  const auto from = content_.numbers.begin() + static_cast<std::ptrdiff_t>(number_);
  x.assign(from, from + static_cast<std::ptrdiff_t>(size));
  number_ += size;
}

void Tape::value(std::string& x) {
  auto n = static_cast<std::int64_t>(x.size());
  count(n);
  if (!reads_) {
    content_.text += x;
    return;
  }
  const auto size = static_cast<std::size_t>(n);
  expect_room(size, letter_, content_.text.size());
  x = content_.text.substr(letter_, size);
  letter_ += size;
}

void Tape::count(std::int64_t& n) {
  if (!reads_) {
    content_.counts.push_back(n);
    return;
  }
  expect_room(1, count_, content_.counts.size());
  n = content_.counts[count_++];
}

void Tape::length(std::int64_t& n) {
  count(n);
  if (!reads_) return;
  const std::size_t all = content_.numbers.size() + content_.counts.size();
  expect_room(static_cast<std::size_t>(n), 0, all);
}

}  // namespace shellback
