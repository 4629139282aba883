// Antialiasing method 3, lute's own: a pixel is divided where its samples say that its error comes from, until the
// estimated error is below the chosen bound.
//
// Every pixel begins with its four corners (engine/render/corner_samples.hpp). Where they, and those around them, say that their mean
// may be off by more than the bound, its square becomes four cells, and the cells whose samples differ most from those beside them,
// weighted with their area, are divided into four, again and again (engine/render/divided_pixel.hpp). Where a pattern has come to
// light, the pixels around are looked at once more: their few samples may be alike by chance.
#pragma once

#include <cstdint>

#include "engine/render/corner_samples.hpp"
#include "engine/render/error_map.hpp"
#include "engine/render/film.hpp"

namespace lute {

// What the samples of a pixel have shown.
struct PixelFinding {
  float pattern = 0;        // the variance of a pattern of which the pixel has no more than parts; 0: none
  std::uint16_t cells = 0;  // 0: the corners alone
};

// The findings over an area.
class FindingMap {
 public:
  explicit FindingMap(const PixelArea& area);

  const PixelArea& area() const { return area_; }
  PixelFinding& at(int x, int y) { return findings_[index(x, y)]; }
  const PixelFinding& at(int x, int y) const { return findings_[index(x, y)]; }
  // For each pixel of a block the mean of the patterns among the pixels up to kReach away; 0 where there are only a few, as
  // where edges meet. Empty: there are none near the whole block.
  std::vector<double> patterns_near(const PixelArea& block) const;

  static constexpr int kReach = 2;

 private:
  static constexpr int kFewestNear = 3;  // of 5 × 5 pixels

  PixelArea around(const PixelArea& block) const;
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - area_.first_row) * static_cast<std::size_t>(area_.columns()) +
           static_cast<std::size_t>(x - area_.first_column);
  }

  PixelArea area_;
  std::vector<PixelFinding> findings_;
};

// Where the pixels of a render go. Beyond `area` they are rendered for what they show of its own.
struct ErrorDrivenTarget {
  const PixelArea& area;
  Film& film;
  ErrorMap& errors;
};

// Renders one block. `bound` limits the root mean square error of each pixel, in coded values 0...1.
void render_error_driven_block(const PixelArea& block, double bound, const CornerSamples& corners,
                               const DisplayMetric& metric, PixelSource& source, const ErrorDrivenTarget& target,
                               FindingMap& findings);

// Renders the pixels with few samples again that have a pattern near by, with more. `before`: the findings so far.
void look_again_at_block(const PixelArea& block, double bound, const CornerSamples& corners, const DisplayMetric& metric,
                         PixelSource& source, const ErrorDrivenTarget& target, const FindingMap& before,
                         FindingMap& after);

}  // namespace lute
