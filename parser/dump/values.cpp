#include "parser/dump/values.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace lute::dump {

Json single(float value) {
  if (!std::isfinite(value)) return std::isnan(value) ? Json("nan") : Json(value > 0 ? "inf" : "-inf");
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text - 1, value).ptr;
  *end = '\0';
  return std::strtod(text, nullptr);
}

Json to_json(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? Json("nan") : Json(value > 0 ? "inf" : "-inf");
}
Json to_json(float value) { return single(value); }
Json to_json(int value) { return value; }
Json to_json(bool value) { return value; }
Json to_json(const dvec2& v) { return {to_json(v.x), to_json(v.y)}; }
Json to_json(const dvec3& v) { return {to_json(v.x), to_json(v.y), to_json(v.z)}; }
Json to_json(const dvec4& v) { return {to_json(v.x), to_json(v.y), to_json(v.z), to_json(v.w)}; }
Json to_json(const Rgb& c) { return {single(c.r), single(c.g), single(c.b)}; }
Json to_json(const Color& c) { return {single(c.rgb.r), single(c.rgb.g), single(c.rgb.b), single(c.filter), single(c.transmit)}; }

Json to_json(const Transform& t) {
  if (t.identity()) return nullptr;
  return {to_json(t.linear[0]), to_json(t.linear[1]), to_json(t.linear[2]), to_json(t.translation)};
}

}  // namespace lute::dump
