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

std::vector<double> FindingMap::patterns_near(const PixelArea& block) const {
  struct Near {
    int count = 0;
    double sum = 0;
  };
  std::vector<Near> near;
  const auto place = [&block](int x, int y) {
    return static_cast<std::size_t>(y - block.first_row) * static_cast<std::size_t>(block.columns()) +
           static_cast<std::size_t>(x - block.first_column);
  };
  for_each_pixel(around(block), [&](int x, int y) {
    const double pattern = at(x, y).pattern;
    if (!(pattern > 0)) return;
    near.resize(static_cast<std::size_t>(block.pixels()));
    const PixelArea reached{std::max(x - kReach, block.first_column), std::max(y - kReach, block.first_row),
                            std::min(x + kReach, block.last_column), std::min(y + kReach, block.last_row)};
    for_each_pixel(reached, [&](int column, int row) {
      Near& n = near[place(column, row)];
      ++n.count;
      n.sum += pattern;
    });
  });
  std::vector<double> means;
  means.reserve(near.size());
  for (const Near& n : near) means.push_back(n.count < kFewestNear ? 0 : n.sum / n.count);
  return means;
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
  const std::vector<double> patterns = before.patterns_near(block);
  if (patterns.empty()) return;
  DividedPixel pixel(metric, source, bound);
  BlockTarget out(target, after);
  std::size_t number = 0;
  for_each_pixel(block, [&](int x, int y) {
    const double pattern = patterns[number++];
    if (kRiskNearAPattern * pattern <= bound * bound || before.at(x, y).cells >= kCellsOfSecondLevel) return;
    out.put(x, y, pixel.render(x, y, corners.of_pixel(x, y), 2), pixel);
  });
}

}  // namespace lute
