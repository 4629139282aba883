#include "engine/texture/compiled_pigment.hpp"

#include <algorithm>

#include "engine/texture/texture_compiler.hpp"

namespace lute {
namespace {

bool lets_light_through(const Color& c) { return c.filter != 0 || c.transmit != 0; }

}  // namespace

CompiledPigment::CompiledPigment(const Pigment& pigment, TextureCompiler& compiler) {
  // Quick colours replace the pigment at low quality, if any of their channels was set.
  const Color* plain = std::get_if<Color>(&pigment.map);
  if (compiler.quick_colors() && pigment.quick_color) plain = &*pigment.quick_color;
  if (plain != nullptr) {
    constant_ = *plain;
    opaque_ = !lets_light_through(constant_);
    return;
  }
  if (std::holds_alternative<NoPattern>(pigment.body.pattern)) return;  // a pigment without type is black

  pattern_ = std::make_unique<CompiledPattern>(pigment.body, compiler);
  if (const AnyPattern* any = pattern_->pattern()) image_ = std::get_if<ImageMap>(any);
  if (image_ != nullptr) {
    kind_ = Kind::kImage;
    opaque_ = lute::is_opaque(*image_);
  } else if (const auto* map = std::get_if<PigmentMap>(&pigment.map)) {
    take_pigments(*map, compiler);
  } else {
    kind_ = Kind::kColors;
    const auto* colors = std::get_if<ColorMap>(&pigment.map);
    colors_ = colors != nullptr ? colors->entries : default_color_map(pigment.body).entries;
    for (const auto& entry : colors_) opaque_ = opaque_ && !lets_light_through(entry.value);
  }
}

void CompiledPigment::take_pigments(const PigmentMap& map, TextureCompiler& compiler) {
  kind_ = pattern_->is_average() ? Kind::kAverage : pattern_->is_uv_mapping() ? Kind::kUv : Kind::kPigments;
  for (const auto& entry : map.entries) {
    pigments_.push_back({entry.position, compiler.pigment(entry.value)});
    opaque_ = opaque_ && pigments_.back().pigment->is_opaque();
  }
  // A map of plain colours needs no pigments.
  const bool all_constant = std::all_of(pigments_.begin(), pigments_.end(), [](const auto& e) { return e.pigment->is_constant(); });
  if (kind_ != Kind::kPigments || !all_constant) return;
  kind_ = Kind::kColors;
  for (const PigmentEntry& entry : pigments_) colors_.push_back({entry.position, entry.pigment->constant_});
}

bool CompiledPigment::evaluate_pattern(const dvec3& point, const SurfaceContext& surface, Color& color) const {
  if (kind_ == Kind::kUv) return pigments_.front().pigment->evaluate({surface.uv.x, surface.uv.y, 0}, surface, color);
  const dvec3 warped = pattern_->warp(point);
  switch (kind_) {
    case Kind::kImage: return map_color(*image_, warped, color);
    case Kind::kAverage: average(warped, surface, color); break;
    case Kind::kPigments: blend(warped, surface, color); break;
    default: look_up(pattern_->value(warped, surface), color); break;
  }
  return true;
}

void CompiledPigment::look_up(double value, Color& color) const {
  const auto n = find_neighbours(std::span<const ColorMap::Entry>(colors_), value);
  if (n.single()) {
    color = n.current->value;
    return;
  }
  const Color& a = n.previous->value;
  const Color& b = n.current->value;
  color = a + Color{b.rgb - a.rgb, b.filter - a.filter, b.transmit - a.transmit} * static_cast<float>(n.t);
}

void CompiledPigment::blend(const dvec3& warped, const SurfaceContext& surface, Color& color) const {
  const auto n = find_neighbours(std::span<const PigmentEntry>(pigments_), pattern_->value(warped, surface));
  // An image shown once counts as clear inside a map (chapter 50 §11.1): what evaluate() leaves in the colour.
  n.current->pigment->evaluate(warped, surface, color);
  if (n.single()) return;
  Color previous;
  n.previous->pigment->evaluate(warped, surface, previous);
  color = previous * static_cast<float>(1 - n.t) + color * static_cast<float>(n.t);
}

void CompiledPigment::average(const dvec3& warped, const SurfaceContext& surface, Color& color) const {
  Color sum;
  float total = 0;
  for (const PigmentEntry& entry : pigments_) {
    Color c;
    entry.pigment->evaluate(warped, surface, c);
    sum += c * entry.position;
    total += entry.position;
  }
  color = sum * (1 / total);
}

}  // namespace lute
