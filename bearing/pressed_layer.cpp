#include "bearing/pressed_layer.hpp"

namespace shellback::bearing {
namespace {

double total(const Field& p, const Field& p_contact, std::size_t c) {
  return p[c] + (p_contact.empty() ? 0.0 : p_contact[c]);
}

}  // namespace

void add(double f, const Columns& k, Columns& to) {
  for (std::size_t c = 0; c < to.size(); ++c) {
    to[c].elastic += f * k[c].elastic;
    to[c].plastic += f * k[c].plastic;
  }
}

void PressedLayer::hold(int cells) {
  // (1) with r_p of a tenth of the thickness, c_y some E/s: 1e-5 E, 2e-4 of a polymer's hardness.
  constexpr double kHeld = 1e4;  // [delta]
  own = kHeld * law.damping_ratio;
  before.assign(cells, {});
}

std::vector<solid::PressedColumn> PressedLayer::press(const Field& p,
                                                      const Field& p_contact) const {
  std::vector<solid::PressedColumn> found(p.size());
  for (std::size_t c = 0; c < p.size(); ++c) {
    found[c] = solid::press(law, total(p, p_contact, c), own, before[c]);
  }
  return found;
}

std::optional<PressedLayer> pressed_layer(const Case& c, int cells) {
  if (!c.shell || c.shell->layers.empty() || !c.shell->layers.front().elasto_plastic) {
    return std::nullopt;
  }
  const ShellLayer& first = c.shell->layers.front();
  const solid::Material& m = first.material;
  PressedLayer layer;
  layer.law = {first.thickness, m.youngs_modulus, m.hardness, m.progression, m.damping_ratio};
  layer.hold(cells);
  return layer;
}

LayerInTime stage_of(const PressedLayer& layer, const FilmGrid& g, const Field& p,
                     const Field& p_contact, const std::vector<solid::PressedColumn>& found) {
  LayerInTime stage;
  stage.slope.resize(found.size());
  for (std::size_t c = 0; c < found.size(); ++c) {
    const solid::LayerColumn& now = found[c].now;
    const solid::LayerColumn& before = layer.before[c];
    stage.now.push_back(now);
    stage.slope[c] = {(now.elastic - before.elastic) / layer.own,
                      (now.plastic - before.plastic) / layer.own};
    const int cell = static_cast<int>(c);
    stage.loss +=
        g.area(cell) * solid::layer_loss(layer.law, total(p, p_contact, c), now, stage.slope[c]);
  }
  return stage;
}

Field lasting_depth(const Columns& columns) {
  Field depth;
  depth.reserve(columns.size());
  for (const solid::LayerColumn& c : columns) depth.push_back(c.plastic);
  return depth;
}

Field lasting_depth(const std::vector<solid::PressedColumn>& found) {
  Field depth;
  depth.reserve(found.size());
  for (const solid::PressedColumn& c : found) depth.push_back(c.now.plastic);
  return depth;
}

}  // namespace shellback::bearing
