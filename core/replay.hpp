#pragma once
/// What a run was told before, told again in the same order to one that goes on with it.
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/tape.hpp"

namespace shellback {

template <class T>
class Replay {
 public:
  /// What came next in the run before; none: it has to be worked out, and told to add().
  [[nodiscard]] std::optional<T> next() {
    if (told_ == all_.size()) return std::nullopt;
    return all_[told_++];
  }
  void add(T x) {
    all_.push_back(std::move(x));
    told_ = all_.size();
  }
  void clear() { *this = {}; }
  void members(Tape& tape) { tape(all_); }

 private:
  std::vector<T> all_;
  std::size_t told_ = 0;  ///< of them, in this run
};

}  // namespace shellback
