// The bodies of simple primitives, blobs, meshes and height fields: what stands between `{` and the object's modifiers
// (specification chapters 11 §7, 20 §5, 21).
#pragma once

#include "engine/shape/table.hpp"
#include "parser/reader.hpp"

namespace lute {

Blob parse_blob(Reader& reader);
Box parse_box(Reader& reader);
Cone parse_cone(Reader& reader);
Cylinder parse_cylinder(Reader& reader);
Disc parse_disc(Reader& reader);
HeightField parse_height_field(Reader& reader);
Mesh parse_mesh(Reader& reader);
Mesh parse_mesh2(Reader& reader);
Plane parse_plane(Reader& reader);
SmoothTriangle parse_smooth_triangle(Reader& reader);
Sphere parse_sphere(Reader& reader);
Torus parse_torus(Reader& reader);
Triangle parse_triangle(Reader& reader);

}  // namespace lute
