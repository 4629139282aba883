// Small scenes for tests of shading, in the shorthand of the check cases of specification chapter 40 §19.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/build/built_scene.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/shade/tracer.hpp"

namespace lute::testing {

inline Color rgbft(float r, float g, float b, float f = 0, float t = 0) { return {{r, g, b}, f, t}; }
inline Color rgbt(float v, float t = 0) { return {Rgb(v), 0, t}; }

inline PigmentPtr pigment(Color color) {
  auto p = std::make_shared<Pigment>();
  p->map = color;
  return p;
}

// Finishes start from `ambient 0 diffuse 0`.
template <class Set>
FinishPtr finish(Set&& set) {
  auto f = std::make_shared<Finish>();
  f->ambient = Rgb(0.0f);
  f->diffuse = f->raw_diffuse = 0;
  set(*f);
  return f;
}
inline FinishPtr finish(float ambient, float diffuse) {
  return finish([&](Finish& f) {
    f.ambient = Rgb(ambient);
    f.diffuse = f.raw_diffuse = diffuse;
  });
}

struct LayerText {
  Color color;
  FinishPtr finish;
};
inline TexturePtr texture(const std::vector<LayerText>& layers) {
  auto t = std::make_shared<Texture>();
  std::vector<TextureLayer> made;
  for (const LayerText& l : layers) made.push_back({pigment(l.color), nullptr, l.finish});
  t->content = made;
  return t;
}
inline TexturePtr texture(Color color, FinishPtr f) { return texture({{color, std::move(f)}}); }

using MutableObject = std::shared_ptr<Object>;

inline MutableObject object(AnyShape shape, TexturePtr t = nullptr) {
  auto o = std::make_shared<Object>();
  o->geometry = std::move(shape);
  o->texture.texture = std::move(t);
  return o;
}
inline AnyShape plane(dvec3 normal, double distance) {
  Plane p;
  p.normal = normal;
  p.distance = distance;
  return p;
}
inline AnyShape box(dvec3 a, dvec3 b) {
  Box result;
  result.corner_a = a;
  result.corner_b = b;
  return result;
}
inline AnyShape sphere(dvec3 center, double radius) {
  Sphere s;
  s.center = center;
  s.radius = radius;
  return s;
}
// W: plane { -z, 0 }.
inline MutableObject wall(TexturePtr t) { return object(plane({0, 0, -1}, 0), std::move(t)); }

inline MutableObject csg(CsgOperation operation, std::vector<ObjectPtr> children) {
  auto o = std::make_shared<Object>();
  Csg c;
  c.operation = operation;
  c.children = std::move(children);
  o->geometry = Shared(std::move(c));
  return o;
}

template <class Set>
MutableObject light(dvec3 location, Rgb color, Set&& set) {
  LightSource l;
  l.location = location;
  l.color = color;
  set(l);
  auto o = std::make_shared<Object>();
  o->geometry = Shared(std::move(l));
  return o;
}
inline MutableObject light(dvec3 location, Rgb color = Rgb(1.0f)) {
  return light(location, color, [](LightSource&) {});
}
inline MutableObject sun() { return light({0, 0, -100}); }

inline std::shared_ptr<Interior> interior() { return std::make_shared<Interior>(); }

// CAM, and CAM(angle): a ray toward the origin from z = -5.
inline Ray camera(double degrees = 0) {
  const double t = std::tan(radians(degrees));
  return {{0, 5 * t, -5}, glm::normalize(dvec3(0, -t, 1))};
}

inline std::unique_ptr<BuiltScene> built_scene(const Scene& scene, const BuildOptions& options = {}) {
  return build_scene(scene, make_plan(scene, options));
}

inline Color look(const Scene& scene, const Ray& ray, const BuildOptions& options = {}) {
  const RenderPlan plan = make_plan(scene, options);
  const auto built = build_scene(scene, plan);
  const Tracer tracer(*built, plan);
  TraceContext context;
  context.start_sample(0, 0);
  context.camera_interiors = tracer.interiors_at(ray.origin);
  return tracer.trace(ray, context);
}

inline Scene scene(std::vector<ObjectPtr> objects) {
  Scene s;
  s.objects = std::move(objects);
  return s;
}
inline Scene before_version_37(Scene s) {
  s.version = s.effective_version = 360;
  return s;
}
inline Scene with_background(Scene s, Color c) {
  s.background = c;
  return s;
}
inline const Color kBlueSky = {{0.2f, 0.4f, 0.8f}, 0, 0};  // BG

inline void expect_rgb(const Color& seen, float r, float g, float b, float tolerance = 3e-5f) {
  EXPECT_NEAR(seen.rgb.r, r, tolerance);
  EXPECT_NEAR(seen.rgb.g, g, tolerance);
  EXPECT_NEAR(seen.rgb.b, b, tolerance);
}
inline void expect_grey(const Color& seen, float v) { expect_rgb(seen, v, v, v); }

}  // namespace lute::testing
