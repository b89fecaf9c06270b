#include <fmt/format.h>

#include <array>

#include "app/reading/did_you_mean.hpp"
#include "app/reading/units.hpp"
#include "core/contract.hpp"
#include "validation/evaluators/evaluators.hpp"

namespace shellback::validation {
namespace {

constexpr std::array kEvaluators{
    Evaluator{"asperity contact", asperity_contact_values, nullptr},
    Evaluator{"bearings", bearing_values, nullptr},
    Evaluator{"bonded layer", bonded_layer_values, prepare_bonded_layer},
    Evaluator{"elastic ring", elastic_ring_values, nullptr},
    Evaluator{"endlessly wide film", wide_film_values, nullptr},
    Evaluator{"flow factors", flow_factor_values, nullptr},
    Evaluator{"heated Couette film", couette_film_values, nullptr},
    Evaluator{"layered ring", layered_ring_values, prepare_layered_ring},
    Evaluator{"pocket plate", pocket_plate_values, prepare_pocket_plate},
    Evaluator{"pocket slider", pocket_slider_values, prepare_pocket_slider},
    Evaluator{"squeeze film", squeeze_film_values, nullptr},
};

}  // namespace

const Evaluator* find_evaluator(const std::string& name) {
  for (const Evaluator& known : kEvaluators) {
    if (name == known.name) return &known;
  }
  return nullptr;
}

std::vector<std::string> evaluator_names() {
  std::vector<std::string> names;
  for (const Evaluator& known : kEvaluators) names.emplace_back(known.name);
  return names;
}

double Question::number(const std::string& column) const {
  const auto found = point.find(column);
  if (found != point.end()) return found->second;
  throw InputError(entry.table->path(),
                   fmt::format("the evaluator {} needs column {} in every row",
                               app::in_quotes(entry.evaluator), app::in_quotes(column)));
}

std::string word_setting(const Entry& entry, const std::string& name) {
  const auto found = entry.settings.find(name);
  if (found != entry.settings.end()) return found->second;
  throw InputError(entry.folder + "/entry.toml",
                   fmt::format("the evaluator {} needs {} in [settings]",
                               app::in_quotes(entry.evaluator), app::in_quotes(name)));
}

double number_setting(const Entry& entry, const std::string& name) {
  try {
    return app::parse_quantity(word_setting(entry, name), app::kNumber);
  } catch (const app::UnitError& error) {
    throw InputError(entry.folder + "/entry.toml",
                     fmt::format("settings.{}: {}", name, error.what()));
  }
}

}  // namespace shellback::validation
