#include "engine/camera/focal_blur.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <random>
#include <span>

#include "engine/camera/jitter.hpp"
#include "engine/texture/noise.hpp"

namespace lute {
namespace {

constexpr std::array<dvec2, 4> kSquareGrid{{{-.25, .25}, {.25, .25}, {-.25, -.25}, {.25, -.25}}};
constexpr std::array<dvec2, 7> kHexGrid7{
    {{-.288675, 0}, {0, 0}, {.288675, 0}, {-.144338, .25}, {-.144338, -.25}, {.144338, .25}, {.144338, -.25}}};
constexpr std::array<dvec2, 19> kHexGrid19{{{-.192450, .333333},
                                            {-.192450, -.333333},
                                            {.192450, .333333},
                                            {.192450, -.333333},
                                            {.384900, 0},
                                            {-.384900, 0},
                                            {0, 0},
                                            {0, .333333},
                                            {0, -.333333},
                                            {-.288675, .166667},
                                            {-.288675, -.166667},
                                            {.288675, .166667},
                                            {.288675, -.166667},
                                            {-.096225, .166667},
                                            {-.096225, -.166667},
                                            {.096225, .166667},
                                            {.096225, -.166667},
                                            {-.192450, 0},
                                            {.192450, 0}}};
constexpr std::array<dvec2, 37> kHexGrid37{
    {{0, 0},           {-.216506, .375}, {.216506, -.375},  {-.216506, -.375}, {.216506, .375},   {-.433013, 0},
     {.433013, 0},     {-.144338, .25},  {.144338, -.25},   {-.144338, -.25},  {.144338, .25},    {-.288675, 0},
     {.288675, 0},     {-.072169, .125}, {.072169, -.125},  {-.072169, -.125}, {.072169, .125},   {-.144338, 0},
     {.144338, 0},     {-.360844, .125}, {-.360844, -.125}, {.360844, .125},   {.360844, -.125},  {-.288675, .25},
     {-.288675, -.25}, {.288675, .25},   {.288675, -.25},   {-.072169, .375},  {-.072169, -.375}, {.072169, .375},
     {.072169, -.375}, {-.216506, .125}, {-.216506, -.125}, {.216506, .125},   {.216506, -.125},  {0, .25},
     {0, -.25}}};

struct Grid {
  std::span<const dvec2> points;
  std::vector<int> batches;
};

Grid grid_for(int count) {
  if (count >= 37) return {kHexGrid37, {7, 6, 6, 4, 4, 4, 4, 2}};
  if (count >= 19) return {kHexGrid19, {7, 6, 6}};
  if (count >= 7) return {kHexGrid7, {7}};
  return {kSquareGrid, {}};
}

double jitter_amplitude(int count) {
  if (count == 7) return 0.144338;
  if (count == 19) return 0.096225;
  if (count == 37) return 0.0721688;
  return 0.5 / std::sqrt(count);
}

// Which cells of a square grid over the lens hold a point already.
class Occupancy {
 public:
  explicit Occupancy(int side) : side_(side), taken_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}
  bool taken(dvec2 p) const { return taken_[cell(p)]; }
  void take(dvec2 p) { taken_[cell(p)] = true; }

 private:
  std::size_t cell(dvec2 p) const {
    const auto index = [this](double c) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor((c + 0.5) * side_)), 0, side_ - 1));
    };
    return index(p.y) * static_cast<std::size_t>(side_) + index(p.x);
  }
  int side_;
  std::vector<bool> taken_;
};

// Sums of a channel and of its square, for the confidence test.
struct ChannelSums {
  std::array<double, 4> sum{}, square{};

  void add(const Color& color) {
    const std::array<float, 4> values{color.rgb.r, color.rgb.g, color.rgb.b, color.transmit};
    for (std::size_t i = 0; i < 4; ++i) {
      const double value = static_cast<double>(values[i]);
      sum[i] += value;
      square[i] += value * value;
    }
  }

  bool below(double threshold, int count) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const double mean = sum[i] / count;
      if (!((square[i] / count - mean * mean) / count < threshold)) return false;
    }
    return true;
  }
};

}  // namespace

double halton(int base, int index) {
  double value = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

FocalBlur::FocalBlur(const Camera& camera, const LensBrightness& brightness)
    : radius_(camera.aperture / 2),
      focal_distance_(camera.focal_distance),
      direction_length_(glm::length(camera.direction)),
      location_(camera.location),
      across_(glm::normalize(glm::cross(camera.up, camera.direction))),
      along_(glm::normalize(glm::cross(camera.direction, across_))),
      minimum_(camera.blur_samples_min) {
  const int count = camera.blur_samples_max;
  points_.reserve(static_cast<std::size_t>(count));
  if (brightness) {
    amplitude_ = 0.5 / std::sqrt(count);
    place_by_brightness(count, brightness);
  } else {
    amplitude_ = jitter_amplitude(count);
    place_on_grid(count);
  }
  set_thresholds(camera);
}

void FocalBlur::place_on_grid(int count) {
  const Grid grid = grid_for(count);
  batches_ = grid.batches;
  const int base = std::min(count, static_cast<int>(grid.points.size()));
  points_.assign(grid.points.begin(), grid.points.begin() + base);

  // Fill the gaps with a low-discrepancy sequence: a free cell of the disc, as long as the budget of draws lasts.
  Occupancy cells(2 * static_cast<int>(std::ceil(std::sqrt(count / kPi))) + 1);
  for (const dvec2& p : points_) cells.take(p);
  int budget = 10 * count, draw = 0;
  const auto next = [&] {
    ++draw;
    --budget;
    const double r = std::sqrt(0.25 * halton(2, draw)), angle = 2 * kPi * halton(3, draw);
    return dvec2(r * std::cos(angle), r * std::sin(angle));
  };
  for (int i = base; i < count; ++i) {
    dvec2 p = next();
    while ((cells.taken(p) || glm::dot(p, p) > 0.25) && budget > count - i) p = next();
    cells.take(p);
    points_.push_back(p);
  }
}

void FocalBlur::place_by_brightness(int count, const LensBrightness& brightness) {
  std::mt19937 random;
  random.discard(1);
  int draw = 0;
  for (int i = 0; i < count; ++i) {
    for (int tries = 0;; ++tries) {
      ++draw;
      const dvec2 p(halton(2, draw) - 0.5, halton(3, draw) - 0.5);
      const double weight = brightness(p) + static_cast<double>(tries) / (static_cast<double>(count) * count);
      if (static_cast<double>(random()) / 4294967296.0 > weight) continue;
      points_.push_back(p);
      break;
    }
  }
}

void FocalBlur::set_thresholds(const Camera& camera) {
  const int count = camera.blur_samples_max;
  thresholds_.assign(static_cast<std::size_t>(count) + 1, 0.0);
  if (count == 1) return;
  // The value that a chi-square variable of k degrees of freedom exceeds with the camera's confidence.
  const auto chi = [&](int k) { return 2 * boost::math::gamma_q_inv(k / 2.0, camera.confidence); };
  const double last = chi(count - 1);
  for (int n = 1; n <= count; ++n) thresholds_[static_cast<std::size_t>(n)] = camera.variance * chi(n) / last;
}

int FocalBlur::batch_size(std::size_t batch) const { return batch < batches_.size() ? batches_[batch] : 4; }

Ray FocalBlur::through_lens(const ProjectedRay& ray, dvec2 position, int index) const {
  const dvec2 on_lens = points_[static_cast<std::size_t>(index)];
  const dvec2 shift = 2 * amplitude_ * jitter({position.x + 0.5, position.y - 0.5});
  const dvec3 offset = radius_ * (on_lens.x + shift.x) * across_ - radius_ * (on_lens.y + shift.y) * along_;
  const dvec3 direction = ray.direction * (focal_distance_ / direction_length_) - offset;
  return {location_ + offset, glm::normalize(direction)};
}

Color FocalBlur::sample(dvec2 position, const ProjectRay& project, const TraceRay& trace) const {
  const auto hash = [](int n) { return static_cast<int>(hash_table(static_cast<std::uint32_t>(n)) & 15u); };
  const int seed = static_cast<int>(313 * position.x + 11) + static_cast<int>(311 * position.y + 17);
  const int count = static_cast<int>(points_.size());
  Color sum;
  ChannelSums sums;
  int n = 0;
  for (std::size_t batch = 0; n < count; ++batch) {
    for (int left = batch_size(batch); left > 0 && n < count; --left, ++n) {
      // Move the ray inside the pixel by one of 16x16 places and its jitter.
      const dvec2 place((2 * hash(seed + n) + 1) / 32.0 - 0.5, (2 * hash(seed + n + 1) + 1) / 32.0 - 0.5);
      const dvec2 moved = position + place + (jitter(place) - 0.5) / 16.0;
      ProjectedRay ray;
      Color color;
      if (project(moved, ray)) {
        color = trace(through_lens(ray, moved, n));
        sum += color;
      } else {
        color.transmit = 1;
      }
      sums.add(color);
    }
    if (n >= minimum_ && sums.below(thresholds_[static_cast<std::size_t>(n)], n)) break;
  }
  return sum * (1.0f / static_cast<float>(n));
}

}  // namespace lute
