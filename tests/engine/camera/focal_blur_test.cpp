#include "engine/camera/focal_blur.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lute {
namespace {

// Chapter 30 §12 D: the plane z = 7, red by x, green by y, blue in stripes of one half.
Color plane_color(const Ray& ray) {
  const dvec3 p = ray.at((7 - ray.origin.z) / ray.direction.z);
  const double stripe = std::fmod(p.x + 10, 1) < 0.5 ? 0 : 1;
  return {{static_cast<float>(p.x / 20 + 0.5), static_cast<float>(p.y / 20 + 0.5), static_cast<float>(stripe)}, 0, 0};
}

Camera blurred_camera(int minimum, int maximum) {
  Camera camera;
  camera.direction = {0, 0, 0.9};
  camera.right = {1.4, 0, 0};
  camera.up = {0, 1.1, 0};
  camera.aperture = 0.6;
  camera.focal_distance = 4;
  camera.blur_samples_min = minimum;
  camera.blur_samples_max = maximum;
  return camera;
}

Color sample(const Camera& camera, dvec2 pixel, int* rays = nullptr, const FocalBlur::LensBrightness& brightness = {}) {
  const Projection projection(camera, 6, 5);
  const FocalBlur blur(camera, brightness);
  return blur.sample(
      pixel, [&](dvec2 position, ProjectedRay& ray) { return projection.project(position, ray); },
      [&](const Ray& ray) {
        if (rays != nullptr) ++*rays;
        return plane_color(ray);
      });
}

void expect_pixels(const Camera& camera, const std::array<std::array<int, 3>, 3>& expected,
                   const FocalBlur::LensBrightness& brightness = {}) {
  const std::array<dvec2, 3> pixels{{{0, 0}, {3, 2}, {5, 4}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Color color = sample(camera, pixels[i], nullptr, brightness);
    EXPECT_NEAR(color.rgb.r * 65535, expected[i][0], 1.5) << i;
    EXPECT_NEAR(color.rgb.g * 65535, expected[i][1], 1.5) << i;
    EXPECT_NEAR(color.rgb.b * 65535, expected[i][2], 1.5) << i;
  }
}

TEST(FocalBlur, OneSample) {
  expect_pixels(blurred_camera(0, 1), {{{18670, 46570, 65535}, {36033, 34205, 65535}, {44793, 20401, 65535}}});
}

TEST(FocalBlur, FourSamplesOnASquare) {
  expect_pixels(blurred_camera(0, 4), {{{18198, 43677, 49151}, {34528, 33506, 32768}, {47307, 21015, 49151}}});
}

TEST(FocalBlur, TenSamplesFillUpAHexagon) {
  expect_pixels(blurred_camera(0, 10), {{{17237, 44656, 58982}, {34927, 33257, 13107}, {47588, 21269, 32768}}});
}

TEST(FocalBlur, NineteenSamplesWithLooseConfidence) {
  Camera camera = blurred_camera(0, 19);
  camera.variance = 0.001;
  camera.confidence = 0.5;
  expect_pixels(camera, {{{17704, 44139, 48289}, {35533, 32992, 27594}, {47755, 21367, 31043}}});
}

TEST(FocalBlur, FiftySamplesStopByConfidence) {
  Camera camera = blurred_camera(0, 50);
  camera.variance = 1.0 / 128;
  expect_pixels(camera, {{{18010, 43850, 38362}, {35131, 33394, 25575}, {47169, 21986, 31968}}});
  int rays = 0;
  sample(camera, {0, 0}, &rays);
  EXPECT_EQ(rays, 41);
}

TEST(FocalBlur, MinimumIsKept) {
  Camera camera = blurred_camera(20, 60);
  camera.variance = 1.0 / 64;
  expect_pixels(camera, {{{18095, 43747, 37449}, {35156, 33403, 28086}, {47333, 21793, 28086}}});
  int rays = 0;
  sample(camera, {0, 0}, &rays);
  EXPECT_EQ(rays, 35);
}

TEST(FocalBlur, BokehShapesTheLens) {
  expect_pixels(blurred_camera(0, 12), {{{17321, 44329, 60074}, {35019, 33432, 21845}, {47743, 21155, 38229}}},
                [](dvec2 p) { return p.x < 0 ? 0.0 : 1.0; });
}

TEST(Halton, IsTheRadicalInverse) {
  EXPECT_DOUBLE_EQ(halton(2, 1), 0.5);
  EXPECT_DOUBLE_EQ(halton(2, 6), 0.375);
  EXPECT_DOUBLE_EQ(halton(3, 5), 2.0 / 3 + 1.0 / 9);
}

}  // namespace
}  // namespace lute
