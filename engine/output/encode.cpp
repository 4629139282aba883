#include "engine/output/encode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/output/code_table.hpp"

namespace lute {
namespace {

float clip(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }  // NaN becomes 0

// A pixel's channels in working space before rounding.
struct Channels {
  std::array<float, 4> values{};
  int colors = 3;  // how many of them are colour; then comes alpha, if any
};

// Colour over alpha: highlights may be brighter than the alpha allows, so alpha grows with them.
void unpremultiply(Rgb& rgb, float& alpha) {
  const float brightness = grey(rgb);
  if (brightness > alpha) alpha = std::min(1.0f, brightness);
  rgb *= 1.0f / (alpha == 0 ? 1e-6f : alpha);
}

Channels channels_of(const Color& color, bool alpha_wanted, bool greyscale) {
  Rgb rgb = color.rgb;
  float alpha = 1 - color.transmit;
  if (alpha_wanted) unpremultiply(rgb, alpha);
  if (greyscale) return {{file_grey(rgb), alpha, 0, 0}, 1};
  return {{rgb.r, rgb.g, rgb.b, alpha}, 3};
}

int code_bits(const OutputSettings& settings) {
  if (settings.format == FileFormat::kPng) return settings.greyscale ? 16 : std::clamp(settings.bits, 5, 16);
  if (settings.format == FileFormat::kPpm) return std::clamp(settings.bits, 5, 16);
  return 8;
}

int channel_count(const OutputSettings& settings) {
  const FormatTraits& traits = traits_of(settings.format);
  return (settings.greyscale && traits.has_greyscale ? 1 : 3) + (settings.alpha && traits.has_alpha ? 1 : 0);
}

DitherMethod dither_of(const OutputSettings& settings) {
  return settings.format == FileFormat::kJpeg ? DitherMethod::kNone : settings.dither;
}

class Encoder {
 public:
  Encoder(const Film& film, const Transfer& transfer, const OutputSettings& settings)
      : film_(film),
        transfer_(transfer),
        alpha_(settings.alpha && traits_of(settings.format).has_alpha),
        greyscale_(settings.greyscale && traits_of(settings.format).has_greyscale),
        encodes_(!(greyscale_ && settings.format == FileFormat::kPpm)),  // a PGM holds heights, not light
        bottom_up_(settings.format == FileFormat::kBmp),
        dither_(dither_of(settings), film.width()) {
    image_.width = film.width();
    image_.height = film.height();
    image_.channels = channel_count(settings);
    image_.max = (1 << code_bits(settings)) - 1;
    image_.codes.resize(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height) *
                        static_cast<std::size_t>(image_.channels));
    if (encodes_by_table(settings, film.width(), film.height()))
      curve_.emplace([this](float v) { return code_of(encodes_ ? transfer_.encode(v) : v); }, image_.max);
  }

  EncodedImage run() {
    for (int i = 0; i < film_.height(); ++i) {
      const int y = bottom_up_ ? film_.height() - 1 - i : i;
      if (curve_ && !alpha_ && !greyscale_) {
        row_by_table(y);
        continue;
      }
      dither_.begin_row();
      for (int x = 0; x < film_.width(); ++x) pixel(x, y);
    }
    return std::move(image_);
  }

 private:
  int code_of(float number) const { return static_cast<int>(std::floor(clip(number) * static_cast<float>(image_.max) + 0.5f)); }

  // What most pictures need of pixel(): colour alone, each channel by itself.
  void row_by_table(int y) {
    std::uint16_t* codes = image_.codes.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) * 3;
    for (int x = 0; x < image_.width; ++x, codes += 3) {
      const Rgb rgb = film_.at(x, y).rgb;
      codes[0] = static_cast<std::uint16_t>((*curve_)(rgb.r));
      codes[1] = static_cast<std::uint16_t>((*curve_)(rgb.g));
      codes[2] = static_cast<std::uint16_t>((*curve_)(rgb.b));
    }
  }

  void pixel(int x, int y) {
    const Channels pixel = channels_of(film_.at(x, y), alpha_, greyscale_);
    const std::size_t first =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x)) *
        static_cast<std::size_t>(image_.channels);
    if (curve_) {
      for (int i = 0; i < image_.channels; ++i) {
        const auto c = static_cast<std::size_t>(i);
        const float value = pixel.values[c];
        image_.codes[first + c] = static_cast<std::uint16_t>(i < pixel.colors ? (*curve_)(value) : code_of(value));
      }
      return;
    }
    const float max = static_cast<float>(image_.max);
    const float offset = dither_.step_offset(x, y) / max;
    Dither::PixelError error{};
    for (int i = 0; i < image_.channels; ++i) {
      const auto c = static_cast<std::size_t>(i);
      const bool encoded = encodes_ && i < pixel.colors;
      float value = pixel.values[c];
      if (dither_.diffuses()) value = clip(value + dither_.carried(x)[c]);
      const float number = encoded ? transfer_.encode(value) : value;
      const int code = code_of(number + offset);
      image_.codes[first + c] = static_cast<std::uint16_t>(code);
      const float stored = static_cast<float>(code) / max;
      if (dither_.diffuses()) error[c] = value - (encoded ? transfer_.decode(stored) : stored);
    }
    if (dither_.diffuses()) dither_.spread(x, error);
  }

  const Film& film_;
  const Transfer& transfer_;
  bool alpha_, greyscale_, encodes_, bottom_up_;
  Dither dither_;
  EncodedImage image_;
  std::optional<CodeTable> curve_;  // of the colours, where it is worth its making
};

}  // namespace

bool encodes_by_table(const OutputSettings& settings, int width, int height) {
  constexpr long kWorthATable = 20000;  // codes; making one costs about as much as so many curves
  return !traits_of(settings.format).linear_light && dither_of(settings) == DitherMethod::kNone && code_bits(settings) <= 8 &&
         static_cast<long>(width) * height * channel_count(settings) >= kWorthATable;
}

EncodedImage encode(const Film& film, const Transfer& transfer, const OutputSettings& settings) {
  return Encoder(film, transfer, settings).run();
}

ImagePixels linear_light(const Film& film, const Transfer& transfer, const OutputSettings& settings) {
  const bool alpha = settings.alpha && traits_of(settings.format).has_alpha;
  const bool greyscale = settings.greyscale && traits_of(settings.format).has_greyscale;
  ImagePixels image{film.width(), film.height(), (greyscale ? 1 : 3) + (alpha ? 1 : 0), {}};
  image.values.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                       static_cast<std::size_t>(image.channels));
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Color& color = film.at(x, y);
      const Rgb light{transfer.light(color.rgb.r), transfer.light(color.rgb.g), transfer.light(color.rgb.b)};
      if (greyscale) {
        image.values.push_back(grey(light));
      } else {
        image.values.insert(image.values.end(), {light.r, light.g, light.b});
      }
      if (alpha) image.values.push_back(1 - color.transmit);
    }
  }
  return image;
}

}  // namespace lute
