#include "engine/render/error_driven_pixel.hpp"

#include <algorithm>

#include "engine/render/divided_pixel.hpp"

namespace lute {
namespace {

constexpr int kCellsOfSecondLevel = 16;
// A pixel in a pattern whose few samples are alike is off by the whole of its variance; one beside a pattern seldom is in it.
constexpr double kRiskNearAPattern = 1.0 / 16;

bool contains(const PixelArea& area, int x, int y) {
  return x >= area.first_column && x <= area.last_column && y >= area.first_row && y <= area.last_row;
}

// Where the pixels of one block go.
class BlockTarget {
 public:
  BlockTarget(const ErrorDrivenTarget& target, FindingMap& findings) : target_(target), findings_(findings) {}

  void put(int x, int y, const Color& color, double error, const PixelFinding& finding) {
    findings_.at(x, y) = finding;
    if (!contains(target_.area, x, y)) return;
    target_.film.at(x, y) = color;
    target_.errors.at(x, y) = static_cast<float>(error);
  }

  void put(int x, int y, const Color& color, const DividedPixel& pixel) {
    put(x, y, color, pixel.error(),
        {static_cast<float>(pixel.pattern()), static_cast<std::uint16_t>(pixel.cells())});
  }

 private:
  const ErrorDrivenTarget& target_;
  FindingMap& findings_;
};

template <typename DoPixel>
void for_each_pixel(const PixelArea& block, DoPixel do_pixel) {
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) do_pixel(x, y);
  }
}

}  // namespace

FindingMap::FindingMap(const PixelArea& area) : area_(area), findings_(static_cast<std::size_t>(area.pixels())) {}

PixelArea FindingMap::around(const PixelArea& block) const {
  return {std::max(block.first_column - kReach, area_.first_column), std::max(block.first_row - kReach, area_.first_row),
          std::min(block.last_column + kReach, area_.last_column), std::min(block.last_row + kReach, area_.last_row)};
}

bool FindingMap::any_pattern_near(const PixelArea& block) const {
  bool any = false;
  for_each_pixel(around(block), [&](int x, int y) { any = any || at(x, y).pattern > 0; });
  return any;
}

double FindingMap::pattern_near(int x, int y) const {
  int count = 0;
  double sum = 0;
  for_each_pixel(around({x, y, x, y}), [&](int column, int row) {
    const double pattern = at(column, row).pattern;
    count += pattern > 0 ? 1 : 0;
    sum += pattern;
  });
  return count < kFewestNear ? 0 : sum / count;
}

void render_error_driven_block(const PixelArea& block, double bound, const CornerSamples& corners,
                               const DisplayMetric& metric, PixelSource& source, const ErrorDrivenTarget& target,
                               FindingMap& findings) {
  DividedPixel pixel(metric, source, bound);
  BlockTarget out(target, findings);
  for_each_pixel(block, [&](int x, int y) {
    const CornerSamples::Corners at = corners.of_pixel(x, y);
    const double error = corners.error_of_pixel(x, y, bound * bound);
    if (error <= bound * bound) {
      out.put(x, y, (at[0]->color + at[1]->color + at[2]->color + at[3]->color) * 0.25f, error, {});
    } else {
      out.put(x, y, pixel.render(x, y, at, 1), pixel);
    }
  });
}

void look_again_at_block(const PixelArea& block, double bound, const CornerSamples& corners, const DisplayMetric& metric,
                         PixelSource& source, const ErrorDrivenTarget& target, const FindingMap& before,
                         FindingMap& after) {
  if (!before.any_pattern_near(block)) return;
  DividedPixel pixel(metric, source, bound);
  BlockTarget out(target, after);
  for_each_pixel(block, [&](int x, int y) {
    if (before.at(x, y).cells >= kCellsOfSecondLevel) return;
    if (kRiskNearAPattern * before.pattern_near(x, y) <= bound * bound) return;
    out.put(x, y, pixel.render(x, y, corners.of_pixel(x, y), 2), pixel);
  });
}

}  // namespace lute
