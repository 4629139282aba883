// bump_map { IMAGE ... }, normals only: the image as heights
//
// Value (in a normal_map): the height 0...1, grey or palette index; 0 outside of a `once` image. The normal itself is tilted by the
// heights of three neighbouring pixels times bump_size. mapping: how the image lies (engine/texture/image_mapping.hpp).
// Source: specification chapter 50 §11.4.
#pragma once

#include "engine/texture/image_mapping.hpp"
#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct BumpMap : PatternDefaults {
  static constexpr std::string_view kKeyword = "bump_map";
  static constexpr float kFrequency = 0;
  ImageMapping mapping;
};

double evaluate(const BumpMap& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const BumpMap& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
