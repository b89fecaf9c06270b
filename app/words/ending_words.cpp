#include "app/words/ending_words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/words/branch_words.hpp"
#include "app/words/film_words.hpp"
#include "app/words/heat_words.hpp"
#include "app/words/plain_words.hpp"

namespace shellback::app {

std::string words_of(const FilmPlace& place) {
  if (std::isnan(place.z)) return "";
  const std::string along = fmt::format("z {:.2f} mm", place.z * 1e3);
  if (std::isnan(place.phi)) return along;
  double deg = std::fmod(place.phi * 180.0 / kPi, 360.0);
  if (deg < 0.0) deg += 360.0;
  return fmt::format("phi {:.1f} deg, {}", deg, along);
}

namespace told {

Told told(const Verdict& v) {
  const About about{v, v.cause.empty() ? Told{} : told(v.cause.front())};
  return std::visit([&](const auto& e) { return told(e, about); }, v.ending);
}

}  // namespace told

EndingWords words_of(const Verdict& v) {
  told::Told words = told::told(v);
  return {std::move(words.reason), words_of(v.place), std::move(words.cure)};
}

std::string reason_of(const Verdict& v) { return told::told(v).reason; }

}  // namespace shellback::app
