#include "engine/texture/function_image.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lute {

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
  const auto place = [](int i, int size) { return size > 1 ? static_cast<double>(i) / (size - 1) : 0.0; };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double arguments[3] = {place(column, width), place(row, height), 0};
      double results[5] = {0, 0, 0, 0, 0};
      function.evaluate(arguments, results);
      if (channels == 1) {
        store(static_cast<float>(results[0]));
      } else {
        for (int c = 0; c < 3; ++c) store(static_cast<float>(results[c]));
        store(1 - static_cast<float>(results[4]));
      }
    }
  std::vector<float> decoded(65536);
  for (std::size_t i = 0; i < decoded.size(); ++i) decoded[i] = static_cast<float>(i) / 65535.0f;
  return std::make_shared<Image>(width, height, channels, std::move(samples), std::move(decoded));
}

}  // namespace lute
