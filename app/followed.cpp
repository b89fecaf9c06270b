#include "app/followed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/labels/quantity_label.hpp"

namespace shellback::app {

bool KnownAtEnds::met() const {
  return laminar && std::all_of(parts.begin(), parts.end(),
                                [&](const Part& part) { return part.bar <= asked; });
}

std::vector<std::string> KnownAtEnds::words() const {
  std::string missed, open;
  for (const Part& part : parts) {
    if (!part.known) open += fmt::format("{}{}", open.empty() ? "" : ", ", part.label);
    if (part.bar <= asked) continue;
    missed += fmt::format("{}{} +-{} %{}{}", missed.empty() ? "" : ", ", part.label,
                          figures(100.0 * part.bar, 2), part.known ? "" : " at least",
                          part.by_steps ? " (most of it the steps in time)" : "");
  }
  if (!laminar) missed += std::string(missed.empty() ? "" : ", ") + "the film is not laminar";
  std::vector<std::string> all;
  if (!missed.empty()) {
    all.push_back(
        fmt::format("model.tolerance ({:.3g} %) is not met at the end: {}", 100.0 * asked, missed));
  }
  if (!open.empty()) {
    all.push_back(fmt::format(
        "the bars of {} are not known whole at the end: a run with doubled steps or on a coarser "
        "grid that they need ended before; that model.tolerance is met is not shown",
        open));
  }
  return all;
}

json_parts::Json KnownAtEnds::json() const {
  json_parts::Json json{{"asked", asked}, {"met", nullptr}};
  if (!parts.empty() && (all || !met())) json["met"] = met();
  for (const Part& part : parts) {
    json[part.name] = part.known ? json_parts::number(part.bar) : json_parts::Json(nullptr);
  }
  return json;
}

}  // namespace shellback::app
