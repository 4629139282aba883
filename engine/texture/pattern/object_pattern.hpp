// object { OBJECT outside, inside }: whether a point is inside an object
//
// Value: 1 inside, 0 outside; not processed by frequency, phase and wave.
// Source: specification chapter 50 §6.
#pragma once

#include <memory>

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Object;  // engine/scene/object.hpp

struct ObjectPattern : PatternDefaults {
  static constexpr std::string_view kKeyword = "object";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 2;  // outside, inside
  std::shared_ptr<const Object> object;  // never null
};

double evaluate(const ObjectPattern& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
