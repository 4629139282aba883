// Background and sky sphere (§12).
#include <algorithm>

#include "engine/shade/shader.hpp"

namespace lute {
namespace {

Color over_background(const BuiltScene& scene, const dvec3& point, bool with_alpha) {
  SurfaceContext nowhere;
  nowhere.ray_direction = point;
  Rgb light{0.0f}, filter{1.0f};
  const auto& pigments = scene.sky->pigments;
  for (auto pigment = pigments.rbegin(); pigment != pigments.rend(); ++pigment) {
    Color c;
    (*pigment)->evaluate(point, nowhere, c);
    light += c.rgb * opacity(c) * filter * scene.sky->emission;
    filter *= pass_through(c);
  }
  const Color& background = scene.background;
  if (!with_alpha) return {light + background.rgb * filter, 0, 0};
  light += background.rgb * opacity(background) * filter;
  filter *= pass_through(background);
  return {light, 0, std::min(1.0f, std::abs(grey(filter)))};
}

// Before version 3.7 the layers were joined by a product of all five channels.
Color over_background_legacy(const BuiltScene& scene, const dvec3& point) {
  SurfaceContext nowhere;
  nowhere.ray_direction = point;
  Rgb light{0.0f};
  Color product{Rgb(1.0f), 1, 1};
  float passing = 1;
  const auto& pigments = scene.sky->pigments;
  for (auto pigment = pigments.rbegin(); pigment != pigments.rend(); ++pigment) {
    Color c;
    (*pigment)->evaluate(point, nowhere, c);
    light += c.rgb * passing * opacity(c);
    product = {product.rgb * c.rgb, product.filter * c.filter, product.transmit * c.transmit};
    passing = std::abs(product.filter) + std::abs(product.transmit);
  }
  return {scene.sky->emission * light + scene.background.rgb * pass_through(product), 0, 0};
}

Color bare_background(const BuiltScene& scene, bool with_alpha) {
  const Color& background = scene.background;
  if (!with_alpha) return {background.rgb, 0, 0};
  return {background.rgb * opacity(background), 0, std::min(1.0f, std::abs(grey(pass_through(background))))};
}

}  // namespace

Color sky_color(const BuiltScene& scene, const dvec3& direction, bool with_alpha) {
  if (scene.settings.legacy && with_alpha) return {Rgb(0.0f), 0, 1};
  if (scene.sky == nullptr || scene.sky->pigments.empty()) return bare_background(scene, with_alpha);
  const dvec3 point = scene.sky->transform.identity() ? direction : scene.sky->transform.inverse_point(direction);
  return scene.settings.legacy ? over_background_legacy(scene, point) : over_background(scene, point, with_alpha);
}

}  // namespace lute
