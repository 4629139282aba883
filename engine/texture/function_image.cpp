#include "engine/texture/function_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lute {

namespace {

// The function at every pixel's place, row by row; `take` is given the results of one pixel.
template <class Take>
void sample(const Function& function, int width, int height, Take take) {
  constexpr int kAtOnce = 256;
  std::array<double, 3 * kAtOnce> arguments{};
  std::array<double, Function::kMostResults * kAtOnce> results{};
  const auto place = [](int i, int size) { return size > 1 ? static_cast<double>(i) / (size - 1) : 0.0; };
  for (int row = 0; row < height; ++row)
    for (int first = 0; first < width; first += kAtOnce) {
      const auto count = static_cast<std::size_t>(std::min(kAtOnce, width - first));
      for (std::size_t i = 0; i < count; ++i) {
        arguments[i] = place(first + static_cast<int>(i), width);
        arguments[kAtOnce + i] = place(row, height);
      }
      function.evaluate_many(count, kAtOnce, arguments.data(), results.data());
      for (std::size_t i = 0; i < count; ++i) take([&](std::size_t k) { return static_cast<float>(results[k * kAtOnce + i]); });
    }
}

}  // namespace

ImagePtr sample_function(const Function& function, int width, int height) {
  const int channels = function.is_vector() ? 4 : 1;
  std::vector<std::uint16_t> samples;
  samples.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels));
  // Values outside 0...1 wrap around, as the reference has it; those that no 32-bit integer holds are 0.
  const auto store = [&](float v) {
    const float scaled = v * 65535.0f;
    const bool held = scaled > -2147483904.0f && scaled < 2147483648.0f;
    samples.push_back(static_cast<std::uint16_t>(held ? static_cast<std::int64_t>(scaled) & 0xFFFF : 0));
  };
  sample(function, width, height, [&](const auto& result) {
    for (std::size_t c = 0; c < (channels == 1 ? 1u : 3u); ++c) store(result(c));
    if (channels == 4) store(1 - result(4));
  });
  std::vector<float> decoded(65536);
  for (std::size_t i = 0; i < decoded.size(); ++i) decoded[i] = static_cast<float>(i) / 65535.0f;
  return std::make_shared<Image>(width, height, channels, std::move(samples), std::move(decoded));
}

}  // namespace lute
