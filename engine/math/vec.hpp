// Vectors of the engine: GLM in double precision, left-handed as POV-Ray has them (x right, y up, z away).
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lute {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

inline constexpr double kPi = 3.14159265358979323846;

// "Is nearly zero": the tolerance of the scene language and of most geometric tests (specification chapters 10, 20, 40).
inline constexpr double kEpsilon = 1e-10;

// Degrees to radians, with the factor rounded as the reference rounds it.
inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace lute
