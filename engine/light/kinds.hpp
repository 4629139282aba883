// The kinds of light, one file each. Source: specification chapter 40 §10.
#pragma once

#include "engine/light/light.hpp"

namespace lute {

// parallel.cpp: all rays of the light are parallel; `direct` is the path that the light would have without.
LightPath parallel_path(const BuiltLight& light, const dvec3& sample, const LightPath& direct);

// spot.cpp: a cone with a soft edge.
double spot_factor(const BuiltLight& light, const LightPath& path);

// cylinder.cpp: parallel rays inside a cylinder with a soft edge.
LightPath cylinder_path(const BuiltLight& light, const dvec3& point);
double cylinder_factor(const BuiltLight& light, const dvec3& point);

// The soft edge: 0 below lo, 1 from hi on, smooth between.
double smooth_edge(double lo, double hi, double v);

// fade_distance and fade_power: 1 at fade_distance, at most 2.
double fade_factor(const BuiltLight& light, double distance);

}  // namespace lute
