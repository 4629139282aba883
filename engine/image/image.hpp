// A decoded image as textures and height fields use it: row 0 is the top. Colours are in the scene's working space if the image was
// loaded for colours, else as the file stores them. Immutable, shared between threads.
// Source: specification chapters 30 §7.9 and 50 §11.2.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/image/color.hpp"

namespace lute {

class Image {
 public:
  // One pixel: what a file stores, alpha 1 where it has none. Premultiplied if premultiplied().
  struct Pixel {
    Rgb rgb;
    float alpha = 1;
  };

  // Samples are integers of `maximum` + 1 values that `decoded` turns into colours; alpha is never decoded. `channels` is 1 (grey),
  // 2 (grey, alpha), 3 or 4.
  Image(int width, int height, int channels, std::vector<std::uint8_t> samples, std::vector<float> decoded);
  Image(int width, int height, int channels, std::vector<std::uint16_t> samples, std::vector<float> decoded);
  Image(int width, int height, int channels, std::vector<float> samples);
  // A palette image: one index for each pixel, all of them below the size of the palette.
  Image(int width, int height, std::vector<std::uint8_t> indices, std::vector<Pixel> palette);

  int width() const { return width_; }
  int height() const { return height_; }
  bool has_alpha() const { return has_alpha_; }
  // Files of some formats count as having alpha, even where all of it is 1.
  bool keeps_alpha() const { return has_alpha_ || format_keeps_alpha_; }
  void set_format_keeps_alpha() { format_keeps_alpha_ = true; }
  bool premultiplied() const { return premultiplied_; }
  void set_premultiplied(bool premultiplied) { premultiplied_ = premultiplied && (has_alpha_ || format_keeps_alpha_); }

  std::span<const Pixel> palette() const { return palette_; }
  bool is_palette() const { return !palette_.empty(); }
  int index(int column, int row) const { return bytes_[offset(column, row)]; }  // of a palette image

  Pixel pixel(int column, int row) const;
  // The height that a height field takes from a pixel, 0...65535; alpha and a palette's colours do not count (chapter 21 §6.2).
  std::uint16_t height_at(int column, int row) const;
  bool is_grey() const { return channels_ < 3 && !is_palette(); }
  bool is_deep() const { return bytes_.empty(); }  // more than 8 bits a sample

 private:
  std::size_t offset(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  int width_, height_, channels_;
  bool has_alpha_ = false, format_keeps_alpha_ = false, premultiplied_ = false;
  std::vector<std::uint8_t> bytes_;     // samples, or indices into the palette
  std::vector<std::uint16_t> words_;
  std::vector<float> floats_;
  std::vector<float> decoded_;          // colour of a sample
  float alpha_scale_ = 1;
  std::vector<Pixel> palette_;
};
using ImagePtr = std::shared_ptr<const Image>;

}  // namespace lute
