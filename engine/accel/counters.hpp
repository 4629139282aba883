// What a render did: counted for each thread, added up at the end (--stats).
#pragma once

#include <cstdint>

namespace lute {

struct Counters {
  std::uint64_t camera_rays = 0, reflected_rays = 0, refracted_rays = 0, transmitted_rays = 0, shadow_rays = 0;
  std::uint64_t box_tests = 0, solid_tests = 0, hits = 0;
  int deepest_level = 0;

  void add(const Counters& other) {
    camera_rays += other.camera_rays;
    reflected_rays += other.reflected_rays;
    refracted_rays += other.refracted_rays;
    transmitted_rays += other.transmitted_rays;
    shadow_rays += other.shadow_rays;
    box_tests += other.box_tests;
    solid_tests += other.solid_tests;
    hits += other.hits;
    if (other.deepest_level > deepest_level) deepest_level = other.deepest_level;
  }
};

}  // namespace lute
