#include "engine/scene/texture.hpp"

namespace lute {
namespace {

Color rgb(float r, float g, float b) { return {{r, g, b}, 0, 0}; }

ColorMap list(std::initializer_list<Color> colors) {
  ColorMap map;
  for (const Color& c : colors) map.entries.push_back({static_cast<float>(map.entries.size()), c});
  return map;
}

// Chapter 50 §10.3.
template <class Pattern>
ColorMap map_of(const Pattern&) {
  return {{{0, rgb(0, 0, 0)}, {1, rgb(1, 1, 1)}}};
}
ColorMap map_of(const Bozo&) {
  return {{{0.4f, rgb(1, 1, 1)}, {0.4f, rgb(0, 1, 0)}, {0.6f, rgb(0, 1, 0)}, {0.6f, rgb(0, 0, 1)}, {0.8f, rgb(0, 0, 1)}, {0.8f, rgb(1, 0, 0)}}};
}
ColorMap map_of(const Wood&) { return {{{0.6f, rgb(0.666f, 0.312f, 0.2f)}, {0.6f, rgb(0.4f, 0.1333f, 0.066f)}}}; }
ColorMap map_of(const Agate&) {
  return {{{0, rgb(1, 1, 1)}, {0.5f, rgb(0.95f, 0.75f, 0.5f)}, {0.5f, rgb(0.9f, 0.7f, 0.5f)}, {0.6f, rgb(0.9f, 0.7f, 0.4f)},
           {0.6f, rgb(1, 0.7f, 0.4f)}, {1, rgb(0.6f, 0.3f, 0)}}};
}
ColorMap map_of(const Radial&) {
  return {{{0, rgb(0, 1, 1)}, {0.333f, rgb(1, 1, 0)}, {0.666f, rgb(1, 0, 1)}, {1, rgb(0, 1, 1)}}};
}
ColorMap map_of(const Marble&) { return {{{0, rgb(0.9f, 0.8f, 0.8f)}, {0.9f, rgb(0.9f, 0.08f, 0.08f)}, {0.9f, rgb(0, 0, 0)}}}; }
ColorMap map_of(const Brick&) { return list({rgb(0.5f, 0.5f, 0.5f), rgb(0.6f, 0.15f, 0.15f)}); }
ColorMap map_of(const Checker&) { return list({rgb(0, 0, 1), rgb(0, 1, 0)}); }
ColorMap map_of(const ObjectPattern&) { return list({rgb(0, 0, 1), rgb(0, 1, 0)}); }
ColorMap map_of(const Hexagon&) { return list({rgb(0, 0, 1), rgb(0, 1, 0), rgb(1, 0, 0)}); }
ColorMap map_of(const Square&) { return list({rgb(1, 0, 0), rgb(0, 1, 0), rgb(0, 0, 1), rgb(1, 1, 0)}); }
ColorMap six_colors() { return list({rgb(1, 0, 0), rgb(0, 1, 0), rgb(0, 0, 1), rgb(1, 1, 0), rgb(0, 1, 1), rgb(1, 0, 1)}); }
ColorMap map_of(const Triangular&) { return six_colors(); }
ColorMap map_of(const Cubic&) { return six_colors(); }
ColorMap map_of(const Mandel&) {
  return {{{0.001f, rgb(0, 0, 0)}, {0.001f, rgb(0, 1, 1)}, {0.012f, rgb(1, 1, 0)}, {0.015f, rgb(1, 0, 1)}, {0.1f, rgb(0, 1, 1)}}};
}

// Only the classic set, of exponent 2, has its own colours.
bool has_plain_colors(const PatternBody& body) {
  const auto* pattern = std::get_if<AnyPattern>(&body.pattern);
  if (pattern == nullptr) return true;
  const auto* mandel = std::get_if<Mandel>(pattern);
  return mandel != nullptr && mandel->exponent != 2;
}

}  // namespace

const ColorMap& default_color_map(const PatternBody& body) {
  static const ColorMap black_to_white{{{0, rgb(0, 0, 0)}, {1, rgb(1, 1, 1)}}};
  if (has_plain_colors(body)) return black_to_white;
  return std::visit(
      [](const auto& p) -> const ColorMap& {
        static const ColorMap map = map_of(p);
        return map;
      },
      std::get<AnyPattern>(body.pattern));
}

}  // namespace lute
