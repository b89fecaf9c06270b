#include <fmt/format.h>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/sections.hpp"

namespace shellback::app {
namespace {

using bearing::RunningIn;

void read_end(const Section& section, RunningIn& r) {
  const std::string words = "\"worn_in\" or a time, \"200 s\"";
  if (!section.has("until")) section.fail_missing("until", words);
  if (section.is_text("until") && section.text("until") == "worn_in") {
    r.limit_pressure = section.quantity("limit_pressure", kPressure.such_as("5 MPa"), kPositive);
    return;
  }
  if (section.is_text("until") && section.text("until").find_first_of("+-.0123456789") != 0) {
    const std::string text = section.text("until");
    section.fail("until", fmt::format("{} is neither \"worn_in\" nor a time such as \"200 s\"{}",
                                      in_quotes(text), did_you_mean(text, {"worn_in"})));
  }
  r.duration = section.quantity("until", kTime, kPositive);
  r.limit_pressure =
      section.quantity_or("limit_pressure", kPressure.such_as("5 MPa"), 0.0, "", kPositive);
}

}  // namespace

std::optional<bearing::RunningIn> read_running_in(const Section& file) {
  const auto section = file.maybe_section("running_in");
  if (!section) return std::nullopt;
  section->only({"wear_coefficient", "hardness", "until", "limit_pressure", "worn", "worn_after"},
                "[running_in]");
  RunningIn r;
  r.wear_coefficient = section->quantity("wear_coefficient", kNumber.such_as("1e-8"), kPositive);
  r.hardness = section->quantity_or("hardness", kPressure.such_as("150 MPa"), 0.0, "", kPositive);
  read_end(*section, r);
  if (const auto worn = section->maybe_section("worn")) {
    r.worn = read_surface(*worn, "running_in.worn", false);
    r.worn_after = section->quantity("worn_after", kLength.such_as("1 um"), kPositive);
  } else if (section->has("worn_after")) {
    section->fail("worn_after", "it belongs to the surface in running_in.worn, which is not given");
  }
  return r;
}

}  // namespace shellback::app
