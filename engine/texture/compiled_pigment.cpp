#include "engine/texture/compiled_pigment.hpp"

#include "engine/texture/texture_compiler.hpp"

namespace lute {
namespace {

bool lets_light_through(const Color& c) { return c.filter != 0 || c.transmit != 0; }

}  // namespace

CompiledPigment::CompiledPigment(const Pigment& pigment, TextureCompiler& compiler) {
  // Quick colours replace the pigment at low quality, if any of their channels was set.
  if (compiler.quick_colors() && pigment.quick_color) {
    constant_ = *pigment.quick_color;
    opaque_ = !lets_light_through(constant_);
    return;
  }
  if (const auto* plain = std::get_if<Color>(&pigment.map)) {
    constant_ = *plain;
    opaque_ = !lets_light_through(constant_);
    return;
  }
  if (std::holds_alternative<NoPattern>(pigment.body.pattern)) return;  // a pigment without type is black

  pattern_ = std::make_unique<CompiledPattern>(pigment.body, compiler.pattern_settings());
  if (const auto* map = std::get_if<PigmentMap>(&pigment.map)) {
    kind_ = pattern_->is_average() ? Kind::kAverage : pattern_->is_uv_mapping() ? Kind::kUv : Kind::kPigments;
    for (const auto& entry : map->entries) {
      pigments_.push_back({entry.position, compiler.pigment(entry.value)});
      opaque_ = opaque_ && pigments_.back().pigment->is_opaque();
    }
    return;
  }
  kind_ = Kind::kColors;
  const auto* colors = std::get_if<ColorMap>(&pigment.map);
  colors_ = colors != nullptr ? colors->entries : default_color_map(pigment.body).entries;
  for (const auto& entry : colors_) opaque_ = opaque_ && !lets_light_through(entry.value);
}

bool CompiledPigment::evaluate(const dvec3& point, const SurfaceContext& surface, Color& color) const {
  switch (kind_) {
    case Kind::kConstant: color = constant_; return true;
    case Kind::kUv: return pigments_.front().pigment->evaluate({surface.uv.x, surface.uv.y, 0}, surface, color);
    case Kind::kAverage: return averaged(pattern_->warp(point), surface, color);
    case Kind::kPigments: return blended(pattern_->warp(point), surface, color);
    case Kind::kColors: break;
  }
  const dvec3 warped = pattern_->warp(point);
  const auto n = find_neighbours(std::span<const ColorMap::Entry>(colors_), pattern_->value(warped, surface));
  if (n.single()) {
    color = n.current->value;
  } else {
    const Color& a = n.previous->value;
    const Color& b = n.current->value;
    color = a + Color{b.rgb - a.rgb, b.filter - a.filter, b.transmit - a.transmit} * static_cast<float>(n.t);
  }
  return true;
}

bool CompiledPigment::blended(const dvec3& warped, const SurfaceContext& surface, Color& color) const {
  const auto n = find_neighbours(std::span<const PigmentEntry>(pigments_), pattern_->value(warped, surface));
  // An image shown once counts as clear inside a map (chapter 50 §11.1): what evaluate() leaves in the colour.
  n.current->pigment->evaluate(warped, surface, color);
  if (n.single()) return true;
  Color previous;
  n.previous->pigment->evaluate(warped, surface, previous);
  color = previous * static_cast<float>(1 - n.t) + color * static_cast<float>(n.t);
  return true;
}

bool CompiledPigment::averaged(const dvec3& warped, const SurfaceContext& surface, Color& color) const {
  Color sum;
  float total = 0;
  for (const PigmentEntry& entry : pigments_) {
    Color c;
    entry.pigment->evaluate(warped, surface, c);
    sum += c * entry.position;
    total += entry.position;
  }
  color = sum * (1 / total);
  return true;
}

}  // namespace lute
