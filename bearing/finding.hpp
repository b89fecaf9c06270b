#pragma once
/// What a judgement of a case finds: reason, key and cure.
#include <string>
#include <utility>
#include <vector>

namespace shellback::bearing {

enum class Gravity {
  refused,  ///< nothing can be computed with it, or no bearing is like that
  unusual,  ///< possible, but look at it
};

struct Finding {
  Gravity gravity = Gravity::refused;
  std::string key;      ///< dotted, as in a case file: "supply.0.pressure"
  std::string problem;  ///< what is wrong and why, values with units
  std::string cure;     ///< what to do; empty if the problem says all

  [[nodiscard]] bool refused() const { return gravity == Gravity::refused; }
  [[nodiscard]] std::string words() const { return cure.empty() ? problem : problem + "; " + cure; }
};

/// Findings as they gather.
struct Findings {
  std::vector<Finding> list;

  void refuse(std::string key, std::string problem, std::string cure = "") {
    list.push_back({Gravity::refused, std::move(key), std::move(problem), std::move(cure)});
  }
  void suspect(std::string key, std::string problem, std::string cure = "") {
    list.push_back({Gravity::unusual, std::move(key), std::move(problem), std::move(cure)});
  }
  [[nodiscard]] bool refused() const {
    for (const Finding& f : list) {
      if (f.refused()) return true;
    }
    return false;
  }
};

}  // namespace shellback::bearing
