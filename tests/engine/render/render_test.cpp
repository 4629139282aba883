#include "engine/render/render.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace lute {
namespace {

class Waves final : public PixelSource {
 public:
  Color sample(dvec2 p) override {
    ++counters_.camera_rays;
    return {
        {static_cast<float>(std::sin(p.x * 0.7) * std::cos(p.y)), static_cast<float>(std::fmod(p.x * p.y, 1.0)), 0.3f},
        0,
        0};
  }
  Counters counters() const override { return counters_; }

 private:
  Counters counters_;
};

RenderSettings settings_for(int width, int height, int method, int threads) {
  RenderSettings settings;
  settings.area = area_of({}, width, height);
  settings.antialiasing.method = method;
  settings.threads = threads;
  return settings;
}

Film waves(int method, int threads, double* error = nullptr) {
  Film film(133, 97);
  RenderSettings settings = settings_for(133, 97, method, threads);
  settings.estimate_error = true;
  const RenderResult result = render(
      settings, [] { return std::make_unique<Waves>(); }, film);
  EXPECT_TRUE(result.complete);
  if (error != nullptr) *error = result.estimated_error.value();
  return film;
}

TEST(Render, IsBitIdenticalForAnyNumberOfThreads) {
  for (const int method : {0, 1, 2, 3}) {
    double error_of_one = 0, error_of_many = 0;
    const Film one = waves(method, 1, &error_of_one);
    for (const int threads : {2, 7}) {
      const Film many = waves(method, threads, &error_of_many);
      EXPECT_EQ(error_of_one, error_of_many);
      for (int y = 0; y < one.height(); ++y) {
        ASSERT_EQ(std::memcmp(&one.at(0, y), &many.at(0, y), sizeof(Color) * 133), 0)
            << "method " << method << " row " << y;
      }
    }
  }
}

TEST(Render, AddsUpTheCountersOfAllThreads) {
  Film film(64, 64);
  const RenderResult result = render(
      settings_for(64, 64, 0, 2), [] { return std::make_unique<Waves>(); }, film);
  EXPECT_EQ(result.counters.camera_rays, 64u * 64u);
}

TEST(Render, CountsTheSamplesOfTheBlockFrameToo) {  // chapter 30 §9.8: 16x12 with +A has 12 (16 + 1) + 16 pixels
  Film film(16, 12);
  RenderSettings settings = settings_for(16, 12, 1, 1);
  settings.antialiasing.threshold = 100;
  const RenderResult result = render(
      settings, [] { return std::make_unique<Waves>(); }, film);
  EXPECT_EQ(result.counters.camera_rays, 220u);
}

TEST(Render, ReportsEveryPixelOnce) {
  Film film(100, 50);
  long last = 0, total = 0;
  render(settings_for(100, 50, 0, 2), [] { return std::make_unique<Waves>(); }, film,
         {[&](long done, long all) {
            EXPECT_GT(done, last);
            last = done;
            total = all;
          },
          nullptr});
  EXPECT_EQ(last, 5000);
  EXPECT_EQ(total, 5000);
}

TEST(Render, ReportsThePassesOfMethodThreeAsOneRender) {
  Film film(100, 50);
  long last = 0;
  render(settings_for(100, 50, 3, 2), [] { return std::make_unique<Waves>(); }, film,
         {[&](long done, long all) {
            EXPECT_GE(done, last);
            EXPECT_EQ(all, 5000);
            last = done;
          },
          nullptr});
  EXPECT_EQ(last, 5000);
}

TEST(Render, StopsWhenCancelled) {
  Film film(320, 320);
  std::atomic<bool> cancel = false;
  int blocks = 0;
  const RenderResult result = render(settings_for(320, 320, 0, 1), [] { return std::make_unique<Waves>(); }, film,
                                     {[&](long, long) { cancel = ++blocks == 3; }, &cancel});
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(blocks, 3);
}

TEST(Render, LeavesPixelsOutsideOfThePartBlackAndOpaque) {
  Film film(40, 40);
  RenderSettings settings = settings_for(40, 40, 0, 1);
  settings.area = {10, 10, 19, 19};
  render(
      settings, [] { return std::make_unique<Waves>(); }, film);
  EXPECT_EQ(film.at(9, 10), Color{});
  EXPECT_EQ(film.at(20, 19), Color{});
  EXPECT_EQ(film.at(10, 10).rgb.b, 0.3f);
  EXPECT_EQ(film.at(19, 19).rgb.b, 0.3f);
}

}  // namespace
}  // namespace lute
