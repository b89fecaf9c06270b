#include "app/reading/identify_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/units.hpp"
#include "bearing/bearing.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::app {
namespace {

std::vector<std::string> parted(const std::string& text, char by) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == by) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The node at a dotted key; entries of lists by number.
const toml::node* node_at(const toml::table& root, const std::string& key) {
  const toml::node* at = &root;
  for (const std::string& part : parted(key, '.')) {
    if (at == nullptr) return nullptr;
    if (const toml::table* table = at->as_table()) {
      at = table->get(part);
    } else if (const toml::array* list = at->as_array()) {
      std::size_t index = 0;
      const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
      const bool number = error == std::errc{} && end == part.data() + part.size();
      at = number && index < list->size() ? list->get(index) : nullptr;
    } else {
      return nullptr;
    }
  }
  return at;
}

/// "; did you mean ...?" of the section in which the key was looked for, or nothing.
std::string near_to(const toml::table& root, const std::string& key) {
  const std::size_t dot = key.rfind('.');
  const bool inside = dot != std::string::npos;
  const toml::node* const at = inside ? node_at(root, key.substr(0, dot)) : &root;
  if (at == nullptr || !at->is_table()) return "";
  std::vector<std::string> known;
  for (const auto& [name, value] : *at->as_table()) {
    known.push_back((inside ? key.substr(0, dot + 1) : "") + std::string(name.str()));
  }
  return did_you_mean(key, known);
}

NumberAndUnit value_in_case(const toml::table& root, const std::string& key) {
  const std::string place = "--fit " + key;
  const toml::node* node = node_at(root, key);
  if (node == nullptr) {
    throw InputError(place, fmt::format("the case has no {} to begin with; give it there or with "
                                        "--set {}=VALUE{}",
                                        key, key, near_to(root, key)));
  }
  if (const auto number = node->value<double>()) return {*number, ""};
  const auto text = node->value<std::string>();
  const auto apart = text ? number_and_unit(*text) : std::nullopt;
  if (!apart)
    throw InputError(place,
                     fmt::format("{} is no number with its unit, and cannot be fitted", key));
  return *apart;
}

double bound(const std::string& text, const std::string& place, const std::string& unit) {
  const auto apart = number_and_unit(text);
  if (!apart) {
    throw InputError(place, fmt::format("{} is no number; write KEY=LOW:HIGH", in_quotes(text)));
  }
  if (!apart->unit.empty() && apart->unit != unit) {
    throw InputError(place, fmt::format("the bound is in {}, but the case has the key in {}; give "
                                        "both in one unit",
                                        apart->unit, unit.empty() ? "no unit" : unit));
  }
  return apart->number;
}

std::map<std::string, std::string> bounds_by_key(const std::vector<std::string>& bounds) {
  std::map<std::string, std::string> all;
  for (const std::string& words : bounds) {
    const std::size_t equal = words.find('=');
    const std::string place = "--bounds " + words.substr(0, equal);
    if (equal == std::string::npos || equal == 0 || words.find(':', equal) == std::string::npos) {
      throw InputError("--bounds", fmt::format("{} is not KEY=LOW:HIGH; write for example --bounds "
                                               "surfaces.contact.friction=0.001:0.2",
                                               in_quotes(words)));
    }
    if (!all.emplace(words.substr(0, equal), words.substr(equal + 1)).second) {
      throw InputError(place, "the bounds of this key are given twice; keep one of them");
    }
  }
  return all;
}

FittedKey bounded(const std::string& key, const NumberAndUnit& start, const std::string& words) {
  const std::string place = "--bounds " + key;
  const std::size_t colon = words.find(':');
  const bool any_zero = start.unit.starts_with("deg") || start.unit.starts_with("°") ||
                        start.unit == "rad" || start.unit == "mrad";  // temperatures and angles
  FittedKey out{key, start.unit, {start.number, 0.0, 0.0, !any_zero}};
  out.value.low = bound(words.substr(0, colon), place, start.unit);
  out.value.high = bound(words.substr(colon + 1), place, start.unit);
  if (!(out.value.low < out.value.high)) {
    throw InputError(place, fmt::format("the lower bound {} is not below the upper bound {}",
                                        out.words(out.value.low), out.words(out.value.high)));
  }
  if (!(out.value.low < start.number && start.number < out.value.high)) {
    throw InputError(place, fmt::format("the search starts at {}, the value in the case, which is "
                                        "not between {} and {}; widen the bounds or give another "
                                        "value with --set",
                                        out.words(start.number), out.words(out.value.low),
                                        out.words(out.value.high)));
  }
  return out;
}

/// The keys of --fit; the bounds of KEY=FROM..TO join those of --bounds.
std::vector<std::string> keys_named(const std::vector<std::string>& fit,
                                    std::map<std::string, std::string>& bounds) {
  std::vector<std::string> keys;
  for (const std::string& words : fit) {
    for (const std::string& part : parted(words, ',')) {
      const std::size_t equal = part.find('=');
      const std::string key = part.substr(0, equal);
      if (key.empty()) throw InputError("--fit", "a key is empty; write --fit KEY,KEY");
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
        throw InputError("--fit", fmt::format("{} is named twice", key));
      }
      keys.push_back(key);
      if (equal == std::string::npos) continue;
      const std::string range = part.substr(equal + 1);
      const std::size_t dots = range.find("..");
      if (dots == std::string::npos) {
        throw InputError("--fit " + key,
                         fmt::format("{} is no range; write --fit KEY=FROM..TO", in_quotes(range)));
      }
      if (!bounds.emplace(key, range.substr(0, dots) + ":" + range.substr(dots + 2)).second) {
        throw InputError("--fit " + key, "its bounds are given by --bounds, too; keep one of them");
      }
    }
  }
  return keys;
}

/// Where nobody has said what is possible: a decade to each side, of temperatures 50 K.
std::string usual_bounds(const std::string& key, const NumberAndUnit& start) {
  constexpr double kDecade = 10.0, kKelvins = 50.0;
  const auto between = [](double low, double high) {
    return fmt::format("{:.6g}:{:.6g}", low, high);
  };
  if (start.unit == "degC" || start.unit == "K") {
    return between(start.number - kKelvins, start.number + kKelvins);
  }
  const bool angle = start.unit == "deg" || start.unit == "rad" || start.unit == "mrad";
  if (start.number == 0.0 || angle) {
    throw InputError("--fit " + key,
                     fmt::format("bounds are missing, and none are usual for {:.6g} {}; give --fit "
                                 "{}=FROM..TO",
                                 start.number, start.unit, key));
  }
  const double near = start.number / kDecade, far = start.number * kDecade;
  return between(std::min(near, far), std::max(near, far));
}

void expect_not_measured(const std::string& key, const MeasuredTable& table) {
  for (const MeasuredInput& input : table.inputs) {
    if (std::find(input.keys.begin(), input.keys.end(), key) == input.keys.end()) continue;
    throw InputError("--fit " + key, fmt::format("the column {} of {} gives this key at every "
                                                 "point; it cannot be fitted as well",
                                                 input.column, table.path));
  }
}

}  // namespace

std::string FittedKey::words(double x) const {
  const std::string number = fmt::format("{:.15g}", x);
  return unit.empty() ? number : number + " " + unit;
}

std::vector<FittedKey> fitted_keys(const std::string& text, const std::string& path,
                                   const std::vector<Override>& set,
                                   const std::vector<std::string>& fit,
                                   const std::vector<std::string>& bounds,
                                   const MeasuredTable& table) {
  toml::table root = parse_toml(text, path);
  for (const Override& change : set) apply_override(root, change);
  std::map<std::string, std::string> limits = bounds_by_key(bounds);
  const std::vector<std::string> fitted = keys_named(fit, limits);
  for (const auto& [key, words] : limits) {
    if (std::find(fitted.begin(), fitted.end(), key) != fitted.end()) continue;
    throw InputError("--bounds " + key,
                     "this key is not fitted; name it in --fit" + did_you_mean(key, fitted));
  }
  std::vector<FittedKey> keys;
  for (const std::string& key : fitted) {
    expect_not_measured(key, table);
    const NumberAndUnit start = value_in_case(root, key);
    const auto own = limits.find(key);
    const bool told = own != limits.end();
    keys.push_back(bounded(key, start, told ? own->second : usual_bounds(key, start)));
    keys.back().usual_bounds = !told;
  }
  return keys;
}

std::vector<std::string> keys_that_move_cells(const study::MeasuredCase& case_at,
                                              const std::vector<FittedKey>& keys,
                                              const std::vector<double>& x) {
  // Cells with one of them as unit, all around and all along: a wider bearing has wider cells.
  const auto cells = [&](std::size_t k, double value) -> std::vector<double> {
    std::vector<double> at = x;
    at[k] = value;
    const bearing::Case c = case_at(0.0, at);
    if (!holds_supplies(c, c.model.grid)) return {};
    const FilmGrid g = film_grid(c, c.model.grid);
    std::vector<double> parts;
    for (const double d : g.dphi) parts.push_back(d / (2.0 * kPi));
    for (const double d : g.dz) parts.push_back(d / c.bearing.width);
    return parts;
  };
  const auto alike = [](double a, double b) { return std::abs(a - b) < kRoundOff; };
  std::vector<std::string> moving;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto low = cells(k, keys[k].value.low);
    const auto high = cells(k, keys[k].value.high);
    if (!std::equal(low.begin(), low.end(), high.begin(), high.end(), alike)) {
      moving.push_back(keys[k].key);
    }
  }
  return moving;
}

study::MeasuredCase measured_case(std::string text, std::string path, std::vector<Override> set,
                                  MeasuredTable table, std::vector<FittedKey> keys) {
  return
      [text = std::move(text), path = std::move(path), set = std::move(set),
       table = std::move(table), keys = std::move(keys)](double at, const std::vector<double>& x) {
        std::vector<Override> all = set;
        for (Override& change : table.overrides_at(at)) all.push_back(std::move(change));
        for (std::size_t k = 0; k < keys.size(); ++k) {
          all.push_back({keys[k].key, keys[k].words(x[k]), "--fit " + keys[k].key});
        }
        return read_case_text(text, path, all);
      };
}

}  // namespace shellback::app
