#include "compare/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace lute::compare {

namespace {

constexpr int kBlock = 8;
// Values of 8-bit files are n/255 in single precision: a difference of exactly the tolerance must count as within it.
constexpr double kRounding = 1e-6;

void demand_one_size(const Picture& a, const Picture& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw std::runtime_error("the pictures differ in size: " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                           " and " + std::to_string(b.width) + "x" + std::to_string(b.height));
}

double channel_difference(float a, float b) {
  const bool finite = std::isfinite(a) && std::isfinite(b);
  if (finite) return std::abs(static_cast<double>(a) - static_cast<double>(b));
  const bool same = a == b || (std::isnan(a) && std::isnan(b));
  return same ? 0.0 : 1.0;
}

bool has_alpha(const Picture& picture) {
  for (std::size_t i = 3; i < picture.values.size(); i += Picture::kChannels) {
    if (picture.values[i] != 1.0f) return true;
  }
  return false;
}

// The difference of the means of one block, the largest of the channels.
double block_difference(const Picture& a, const Picture& b, int left, int top, int channels) {
  double largest = 0;
  const int right = std::min(left + kBlock, a.width), bottom = std::min(top + kBlock, a.height);
  for (int c = 0; c < channels; ++c) {
    double sum = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const double from = a.at(x, y)[c], to = b.at(x, y)[c];
        sum += std::isfinite(from) && std::isfinite(to) ? from - to : channel_difference(a.at(x, y)[c], b.at(x, y)[c]);
      }
    }
    largest = std::max(largest, std::abs(sum) / ((right - left) * (bottom - top)));
  }
  return largest;
}

double block_percentile(const Picture& a, const Picture& b, int channels) {
  std::vector<double> blocks;
  for (int top = 0; top < a.height; top += kBlock) {
    for (int left = 0; left < a.width; left += kBlock) blocks.push_back(block_difference(a, b, left, top, channels));
  }
  if (blocks.empty()) return 0;
  std::sort(blocks.begin(), blocks.end());
  const double position = 0.98 * static_cast<double>(blocks.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, blocks.size() - 1);
  return std::lerp(blocks[below], blocks[above], position - std::floor(position));
}

}  // namespace

Difference difference(const Picture& a, const Picture& b, double tolerance_255) {
  demand_one_size(a, b);
  Difference result;
  result.tolerance_255 = tolerance_255;
  result.pixels = a.pixels();
  result.alpha_compared = has_alpha(a) || has_alpha(b);
  const int channels = result.alpha_compared ? 4 : 3;
  const double tolerance = tolerance_255 / 255.0 + kRounding;

  double sum = 0, squares = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < a.values.size(); i += Picture::kChannels) {
    double pixel = 0;
    for (int c = 0; c < channels; ++c) {
      const auto index = i + static_cast<std::size_t>(c);
      const double d = channel_difference(a.values[index], b.values[index]);
      pixel = std::max(pixel, d);
      sum += d;
      squares += d * d;
    }
    result.maximum = std::max(result.maximum, pixel);
    if (pixel <= tolerance) ++inside;
  }
  const double count = static_cast<double>(a.pixels()) * channels;
  result.mean = sum / count;
  result.rmse = std::sqrt(squares / count);
  result.psnr = squares == 0 ? std::numeric_limits<double>::infinity() : -20.0 * std::log10(result.rmse);
  result.within = static_cast<double>(inside) / static_cast<double>(a.pixels());
  result.block98_255 = 255.0 * block_percentile(a, b, channels);
  return result;
}

namespace {

// Heat of t in 0…1: black, blue, magenta, red, yellow, white.
std::array<float, 3> heat(double t) {
  static constexpr std::array<std::array<float, 3>, 6> kStops = {
      {{0, 0, 0}, {0.1f, 0.1f, 0.7f}, {0.7f, 0, 0.6f}, {0.95f, 0.2f, 0.1f}, {1, 0.85f, 0.1f}, {1, 1, 1}}};
  const double position = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
  const auto share = static_cast<float>(position - static_cast<double>(below));
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = std::lerp(kStops[below][c], kStops[below + 1][c], share);
  return color;
}

}  // namespace

Picture heat_map(const Picture& a, const Picture& b, double full) {
  demand_one_size(a, b);
  Picture map(a.width, a.height);
  for (std::size_t i = 0; i < a.values.size(); i += Picture::kChannels) {
    double pixel = 0;
    for (std::size_t c = 0; c < Picture::kChannels; ++c) {
      pixel = std::max(pixel, channel_difference(a.values[i + c], b.values[i + c]));
    }
    const std::array<float, 3> color = heat(pixel / full);
    std::copy(color.begin(), color.end(), map.values.begin() + static_cast<std::ptrdiff_t>(i));
    map.values[i + 3] = 1;
  }
  return map;
}

}  // namespace lute::compare
