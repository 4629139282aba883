// The JSON of plain values and of the parts of a scene. Null pointers are null.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "engine/scene/media.hpp"
#include "engine/scene/scene.hpp"

namespace lute::dump {

using Json = nlohmann::json;

// A single-precision value with its own digits: 0.1, not 0.10000000149011612.
Json single(float value);

Json to_json(double value);
Json to_json(float value);
Json to_json(int value);
Json to_json(bool value);
Json to_json(const dvec2& value);
Json to_json(const dvec3& value);
Json to_json(const dvec4& value);
Json to_json(const Rgb& value);    // [r, g, b]
Json to_json(const Color& value);  // [r, g, b, filter, transmit]
Json to_json(const Transform& value);  // null for identity, else the images of x, y, z and the origin

Json to_json(const AnyShape& shape);
Json to_json(const ObjectPtr& object);
Json to_json(const PigmentPtr& pigment);
Json to_json(const NormalPtr& normal);
Json to_json(const FinishPtr& finish);
Json to_json(const TexturePtr& texture);
Json to_json(const TextureOnObject& texture);
Json to_json(const InteriorPtr& interior);
Json to_json(const Media& media);
Json to_json(const WarpChain& chain);
Json to_json(const Turbulence& turbulence);
Json to_json(const ColorMap& map);
Json to_json(const AnyPattern& pattern);

template <class T>
Json to_json(const std::optional<T>& value) {
  return value ? to_json(*value) : Json();
}

template <class T>
Json list(const std::vector<T>& values) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(to_json(value));
  return array;
}

}  // namespace lute::dump
