#include "parser/statement/primitive.hpp"

#include <array>

#include "parser/statement/curved_shape.hpp"
#include "parser/statement/simple_shape.hpp"
#include "parser/statement/surface_shape.hpp"
#include "parser/statement/text.hpp"

namespace lute {
namespace {

template <auto parse_body>
Geometry shape(Reader& reader) {
  return AnyShape(parse_body(reader));
}

template <int order>
Geometry poly_of_order(Reader& reader) {
  return AnyShape(parse_poly_of_order(reader, order));
}

// An egg whose top swallows the rest is a sphere.
Geometry ovus(Reader& reader) {
  const Ovus egg = parse_ovus(reader);
  if (egg.top_radius >= 2 * egg.bottom_radius) return AnyShape(Sphere{dvec3(0, egg.bottom_radius, 0), egg.top_radius});
  return AnyShape(egg);
}

constexpr std::array kPrimitives = {
    Primitive{Word::kBicubicPatch, shape<parse_bicubic_patch>},
    Primitive{Word::kBlob, shape<parse_blob>},
    Primitive{Word::kBox, shape<parse_box>},
    Primitive{Word::kCone, shape<parse_cone>},
    Primitive{Word::kCubic, poly_of_order<3>},
    Primitive{Word::kCylinder, shape<parse_cylinder>},
    Primitive{Word::kDisc, shape<parse_disc>},
    Primitive{Word::kHeightField, shape<parse_height_field>},
    Primitive{Word::kIsosurface, shape<parse_isosurface>},
    Primitive{Word::kJuliaFractal, shape<parse_julia_fractal>},
    Primitive{Word::kLathe, shape<parse_lathe>},
    Primitive{Word::kMesh, shape<parse_mesh>},
    Primitive{Word::kMesh2, shape<parse_mesh2>},
    Primitive{Word::kOvus, ovus},
    Primitive{Word::kParametric, shape<parse_parametric>},
    Primitive{Word::kPlane, shape<parse_plane>},
    Primitive{Word::kPoly, shape<parse_poly>},
    Primitive{Word::kPolygon, shape<parse_polygon>},
    Primitive{Word::kPolynomial, shape<parse_polynomial>},
    Primitive{Word::kPrism, shape<parse_prism>},
    Primitive{Word::kQuadric, shape<parse_quadric>},
    Primitive{Word::kQuartic, poly_of_order<4>},
    Primitive{Word::kSmoothTriangle, shape<parse_smooth_triangle>},
    Primitive{Word::kSor, shape<parse_sor>},
    Primitive{Word::kSphere, shape<parse_sphere>},
    Primitive{Word::kSphereSweep, shape<parse_sphere_sweep>},
    Primitive{Word::kSuperellipsoid, shape<parse_superellipsoid>},
    Primitive{Word::kText, shape<parse_text>},
    Primitive{Word::kTorus, shape<parse_torus>},
    Primitive{Word::kTriangle, shape<parse_triangle>},
};

}  // namespace

std::span<const Primitive> primitives() { return kPrimitives; }

}  // namespace lute
