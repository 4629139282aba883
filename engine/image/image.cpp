#include "engine/image/image.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lute {

Image::Image(int width, int height, int channels, std::vector<std::uint8_t> samples, std::vector<float> decoded)
    : width_(width), height_(height), channels_(channels), has_alpha_(channels % 2 == 0), bytes_(std::move(samples)),
      decoded_(std::move(decoded)), alpha_scale_(1.0f / 255.0f) {}

Image::Image(int width, int height, int channels, std::vector<std::uint16_t> samples, std::vector<float> decoded)
    : width_(width), height_(height), channels_(channels), has_alpha_(channels % 2 == 0), words_(std::move(samples)),
      decoded_(std::move(decoded)), alpha_scale_(1.0f / 65535.0f) {}

Image::Image(int width, int height, int channels, std::vector<float> samples)
    : width_(width), height_(height), channels_(channels), has_alpha_(channels % 2 == 0), floats_(std::move(samples)) {}

Image::Image(int width, int height, std::vector<std::uint8_t> indices, std::vector<Pixel> palette)
    : width_(width), height_(height), channels_(1), bytes_(std::move(indices)), palette_(std::move(palette)) {
  has_alpha_ = std::any_of(palette_.begin(), palette_.end(), [](const Pixel& p) { return p.alpha != 1; });
}

Image::Pixel Image::pixel(int column, int row) const {
  const std::size_t place = offset(column, row);
  if (is_palette()) return palette_[bytes_[place]];
  const std::size_t first = place * static_cast<std::size_t>(channels_);
  const auto make = [this](auto colour, auto alpha) {
    Pixel p;
    p.rgb = channels_ < 3 ? Rgb(colour(0)) : Rgb(colour(0), colour(1), colour(2));
    if (has_alpha_) p.alpha = alpha(static_cast<std::size_t>(channels_) - 1);
    return p;
  };
  if (!bytes_.empty())
    return make([&](std::size_t c) { return decoded_[bytes_[first + c]]; },
                [&](std::size_t c) { return static_cast<float>(bytes_[first + c]) * alpha_scale_; });
  if (!words_.empty())
    return make([&](std::size_t c) { return decoded_[words_[first + c]]; },
                [&](std::size_t c) { return static_cast<float>(words_[first + c]) * alpha_scale_; });
  const auto plain = [&](std::size_t c) { return floats_[first + c]; };
  return make(plain, plain);
}

std::uint16_t Image::height_at(int column, int row) const {
  if (is_palette()) return static_cast<std::uint16_t>(index(column, row) * 256);
  const Rgb c = pixel(column, row).rgb;
  const auto code = [](float v, float maximum) { return static_cast<int>(std::lround(std::clamp(v, 0.0f, 1.0f) * maximum)); };
  if (is_deep()) {
    if (is_grey() && floats_.empty()) return static_cast<std::uint16_t>(code(c.r, 65535));
    return static_cast<std::uint16_t>(std::clamp(grey(c), 0.0f, 1.0f) * 65535);
  }
  if (is_grey()) return static_cast<std::uint16_t>(257 * code(c.r, 255));
  return static_cast<std::uint16_t>(256 * code(c.r, 255) + code(c.g, 255));
}

}  // namespace lute
