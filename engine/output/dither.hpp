// Dithering: ordered (Bayer) or by diffusing the error of rounding. Source: specification chapter 30 §7.6.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lute {

enum class DitherMethod : std::uint8_t { kNone, kBayer2, kBayer3, kBayer4, kDiffusion1, kDiffusion2, kFloydSteinberg };

// Works through an image row by row, each from left to right.
class Dither {
 public:
  using PixelError = std::array<float, 4>;  // by channel

  Dither(DitherMethod method, int width);

  void begin_row();  // before every row, the first included

  // What ordered dithering adds before rounding, in steps of the output; 0 for the others.
  float step_offset(int column, int row) const;

  // The error carried to a pixel, and what becomes of the error made there.
  const PixelError& carried(int column) const { return current_[index(column)]; }
  void spread(int column, const PixelError& error);

  bool diffuses() const { return method_ >= DitherMethod::kDiffusion1; }

 private:
  static std::size_t index(int column) { return static_cast<std::size_t>(column + 1); }
  static void add(PixelError& target, const PixelError& error, float share);

  DitherMethod method_;
  std::vector<PixelError> current_, below_;  // with a column before the first and one after the last
  PixelError first_column_{};  // what was pushed down to column 0 arrives one row late, as in the reference
};

}  // namespace lute
