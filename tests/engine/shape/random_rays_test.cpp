// What holds for every shape, tested with random rays: hits lie on the surface, they lead in and out of what the inside test accepts,
// normals stand on the surface, the box contains all hits, the three ray queries agree, and all that at scales from 1e-6 to 1e6.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "shape_cases.hpp"

namespace lute::test {

void PrintTo(const ShapeCase& c, std::ostream* out) { *out << c.name; }

namespace {

constexpr Interval kAll{0, std::numeric_limits<double>::infinity()};

// Rays from a distance of three sizes, aimed at the shape.
class RandomRays {
 public:
  RandomRays(const ShapeCase& c, const Transform& to_world, unsigned seed) : case_(c), to_world_(to_world), random_(seed) {}

  Ray next() {
    const dvec3 from = case_.middle + 3 * case_.size * direction();
    const dvec3 to = case_.middle + case_.size * dvec3(unit_(random_), unit_(random_), unit_(random_));
    const dvec3 origin = to_world_.point(from);
    return {origin, glm::normalize(to_world_.point(to) - origin)};
  }

 private:
  dvec3 direction() {
    for (;;) {
      const dvec3 d(unit_(random_), unit_(random_), unit_(random_));
      const double length = glm::length(d);
      if (length > 0.1 && length < 1) return d / length;
    }
  }
  const ShapeCase& case_;
  Transform to_world_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

ShapeHits sorted_hits(const Shape& shape, const Ray& ray) {
  ShapeHits hits;
  shape.hits(ray, kAll, hits);
  std::stable_sort(hits.begin(), hits.end(), [](const ShapeHit& a, const ShapeHit& b) { return a.t < b.t; });
  return hits;
}

// A case at one scale, turned and moved.
struct Placed {
  const ShapeCase& c;
  Transform to_world;
  std::unique_ptr<Shape> shape;
  double scale, size;

  Placed(const ShapeCase& shape_case, double s, const Transform& turn) : c(shape_case), scale(s), size(s * shape_case.size) {
    to_world = turn.then(Transform::scale(dvec3(s))).then(Transform::translate(s * dvec3(0.3, -0.2, 0.5)));
    shape = c.build(to_world);
  }
  dvec3 local(const dvec3& p) const { return to_world.inverse_point(p); }
};

Transform turned() { return Transform::rotate({20, -35, 50}); }
Transform squeezed() { return Transform::scale({1, 0.7, 1.3}).then(Transform::rotate({20, -35, 50})); }

Transform sheared() { return Transform::matrix(dmat3(1, 0.2, -0.1, 0.4, 0.9, 0.3, -0.2, 0.1, 1.1), dvec3(0)).then(turned()); }

class EveryShape : public testing::TestWithParam<ShapeCase> {
 protected:
  template <class Check>
  void at_every_scale(Check check) {
    for (const double scale : {1e-6, 1.0, 1e6})
      for (const auto& turn : {turned(), squeezed(), sheared()}) {
        const char* const how = turn.kinds & Transform::kMatrix ? ", sheared" : turn.kinds & Transform::kScale ? ", squeezed" : "";
        SCOPED_TRACE(testing::Message() << "scale " << scale << how);
        const Placed placed(GetParam(), scale, turn);
        RandomRays rays(GetParam(), placed.to_world, 7);
        int met = 0;
        const int count = GetParam().rays;
        for (int i = 0; i < count && !HasFailure(); ++i) {
          SCOPED_TRACE(testing::Message() << "ray " << i);
          const Ray ray = rays.next();
          const ShapeHits hits = sorted_hits(*placed.shape, ray);
          if (!hits.empty()) ++met;
          check(placed, ray, hits);
        }
        if (HasFailure()) return;
        EXPECT_GT(met, count / 50);
      }
  }
};

TEST_P(EveryShape, HitsLieOnTheSurface) {
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    for (const ShapeHit& hit : hits) {
      const dvec3 p = ray.at(hit.t);
      if (placed.c.distance) {
        const dvec3 local = placed.local(p);
        EXPECT_LE(placed.c.distance(local), placed.c.accuracy * std::max(placed.c.size, hit.t / placed.scale)) << "t " << hit.t;
        continue;
      }
      const dvec3 n = placed.shape->normal(hit, p);
      if (std::abs(glm::dot(n, ray.direction)) < 1e-3) continue;
      const dvec3 step = placed.c.accuracy * placed.size * n;
      EXPECT_NE(placed.shape->inside(p + step), placed.shape->inside(p - step)) << "t " << hit.t;
    }
  });
}

TEST_P(EveryShape, HitsLeadInAndOut) {
  if (!GetParam().parity) GTEST_SKIP() << "not a closed solid";
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    bool inside = placed.shape->inside(ray.origin);
    double before = 0;
    for (std::size_t i = 0; i <= hits.size(); ++i) {
      const double after = i < hits.size() ? hits[i].t : before + placed.size;
      // Between hits that are very near to each other the tolerance of the inside test decides.
      if (after - before > 2e-4 * placed.size) {
        EXPECT_EQ(placed.shape->inside(ray.at(0.5 * (before + after))), inside) << "before hit " << i << " of " << hits.size();
      }
      inside = !inside;
      before = after;
    }
  });
}

TEST_P(EveryShape, NormalsStandOnTheSurface) {
  if (GetParam().own_normals) GTEST_SKIP() << "normals are given";
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    for (const ShapeHit& hit : hits) {
      const dvec3 p = ray.at(hit.t);
      const dvec3 n = placed.shape->normal(hit, p);
      ASSERT_NEAR(glm::length(n), 1, 1e-12);
      if (std::abs(glm::dot(n, ray.direction)) < 0.1) continue;
      // Where rays close by meet the surface: four points around p, if the surface is smooth there.
      const double width = std::max(1e-5, 10 * std::sqrt(placed.c.scatter)) * placed.size;
      const dvec3 u = glm::normalize(glm::cross(ray.direction, std::abs(ray.direction.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
      const dvec3 v = glm::cross(ray.direction, u);
      dvec3 around[4];
      bool smooth = true;
      for (int i = 0; i < 4 && smooth; ++i) {
        const dvec3 aside = (i % 2 == 0 ? u : v) * (i < 2 ? width : -width);
        const Ray beside{ray.origin + aside, ray.direction};
        const ShapeHits there = sorted_hits(*placed.shape, beside);
        const auto same = std::min_element(there.begin(), there.end(), [&](const ShapeHit& a, const ShapeHit& b) {
          return std::abs(a.t - hit.t) < std::abs(b.t - hit.t);
        });
        smooth = same != there.end() && std::abs(same->t - hit.t) < 20 * width;
        if (smooth) around[i] = beside.at(same->t);
      }
      if (!smooth) continue;
      // The second differences are those of a curved surface, not of an edge.
      const double bend = std::max(glm::length(around[0] + around[2] - 2.0 * p), glm::length(around[1] + around[3] - 2.0 * p));
      if (bend > 100 * width * width / placed.size + 10 * placed.c.scatter * placed.size) continue;
      const dvec3 measured = glm::normalize(glm::cross(around[0] - around[2], around[1] - around[3]));
      const double tolerance = 1e-6 + 100 * width * width / (placed.size * placed.size) + 20 * placed.c.scatter * placed.size / width;
      EXPECT_NEAR(std::abs(glm::dot(measured, n)), 1, tolerance) << "t " << hit.t;
    }
  });
}

TEST_P(EveryShape, TheBoxContainsAllHits) {
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    const Aabb box = placed.shape->bounds();
    const double inexact = placed.c.accuracy > 1e-9 ? placed.c.accuracy : 0;
    const dvec3 slack(1e-12 * (placed.size + glm::length(ray.origin)) + inexact * placed.size);
    for (const ShapeHit& hit : hits) EXPECT_TRUE((Aabb{box.lo - slack, box.hi + slack}.contains(ray.at(hit.t)))) << "t " << hit.t;
  });
}

TEST_P(EveryShape, TheThreeQueriesAgree) {
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    ShapeHit nearest;
    ASSERT_EQ(placed.shape->nearest(ray, kAll, nearest), !hits.empty());
    EXPECT_EQ(placed.shape->any(ray, kAll), !hits.empty());
    if (hits.empty()) return;
    EXPECT_EQ(nearest.t, hits.front().t);
    // The range cuts at both ends. It may change the last digits: some shapes begin to search there.
    const double first = hits.front().t, last = hits.back().t, little = 1e-9 + placed.c.scatter;
    EXPECT_TRUE(placed.shape->any(ray, {0, first * (1 + little)}));
    EXPECT_FALSE(placed.shape->any(ray, {0, first * (1 - little)}));
    EXPECT_FALSE(placed.shape->any(ray, {last * (1 + little), kAll.hi}));
    ASSERT_TRUE(placed.shape->nearest(ray, {first * (1 - little), last * (1 + little)}, nearest));
    EXPECT_NEAR(nearest.t, first, little * first);
  });
}

// Whole: the shares of the textures at a point are not negative and add up to 1.
TEST_P(EveryShape, TexturesShareAPointWhole) {
  if (!GetParam().textured) GTEST_SKIP() << "the object's texture alone";
  at_every_scale([](const Placed& placed, const Ray& ray, const ShapeHits& hits) {
    std::vector<TextureWeight> weights;
    for (const ShapeHit& hit : hits) {
      weights.clear();
      placed.shape->textures(hit, ray.at(hit.t), weights);
      float sum = 0;
      for (const TextureWeight& w : weights) {
        EXPECT_GE(w.weight, -1e-6f);
        sum += w.weight;
      }
      EXPECT_NEAR(sum, 1, 1e-5);
    }
  });
}

TEST_P(EveryShape, IsTheSameAtEveryScale) {
  const ShapeCase& c = GetParam();
  for (const auto& turn : {turned(), squeezed(), sheared()}) {
    const Placed unit(c, 1, turn);
    for (const double scale : {1e-6, 1e6}) {
      SCOPED_TRACE(testing::Message() << "scale " << scale);
      const Placed scaled(c, scale, turn);
      RandomRays rays(c, unit.to_world, 11), scaled_rays(c, scaled.to_world, 11);
      int different = 0, compared = 0;
      for (int i = 0; i < c.rays; ++i) {
        const Ray ray = rays.next(), scaled_ray = scaled_rays.next();
        ShapeHits hits = sorted_hits(*unit.shape, ray), scaled_hits = sorted_hits(*scaled.shape, scaled_ray);
        // Far away, where a surface runs off to infinity, a ray's last digits decide; and most shapes end at 1e7 units.
        const double far = std::min(100 * c.size, 1e7 / std::max(scale, 1.0));
        std::erase_if(hits, [&](const ShapeHit& h) { return h.t > far; });
        std::erase_if(scaled_hits, [&](const ShapeHit& h) { return h.t > far * scale; });
        if (c.rounding_decides) {
          const auto decided = [&c](const Placed& placed, const Ray& r, const ShapeHits& found) {
            return std::ranges::any_of(found, [&](const ShapeHit& h) { return c.rounding_decides(placed.local(r.at(h.t))); });
          };
          if (decided(unit, ray, hits) || decided(scaled, scaled_ray, scaled_hits)) continue;
        }
        ++compared;
        bool same = hits.size() == scaled_hits.size();
        for (std::size_t k = 0; same && k < hits.size(); ++k) {
          const double slant = std::abs(glm::dot(unit.shape->normal(hits[k], ray.at(hits[k].t)), ray.direction));
          same = std::abs(scaled_hits[k].t / scale - hits[k].t) <= 10 * c.accuracy * std::max(c.size, hits[k].t) / std::max(slant, 1e-3);
        }
        different += same ? 0 : 1;
      }
      EXPECT_LE(different, std::max(1, c.rays / 400));  // a ray that grazes may tip over
      EXPECT_GT(compared, c.rays / 50);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomRays, EveryShape, testing::ValuesIn(all_shape_cases()), [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lute::test
