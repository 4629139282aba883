// Rays per second of single primitives: nearest hits of rays that start around the shape and aim near its middle.
#include <benchmark/benchmark.h>

#include <random>

#include "engine/shape/table.hpp"

namespace lute {
namespace {

class NoSharing final : public BuildContext {
 public:
  std::shared_ptr<const void> find_shared(const void*) const override { return nullptr; }
  void store_shared(const void*, std::shared_ptr<const void>) override {}
};

// Unit-sized examples; those without an entry here need more than a default description.
template <class Description>
Description example() {
  return {};
}
template <>
Box example<Box>() {
  return {dvec3(-1), dvec3(1)};
}
template <>
Triangle example<Triangle>() {
  return {{dvec3(-1, -1, 0), dvec3(1, -1, 0), dvec3(0, 1, 0)}};
}

template <class Description>
void nearest(benchmark::State& state) {
  NoSharing context;
  const auto shape = build(example<Description>(), Transform(), context);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Ray> rays(4096);
  for (Ray& ray : rays) {
    ray.origin = 4.0 * glm::normalize(dvec3(unit(random), unit(random), unit(random)));
    ray.direction = glm::normalize(0.8 * dvec3(unit(random), unit(random), unit(random)) - ray.origin);
  }
  std::size_t hits = 0, count = 0;
  for (auto _ : state)
    for (const Ray& ray : rays) {
      ShapeHit hit;
      hits += shape->nearest(ray, {1e-4, 1e7}, hit);
      ++count;
    }
  state.SetItemsProcessed(static_cast<std::int64_t>(count));
  state.counters["hit"] = static_cast<double>(hits) / static_cast<double>(count);
}

#define LUTE_PRIMITIVE(type) \
  BENCHMARK(nearest<type>)->Name("primitive/" + std::string(type::kKeyword))->Unit(benchmark::kMicrosecond)
LUTE_PRIMITIVE(Sphere);
LUTE_PRIMITIVE(Box);
LUTE_PRIMITIVE(Plane);
LUTE_PRIMITIVE(Disc);
LUTE_PRIMITIVE(Cylinder);
LUTE_PRIMITIVE(Cone);
LUTE_PRIMITIVE(Triangle);
LUTE_PRIMITIVE(Torus);
LUTE_PRIMITIVE(Superellipsoid);

}  // namespace
}  // namespace lute
