// The table of primitives: one line each. The scene description, the statement parser, the builder and the coverage table all
// go through it.
#pragma once

#include <variant>

#include "engine/shape/box.hpp"
#include "engine/shape/cone.hpp"
#include "engine/shape/cylinder.hpp"
#include "engine/shape/disc.hpp"
#include "engine/shape/mesh.hpp"
#include "engine/shape/plane.hpp"
#include "engine/shape/sphere.hpp"
#include "engine/shape/torus.hpp"
#include "engine/shape/triangle.hpp"

namespace lute {

using AnyShape = std::variant<  //
    Box,                        //
    Cone,                       //
    Cylinder,                   //
    Disc,                       //
    Mesh,                       //
    Plane,                      //
    SmoothTriangle,             //
    Sphere,                     //
    Torus,                      //
    Triangle>;

}  // namespace lute
