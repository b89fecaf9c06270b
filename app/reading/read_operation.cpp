#include "app/reading/sections.hpp"
#include "bearing/case_limits.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

constexpr double kDownwards = 1.5 * kPi;  ///< 270 deg, along -Y [rad]

double load_angle(const Section& section) {
  return section.quantity_or("load_angle", kAngle, kDownwards,
                             "the load is taken to act downwards on the journal "
                             "(load_angle = 270 deg)",
                             kValueRanges.turn);
}

std::variant<LoadGiven, EccentricityGiven> read_position(const Section& section) {
  const bool load = section.has("load");
  const bool ratio = section.has("eccentricity_ratio");
  if (load && ratio) {
    section.fail("eccentricity_ratio",
                 "the load is given too, and each follows from the other; keep one of them");
  }
  if (!load && !ratio) {
    section.fail("load",
                 "neither load nor eccentricity_ratio is given; add for example load = "
                 "\"8 kN\"");
  }
  if (load) {
    Range loaded = kPositive;
    loaded.words = "be positive; a journal without load has eccentricity_ratio = 0";
    return LoadGiven{section.quantity("load", kForce, loaded), load_angle(section)};
  }
  EccentricityGiven given;
  given.ratio = section.quantity("eccentricity_ratio", kNumber.such_as("0.6"),
                                 kValueRanges.eccentricity_ratio);
  given.attitude = section.quantity("attitude_angle", kAngle, kValueRanges.turn);
  given.load_angle = load_angle(section);
  return given;
}

std::variant<TiltGiven, MomentGiven> read_alignment(const Section& section) {
  if (section.has("tilt") && section.has("moment")) {
    section.fail("moment", "the tilt is given too, and each follows from the other; keep one");
  }
  if (const auto moment = section.maybe_section("moment")) {
    moment->only({"about_x", "about_y"}, "operation.moment");
    return MomentGiven{moment->quantity_or("about_x", kTorque, 0.0, ""),
                       moment->quantity_or("about_y", kTorque, 0.0, "")};
  }
  TiltGiven given;
  if (const auto tilt = section.maybe_section("tilt")) {
    tilt->only({"about_x", "about_y"}, "operation.tilt");
    given = {tilt->quantity_or("about_x", kAngle.such_as("0.1 mrad"), 0.0, ""),
             tilt->quantity_or("about_y", kAngle.such_as("0.1 mrad"), 0.0, "")};
  }
  return given;
}

/// The load of a cycle stands elsewhere.
void expect_no_load(const Section& section) {
  for (const char* key : {"load", "load_angle", "eccentricity_ratio", "attitude_angle"}) {
    if (!section.has(key)) continue;
    section.fail(key, "the load comes from [load_cycle] or [crank]; keep one of the two");
  }
}

}  // namespace

Operation read_operation(const Section& file) {
  const Section section = file.section("operation");
  section.only(
      {"speed", "load", "load_angle", "eccentricity_ratio", "attitude_angle", "tilt", "moment"},
      "[operation]");
  Operation operation;
  operation.omega = section.quantity("speed", kSpeed);
  if (file.has("load_cycle") || file.has("crank")) {
    expect_no_load(section);
  } else {
    operation.position = read_position(section);
  }
  operation.alignment = read_alignment(section);
  return operation;
}

}  // namespace shellback::app
