// The acceleration structure against Embree 3 (single rays, single precision, its default build quality): the same
// million triangles of bench/scene/planet.pov, the same rays. One thread traces; the builds use all threads that they want.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "engine/accel/counters.hpp"
#include "engine/accel/scene_tree.hpp"
#include "engine/accel/triangle_tree.hpp"
#include "engine/csg/leaf_solid.hpp"
#include "engine/shape/mesh.hpp"
#include "engine/shape/sphere.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

struct Surface {
  std::vector<glm::vec3> vertices;
  std::vector<TriangleTree::Face> faces;
};

// A planet with mountains, a mesh2 of a million triangles that a scene's loops write.
const Surface& planet() {
  static const Surface surface = [] {
    ParseOptions options;
    options.input_file = LUTE_BENCH_SCENES "/planet.pov";
    const ParseResult parsed = parse_scene(options);
    if (!parsed.ok) throw std::runtime_error("cannot read " + options.input_file);
    const MeshData& mesh = *parsed.scene.objects.at(1)->shape_if<Mesh>()->data;  // behind the light
    Surface s{mesh.vertices, {}};
    for (const MeshData::Indices& face : mesh.faces) s.faces.push_back({face[0], face[1], face[2]});
    return s;
  }();
  return surface;
}

enum RaySet { kPrimary, kScattered };

const std::vector<Ray>& rays(RaySet set) {
  static const auto make = [](RaySet which) {
    std::vector<Ray> result;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int y = 0; y < 512; ++y)
      for (int x = 0; x < 512; ++x) {
        Ray ray{dvec3(0, 0, -3), dvec3((x - 255.5) / 700, (y - 255.5) / 700, 1)};
        if (which == kScattered) {
          ray.origin = 1.5 * dvec3(unit(random), unit(random), unit(random));
          ray.direction = dvec3(unit(random), unit(random), unit(random)) - 0.5 * ray.origin;
        }
        ray.direction = glm::normalize(ray.direction);
        result.push_back(ray);
      }
    return result;
  };
  static const std::vector<Ray> sets[] = {make(kPrimary), make(kScattered)};
  return sets[set];
}

TriangleTree build_tree() {
  return TriangleTree(planet().vertices, planet().faces, [](std::uint32_t) { return false; });
}
const TriangleTree& tree() {
  static const TriangleTree built = build_tree();
  return built;
}

RTCScene embree_scene(RTCDevice device) {
  const Surface& s = planet();
  const RTCScene scene = rtcNewScene(device);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, s.vertices.data(), 0,
                             sizeof(glm::vec3), s.vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, s.faces.data(), 0,
                             sizeof(s.faces[0]), s.faces.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

RTCDevice device() {
  static const RTCDevice opened = rtcNewDevice(nullptr);
  return opened;
}
RTCScene embree() {
  static const RTCScene built = embree_scene(device());
  return built;
}

RTCRay embree_ray(const Ray& ray) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = 1e-4f;
  r.tfar = 1e7f;
  r.mask = ~0u;
  return r;
}

void build_lute(benchmark::State& state) {
  planet();
  for (auto _ : state) benchmark::DoNotOptimize(build_tree());
}
void build_embree(benchmark::State& state) {
  planet();
  device();
  for (auto _ : state) rtcReleaseScene(embree_scene(device()));
}

// Runs `trace` on every ray; reports rays per second and the share of rays that hit.
template <class Trace>
void run(benchmark::State& state, RaySet set, Trace&& trace) {
  const std::vector<Ray>& all = rays(set);
  std::size_t hits = 0, count = 0;
  for (auto _ : state)
    for (const Ray& ray : all) {
      hits += trace(ray);
      ++count;
    }
  state.SetItemsProcessed(static_cast<std::int64_t>(count));
  state.counters["hit"] = static_cast<double>(hits) / static_cast<double>(count);
}

void nearest_lute(benchmark::State& state, RaySet set) {
  const TriangleTree& t = tree();
  run(state, set, [&](const Ray& ray) {
    TriangleHit hit;
    return t.nearest(ray, {1e-4, 1e7}, hit);
  });
}
void any_lute(benchmark::State& state, RaySet set) {
  const TriangleTree& t = tree();
  run(state, set, [&](const Ray& ray) { return t.any(ray, {1e-4, 1e7}); });
}
void nearest_embree(benchmark::State& state, RaySet set) {
  const RTCScene scene = embree();
  run(state, set, [&](const Ray& ray) {
    RTCRayHit hit{};
    hit.ray = embree_ray(ray);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
    return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  });
}
void any_embree(benchmark::State& state, RaySet set) {
  const RTCScene scene = embree();
  run(state, set, [&](const Ray& ray) {
    RTCRay r = embree_ray(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &r);
    return r.tfar < 0;
  });
}

// 100,000 spheres, the size of a molecule that chemists draw, as solids of a scene.
void spheres(benchmark::State& state, bool shadow) {
  class NoSharing final : public BuildContext {
   public:
    std::shared_ptr<const void> find_shared(const void*) const override { return nullptr; }
    void store_shared(const void*, std::shared_ptr<const void>) override {}
  } context;
  std::vector<std::unique_ptr<Solid>> owned;
  std::vector<const Solid*> solids;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 100000; ++i) {
    Leaf leaf;
    leaf.shape = build(Sphere{dvec3(unit(random), unit(random), unit(random)), 0.01}, Transform(), context);
    leaf.opaque = true;
    owned.push_back(std::make_unique<LeafSolid>(std::move(leaf)));
    solids.push_back(owned.back().get());
  }
  const SceneTree scene(solids);
  Counters counters;
  LastBlocker last;
  run(state, kPrimary, [&](const Ray& ray) {
    Hit hit;
    return shadow ? scene.obstruction(ray, {1e-3, 1e7}, last, counters) == Obstruction::kOpaque
                  : scene.nearest(ray, {1e-4, 1e7}, RayKind(), hit, counters);
  });
  const double traced = static_cast<double>(state.iterations()) * static_cast<double>(rays(kPrimary).size());
  state.counters["nodes/ray"] = static_cast<double>(counters.box_tests) / traced;
  state.counters["solids/ray"] = static_cast<double>(counters.solid_tests) / traced;
}

BENCHMARK(build_lute)->Name("mesh_1M/build/lute")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(build_embree)->Name("mesh_1M/build/embree")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(nearest_lute, primary, kPrimary)->Name("mesh_1M/nearest/primary/lute")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearest_embree, primary, kPrimary)
    ->Name("mesh_1M/nearest/primary/embree")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearest_lute, scattered, kScattered)
    ->Name("mesh_1M/nearest/scattered/lute")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearest_embree, scattered, kScattered)
    ->Name("mesh_1M/nearest/scattered/embree")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(any_lute, primary, kPrimary)->Name("mesh_1M/any/primary/lute")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(any_embree, primary, kPrimary)->Name("mesh_1M/any/primary/embree")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(any_lute, scattered, kScattered)->Name("mesh_1M/any/scattered/lute")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(any_embree, scattered, kScattered)
    ->Name("mesh_1M/any/scattered/embree")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, nearest, false)->Name("spheres_100k/nearest/primary/lute")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, any, true)->Name("spheres_100k/any/primary/lute")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lute
