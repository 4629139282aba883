// The primitives of the engine: one line each. The scene description, the plan and the builder go through this table. What the parser
// needs beside it is named at the head of engine/shape/shape.hpp.
#pragma once

#include "engine/memory/shared_variant.hpp"
#include "engine/shape/bicubic_patch.hpp"
#include "engine/shape/blob.hpp"
#include "engine/shape/box.hpp"
#include "engine/shape/cone.hpp"
#include "engine/shape/cylinder.hpp"
#include "engine/shape/disc.hpp"
#include "engine/shape/height_field.hpp"
#include "engine/shape/isosurface.hpp"
#include "engine/shape/julia_fractal.hpp"
#include "engine/shape/lathe.hpp"
#include "engine/shape/mesh.hpp"
#include "engine/shape/ovus.hpp"
#include "engine/shape/parametric.hpp"
#include "engine/shape/plane.hpp"
#include "engine/shape/poly.hpp"
#include "engine/shape/polygon.hpp"
#include "engine/shape/prism.hpp"
#include "engine/shape/quadric.hpp"
#include "engine/shape/sor.hpp"
#include "engine/shape/sphere.hpp"
#include "engine/shape/sphere_sweep.hpp"
#include "engine/shape/superellipsoid.hpp"
#include "engine/shape/text.hpp"
#include "engine/shape/torus.hpp"
#include "engine/shape/triangle.hpp"

namespace lute {

using AnyShape = SharedVariant<  //
    BicubicPatch,               //
    Blob,                       //
    Box,                        //
    Cone,                       //
    Cylinder,                   //
    Disc,                       //
    HeightField,                //
    Isosurface,                 //
    JuliaFractal,               //
    Lathe,                      //
    Mesh,                       //
    Ovus,                       //
    Parametric,                 //
    Plane,                      //
    Poly,                       //
    Polygon,                    //
    Prism,                      //
    Quadric,                    //
    SmoothTriangle,             //
    Sor,                        //
    Sphere,                     //
    SphereSweep,                //
    Superellipsoid,             //
    Text,                       //
    Torus,                      //
    Triangle>;

}  // namespace lute
