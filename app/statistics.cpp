#include "app/statistics.hpp"

#include <array>
#include <cstdio>

namespace lute {
namespace {

std::string row(const char* name, std::uint64_t count, double per, const char* per_what) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "  %-18s %14llu  %10.2f %s\n", name, static_cast<unsigned long long>(count),
                per, per_what);
  return text.data();
}

std::string time_row(const char* name, double seconds) {
  std::array<char, 80> text;
  std::snprintf(text.data(), text.size(), "  %-18s %14.3f s\n", name, seconds);
  return text.data();
}

}  // namespace

std::string statistics_text(const RenderResult& result, const StageTimes& times, long pixels) {
  const Counters& counters = result.counters;
  const std::uint64_t rays = counters.camera_rays + counters.reflected_rays + counters.refracted_rays +
                             counters.transmitted_rays + counters.shadow_rays;
  const auto per_pixel = [&](const char* name, std::uint64_t count) {
    return row(name, count, pixels > 0 ? static_cast<double>(count) / static_cast<double>(pixels) : 0, "a pixel");
  };
  const auto per_ray = [&](const char* name, std::uint64_t count) {
    return row(name, count, rays > 0 ? static_cast<double>(count) / static_cast<double>(rays) : 0, "a ray");
  };
  std::string text = "rays\n";
  text += per_pixel("camera", counters.camera_rays);
  text += per_pixel("reflected", counters.reflected_rays);
  text += per_pixel("refracted", counters.refracted_rays);
  text += per_pixel("transmitted", counters.transmitted_rays);
  text += per_pixel("shadow", counters.shadow_rays);
  text += per_pixel("all", rays);
  text += "tests\n";
  text += per_ray("boxes", counters.box_tests);
  text += per_ray("objects", counters.solid_tests);
  text += per_ray("hits", counters.hits);
  text += "deepest level        " + std::to_string(counters.deepest_level) + "\n";
  text += "time\n";
  text += time_row("parse", times.parse) + time_row("build", times.build) + time_row("render", times.render) +
          time_row("write", times.write);
  if (times.render > 0) {
    std::array<char, 80> rate;
    std::snprintf(rate.data(), rate.size(), "  %-18s %14.3f million rays a second\n", "rate",
                  static_cast<double>(rays) / times.render / 1e6);
    text += rate.data();
  }
  if (result.estimated_error) {
    std::array<char, 120> error;
    std::snprintf(error.data(), error.size(), "estimated error      %14.6f of 1, root mean square of coded values\n",
                  *result.estimated_error);
    text += error.data();
  }
  return text;
}

}  // namespace lute
