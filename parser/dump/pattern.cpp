// Patterns with their parameters, and warps.
#include <type_traits>

#include "engine/function/function.hpp"
#include "parser/dump/values.hpp"

namespace lute::dump {
namespace {

Json mapping(const ImageMapping& m) {
  return {{"width", m.image->width()}, {"height", m.image->height()}, {"once", m.once}, {"map_type", m.map_type},
          {"interpolate", m.interpolate}, {"use_index", m.use_index}, {"repeat", to_json(m.repeat)}, {"offset", to_json(m.offset)}};
}

Json fractal(const FractalSettings& p) {
  return {{"iterations", p.iterations}, {"exterior", {p.exterior_type, p.exterior_factor}},
          {"interior", {p.interior_type, p.interior_factor}}};
}

template <class Pattern>
Json parameters(const Pattern&) {
  static_assert(std::is_empty_v<Pattern>, "a pattern shows its parameters");
  return Json::object();
}
Json parameters(const Agate& p) { return {{"agate_turb", single(p.turbulence)}}; }
Json parameters(const Brick& p) { return {{"brick_size", to_json(p.size)}, {"mortar", single(p.mortar)}}; }
Json parameters(const Crackle& p) {
  return {{"form", to_json(p.form)}, {"metric", p.metric}, {"offset", p.offset}, {"solid", p.solid}};
}
Json parameters(const DensityFile& p) { return {{"interpolate", p.interpolate}}; }
Json parameters(const Facets& p) { return {{"size", single(p.size)}, {"coords", single(p.coords)}, {"metric", p.metric}}; }
// An expression has no text any more.
Json parameters(const FunctionPattern& p) {
  return {{"parameters", p.function->parameter_count()}, {"results", p.function->result_count()}};
}
Json parameters(const Gradient& p) { return {{"direction", to_json(p.direction)}}; }
Json parameters(const Quilted& p) { return {{"control0", single(p.control0)}, {"control1", single(p.control1)}}; }
Json parameters(const Spiral1& p) { return {{"arms", p.arms}}; }
Json parameters(const Spiral2& p) { return {{"arms", p.arms}}; }
Json parameters(const Mandel& p) {
  Json json = fractal(p);
  json["exponent"] = p.exponent;
  return json;
}
Json parameters(const Julia& p) {
  Json json = fractal(p);
  json["exponent"] = p.exponent;
  json["c"] = to_json(p.c);
  return json;
}
Json parameters(const Magnet& p) {
  Json json = fractal(p);
  json["type"] = p.type;
  json["julia"] = to_json(p.julia);
  return json;
}
Json parameters(const Slope& p) {
  return {{"vector", to_json(p.vector)}, {"point_at", p.point_at}, {"range", {p.low, p.high}}, {"altitude", to_json(p.altitude)},
          {"altitude_range", {p.altitude_low, p.altitude_high}}};
}
Json parameters(const Tiling& p) { return {{"number", p.number}}; }
Json parameters(const Pavement& p) {
  return {{"sides", p.sides}, {"tiles", p.tiles}, {"pattern", p.pattern}, {"form", p.form}, {"interior", p.interior},
          {"exterior", p.exterior}};
}
Json parameters(const ObjectPattern& p) { return {{"object", to_json(p.object)}}; }
Json parameters(const PigmentPattern& p) { return {{"pigment", to_json(p.pigment)}}; }
Json parameters(const ImageMap& p) {
  Json json = mapping(p.mapping);
  json["filter_all"] = to_json(p.transparency.filter_all);
  json["transmit_all"] = to_json(p.transparency.transmit_all);
  return json;
}
Json parameters(const ImagePattern& p) {
  Json json = mapping(p.mapping);
  json["use_alpha"] = p.use_alpha;
  return json;
}
Json parameters(const BumpMap& p) { return mapping(p.mapping); }
Json parameters(const MaterialMap& p) { return mapping(p.mapping); }

Json turbulence(const Turbulence& t) {
  return {{"amount", to_json(t.amount)}, {"octaves", t.octaves}, {"omega", single(t.omega)}, {"lambda", single(t.lambda)}};
}

Json warp(const Transform& w) { return {{"transform", to_json(w)}}; }
Json warp(const ClassicTurbulence& w) { return {{"turbulence", turbulence(w)}}; }
Json warp(const TurbulenceWarp& w) { return {{"warp_turbulence", turbulence(w)}}; }
Json warp(const RepeatWarp& w) {
  return {{"repeat", {{"axis", w.axis}, {"width", single(w.width)}, {"flip", to_json(w.flip)}, {"offset", to_json(w.offset)}}}};
}
Json warp(const BlackHoleWarp& w) {
  return {{"black_hole",
           {{"center", to_json(w.center)}, {"radius", w.radius}, {"strength", w.strength}, {"falloff", w.falloff},
            {"inverse", w.inverse}, {"type", w.type}, {"repeat", to_json(w.repeat)}, {"turbulence", to_json(w.turbulence)}}}};
}
Json warp(const PlanarWarp& w) { return {{"planar", {{"orientation", to_json(w.orientation)}, {"offset", w.offset}}}}; }
Json warp(const CylindricalWarp& w) { return {{"cylindrical", {{"orientation", to_json(w.orientation)}, {"dist_exp", w.dist_exp}}}}; }
Json warp(const SphericalWarp& w) { return {{"spherical", {{"orientation", to_json(w.orientation)}, {"dist_exp", w.dist_exp}}}}; }
Json warp(const ToroidalWarp& w) {
  return {{"toroidal", {{"orientation", to_json(w.orientation)}, {"dist_exp", w.dist_exp}, {"major_radius", w.major_radius}}}};
}
Json warp(const CubicWarp&) { return {{"cubic", Json::object()}}; }

}  // namespace

Json to_json(const AnyPattern& pattern) {
  return std::visit(
      [](const auto& p) {
        Json json = parameters(p);
        json["name"] = p.kKeyword;
        return json;
      },
      pattern);
}

Json to_json(const WarpChain& chain) {
  Json array = Json::array();
  for (const Warp& w : chain) array.push_back(std::visit([](const auto& x) { return warp(x); }, w));
  return array;
}

Json to_json(const Turbulence& t) { return turbulence(t); }

}  // namespace lute::dump
