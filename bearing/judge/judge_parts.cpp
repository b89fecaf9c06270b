#include "bearing/judge/judge_parts.hpp"

namespace shellback::bearing {

void compare(Findings& to, const std::string& key, double value, const Limits& limits,
             const std::string& what, const std::string& cure) {
  if (!(value >= limits.least && value <= limits.most)) {
    to.refuse(key, what + ", which no bearing has", cure);
  } else if (value < limits.usual_least || value > limits.usual_most) {
    to.suspect(key, what + ", which is unusual", cure);
  }
}

}  // namespace shellback::bearing
