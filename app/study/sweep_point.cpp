#include "app/study/sweep_point.hpp"

namespace shellback::study {

const char* to_string(Start start) {
  switch (start) {
    case Start::none:
      return "none";
    case Start::cold:
      return "cold";
    case Start::neighbour:
      return "neighbour";
    case Start::between:
      return "between";
  }
  return "";
}

}  // namespace shellback::study
