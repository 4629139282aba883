// pigment_pattern { PIGMENT }: the grey of a pigment
//
// Value: the grey of its colour at the point, 0...1 for colours in that range; transparency does not count, outside of a `once` image
// it is 0.
// Source: specification chapter 50 §6.
#pragma once

#include <memory>

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Pigment;  // engine/scene/texture.hpp

struct PigmentPattern : PatternDefaults {
  static constexpr std::string_view kKeyword = "pigment_pattern";
  std::shared_ptr<const Pigment> pigment;  // never null
};

double evaluate(const PigmentPattern& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
