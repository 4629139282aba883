#include <cstdio>

#include "tests/extreme/closed_form.hpp"
#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {
namespace {

constexpr const char* kBands = "exact, but for band edges to 1e-9";
constexpr const char* kUlp = "exact, but for rims to 1e-15";
// A pixel is 0.05 units wide, and about 300 of the 4800 lie on an edge of an object or a shadow.
constexpr const char* kScaled =
    "0.125 %: at ordinary scale shadows keep 1e-3 from their ends, as in POV-Ray: 2 % of the width of a pixel, for 300 pixels on edges";
constexpr double kAllowedScaled = 0.02 * 300 / (kWidth * kHeight);
// Without its lamp's shadows the glass is off in a third of the pixels.
constexpr const char* kRefractingScaled =
    "0.25 %: as for the others, and as much for refracted rays, which pass what is nearer than 1e-4, as in POV-Ray";
constexpr const char* kMoved = "none: coordinates of 1e8 have a grain of 1.5e-8, a pixel is 0.05 wide";
constexpr const char* kTurned = "none: a turn is off by 1e-15, a pixel is 0.05 wide";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

Symmetry scaled() {
  Symmetry variants;
  for (int k = -9; k <= 9; ++k) {
    if (k != 0) variants.push_back({"10^" + std::to_string(k), {"Exponent=" + std::to_string(k)}});
  }
  return variants;
}

Symmetry moved() {
  Symmetry variants;
  for (const double by : {1e2, 1e4, 1e6, 1e8}) variants.push_back({"by " + number(by), {"Distance=" + number(by)}});
  return variants;
}

Symmetry turned() {
  Symmetry variants{{"mirrored", {"Mirrored=1"}}};
  for (const int angle : {1, 17, 64, 90}) {
    variants.push_back({"turned " + std::to_string(angle), {"Angle=" + std::to_string(angle)}});
  }
  return variants;
}

// In the order of their numbers in scenes/extreme/symmetry.pov; the merge of glass is the last.
constexpr const char* kShapes[] = {"sphere",       "box",           "cylinder",     "cone",           "torus",
                                   "disc",         "quadric",       "quartic",      "superellipsoid", "blob",
                                   "sor",          "cubic_lathe",   "bezier_lathe", "prism",          "conic_prism",
                                   "linear_sweep", "spline_sweep",  "ovus",         "mesh",           "smooth_mesh2",
                                   "polygon",      "bicubic_patch", "height_field", "julia_fractal",  "isosurface",
                                   "parametric",   "text",          "difference",   "twelve_planes"};

void add_symmetries(std::vector<ExtremeCase>& all) {
  int shape = 0;
  const auto add = [&](const std::string& name, double allowed_scaled, const char* rule_of_scaled) {
    const std::vector<std::string> declares{"Shape=" + std::to_string(shape++)};
    all.push_back({name + "_scaled", "symmetry.pov", declares, scaled(), allowed_scaled, rule_of_scaled});
    all.push_back({name + "_moved", "symmetry.pov", declares, moved(), 0, kMoved});
    all.push_back({name + "_turned", "symmetry.pov", declares, turned(), 0, kTurned});
  };
  for (const char* name : kShapes) add(name, kAllowedScaled, kScaled);
  add("glass_merge", 2 * kAllowedScaled, kRefractingScaled);
  const Symmetry flattened{{"1e-3", {"Flat=1e-3"}}, {"1e-6", {"Flat=1e-6"}}, {"1e3", {"Flat=1e3"}}};
  all.push_back({"height_field_flattened", "height_flat.pov", {}, flattened, 0, "none: the flattening is off by 1e-15"});
}

void add_grazing(std::vector<ExtremeCase>& all) {
  all.push_back({"planet_from_one_metre", "planet.pov", {}, planet(), 0, kBands});
  all.push_back({"sphere_tangent", "sphere_tangent.pov", {}, sphere_rim(), 0, kUlp});
  all.push_back({"plane_grazing", "plane_grazing.pov", {}, grazed_floor(), 0, kBands});
  for (const double minor : {1e-6, 1e-3, 1.0}) {
    all.push_back({"torus_1_to_" + number(minor),
                   "torus_ratio.pov",
                   {"Minor=" + number(minor)},
                   torus_along_its_axis(minor),
                   0,
                   kUlp});
  }
  for (const double minor : {0.02, 0.3, 1.0}) {
    all.push_back({"torus_grazing_" + number(minor),
                   "torus_oblique.pov",
                   {"Minor=" + number(minor)},
                   torus_from_a_slant(minor),
                   0,
                   "exact, but for rays that touch the tube to 1e-9"});
  }
}

void add_parallel(std::vector<ExtremeCase>& all) {
  for (const char* turn : {"0", "1"}) {
    all.push_back({std::string("box_edge_parallel_") + turn,
                   "box_parallel.pov",
                   {std::string("Turned=") + turn},
                   box_edge(),
                   0,
                   "exact to two units in the last place"});
  }
  int solid = 0;
  for (const std::string name :
       {"box", "cylinder_end_on", "cylinder_beside", "cone", "plane", "five_planes", "superellipsoid"}) {
    const std::string number_of_solid = "Solid=" + std::to_string(solid++);
    for (const std::string tiny : {"0", "1e-310"}) {
      all.push_back(
          {"direction_" + tiny + "_" + name, "slabs.pov", {number_of_solid, "Tiny=" + tiny}, everywhere(), 0, "exact"});
      if (name == "plane") continue;
      all.push_back({"direction_" + tiny + "_past_" + name, "slabs.pov", {number_of_solid, "Tiny=" + tiny, "Aside=1.5"}, nowhere(), 0,
                     "exact"});
      if (name == "superellipsoid") continue;  // its middle alone is as wide as the ray is long
      for (const bool inside : {true, false}) {
        all.push_back({"direction_" + tiny + (inside ? "_within_" : "_beside_") + name,
                       "slabs.pov",
                       {number_of_solid, "Tiny=" + tiny, "Aside=1", inside ? "Nudge=-1" : "Nudge=1"},
                       inside ? everywhere() : nowhere(),
                       0,
                       "exact: a thousand-millionth inside or outside of a face"});
      }
    }
  }
  for (const std::string tiny : {"0", "1e-310"}) {
    all.push_back({"direction_" + tiny + "_along_floor", "slabs.pov", {"Solid=7", "Tiny=" + tiny}, nowhere(), 0, "exact"});
  }
}

void add_roots(std::vector<ExtremeCase>& all) {
  all.push_back({"poly_order_15", "poly15.pov", {}, first_sheet(), 0, kBands});
  int kind = 0;
  for (const std::string name : {"gradient_2e6", "pole_inside", "pole_outside", "triple_zero"}) {
    const double accuracy = name == "triple_zero" ? 1e-4 : 1e-6;  // as the scene has it
    all.push_back({"isosurface_" + name,
                   "isosurface_steep.pov",
                   {"Kind=" + std::to_string(kind++)},
                   unit_disc(accuracy),
                   0,
                   "exact, but for " + number(accuracy) + " at the rim, the isosurface's accuracy"});
  }
  for (const int above : {0, 1}) {
    for (const int spline : {0, 1}) {
      all.push_back({std::string(spline == 0 ? "bezier" : "linear") + "_lathe_at_axis_" + (above ? "above" : "beside"),
                     "lathe_axis.pov",
                     {"Above=" + std::to_string(above), "Spline=" + std::to_string(spline)},
                     double_cone(above != 0),
                     0,
                     "exact, but for 1e-6 at the rim"});
    }
  }
  all.push_back({"sphere_sweep_joints", "sweep_joint.pov", {}, bent_tube(), 0, "exact, but for 1e-6 at the rim"});
}

void add_watertight(std::vector<ExtremeCase>& all) {
  for (const double view : {1e-6, 1e-3, 1.0}) {
    all.push_back({"needles_" + number(view), "needles.pov", {"View=" + number(view)}, everywhere(), 0, "no hole"});
  }
  for (const double bump : {0.0, 1e-12, 1e-9, 1e-6}) {
    all.push_back(
        {"mesh_shallow_" + number(bump), "mesh_shallow.pov", {"Bump=" + number(bump)}, everywhere(), 0, "no hole"});
  }
}

void add_solids(std::vector<ExtremeCase>& all) {
  int way = 0;
  for (const std::string name :
       {"alone", "intersection_of_equals", "union_of_equals", "merge_with_one_inside", "union_of_halves", "merge_of_halves",
        "difference_of_halves", "box_and_planes", "minus_planes"}) {
    all.push_back({"coincident_" + name,
                   "coincident.pov",
                   {"Way=" + std::to_string(way++)},
                   turned_box(),
                   0,
                   "exact, but for rays through edges to 1e-9"});
  }
  all.push_back({"coincident_merge_of_spheres", "coincident.pov", {"Way=9"}, unit_disc(1e-9), 0, "exact, but for rims to 1e-9"});
  all.push_back({"coincident_difference_of_spheres", "coincident.pov", {"Way=10"}, nowhere(), 0, "exact: nothing is left"});
  for (const double gap : {1e-3, 1e-5, 1e-7, 1e-9}) {
    all.push_back({"film_" + number(gap),
                   "film.pov",
                   {"Gap=" + number(gap)},
                   clear_box_on_floor(),
                   0,
                   "exact, but for rays through edges to 1e-5"});
  }
  for (const char* size : {"1", "1e4"}) {
    all.push_back({std::string("icosahedron_of_size_") + size,
                   "icosahedron.pov",
                   {std::string("Size=") + size},
                   icosahedron(),
                   0,
                   "exact, but for rays through edges to 1e-9"});
  }
  all.push_back({"two_hundred_shells", "shells.pov", {}, shells(), 0, "exact, but for rims to 1e-9"});
  all.push_back({"two_hundred_glass_shells", "glass_shells.pov", {}, glass_shells(), 0,
                 "exact, but for rims and bands to 1e-9 and the surface at which max_trace_level ends"});
}

void add_refraction(std::vector<ExtremeCase>& all) {
  struct Slab {
    const char* name;
    const char* ior;
    const char* nudge;  // in thousand-millionths: declared values are floats
    double value, slant;
  };
  for (const Slab& slab : {Slab{"1_plus_1e-9", "1", "1", 1.000000001, 0.6}, Slab{"1_minus_1e-9", "1", "-1", 0.999999999, 0.6},
                           Slab{"1e-3", "0.001", "0", 0.001, 0.0005}, Slab{"1e-3_straight", "0.001", "0", 0.001, 0},
                           Slab{"1e3", "1000", "0", 1000, 0.6}}) {
    all.push_back({std::string("ior_") + slab.name,
                   "ior.pov",
                   {std::string("Ior=") + slab.ior, std::string("Nudge=") + slab.nudge, "Slant=" + number(slab.slant)},
                   slab_before_stripes(slab.value, slab.slant),
                   0,
                   kBands});
  }
  for (const std::string slant : {"0.002", "0.6"}) {  // the sine of the critical angle is 0.001
    all.push_back({"ior_1e-3_total_reflection_" + slant, "ior.pov", {"Ior=0.001", "Slant=" + slant}, nowhere(), 0, "exact"});
  }
}

}  // namespace

const std::vector<ExtremeCase>& cases() {
  static const std::vector<ExtremeCase> all = [] {
    std::vector<ExtremeCase> list;
    add_grazing(list);
    add_parallel(list);
    add_roots(list);
    add_watertight(list);
    add_solids(list);
    add_refraction(list);
    add_symmetries(list);
    return list;
  }();
  return all;
}

}  // namespace lute::extreme
