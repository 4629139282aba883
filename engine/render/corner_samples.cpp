#include "engine/render/corner_samples.hpp"

#include <algorithm>
#include <utility>

#include "engine/render/error_map.hpp"
#include "engine/render/sobol_cell.hpp"

namespace lute {
namespace {

// Of the mean of four corners: in the order of CornerSamples::Corners.
double error_of_corners(const DisplayMetric& metric, const CornerSamples::Corners& at) {
  const auto side = [&](std::size_t a, std::size_t b) {
    return metric.mean_square(dvec4(at[a]->coded) - dvec4(at[b]->coded));
  };
  return kCornerWeight * (side(0, 1) + side(1, 3) + side(3, 2) + side(2, 0));
}

// Where corner (x, y) is sampled: one in every 4 × 4 is 0.27 to 0.4 pixels aside, in one of four directions. Edges still show
// between it and the three others of a pixel.
dvec2 place_of_corner(int x, int y) {
  const dvec2 corner(x - 0.5, y - 0.5);
  if (((x | y) & 3) != 0) return corner;
  const SobolCells points((static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x));
  const dvec2 random = points.point(0, 0, 0);
  const double aside = random.y < 0.5 ? 0.27 + 0.26 * random.y : -0.14 - 0.26 * random.y;
  return corner + (random.x < 0.5 ? dvec2(aside, 0) : dvec2(0, aside));
}

}  // namespace

CornerSamples::CornerSamples(const PixelArea& area, const DisplayMetric& metric)
    : area_{area.first_column - 1, area.first_row - 1, area.last_column + 2, area.last_row + 2},
      area_of_black_{area_.first_column - 2, area_.first_row - 2, area_.last_column + 2, area_.last_row + 2},
      metric_(metric) {
  samples_.resize(static_cast<std::size_t>(area_of_black_.pixels()));
}

std::size_t CornerSamples::index(int x, int y) const {
  return static_cast<std::size_t>(y - area_of_black_.first_row) * static_cast<std::size_t>(area_of_black_.columns()) +
         static_cast<std::size_t>(x - area_of_black_.first_column);
}

void CornerSamples::trace(int x, int y, PixelSource& source) {
  Sample& sample = samples_[index(x, y)];
  sample.color = source.sample(place_of_corner(x, y));
  sample.coded = glm::vec4(metric_.coded(sample.color));
}

void CornerSamples::trace_black(const PixelArea& block, PixelSource& source) {
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column + ((block.first_column ^ y) & 1); x <= block.last_column; x += 2)
      trace(x, y, source);
  }
}

void CornerSamples::fill_white(const PixelArea& block, double bound, PixelSource& source) {
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column + ((block.first_column ^ y ^ 1) & 1); x <= block.last_column; x += 2) {
      if (!interpolate(x, y, bound)) trace(x, y, source);
    }
  }
}

double CornerSamples::difference(int x, int y, const dvec4& from) const {
  return metric_.mean_square(dvec4(samples_[index(x, y)].coded) - from);
}

// How much the black corners at a knight's move differ from `mean`, as a mean square.
double CornerSamples::contrast_farther(int x, int y, const dvec4& mean) const {
  double sum = 0;
  for (const auto& [dx, dy] : {std::pair{1, 2}, {-1, 2}, {1, -2}, {-1, -2}, {2, 1}, {-2, 1}, {2, -1}, {-2, -1}}) {
    sum += difference(x + dx, y + dy, mean);
  }
  return sum / 8;
}

bool CornerSamples::interpolate(int x, int y, double bound) {
  // Half of the bound is left for it: it takes part in four pixels.
  const double allowed = 0.25 * bound * bound;
  // The four corners around are those of a square on its tip.
  const Sample &left = samples_[index(x - 1, y)], &right = samples_[index(x + 1, y)],
               &above = samples_[index(x, y - 1)], &below = samples_[index(x, y + 1)];
  if (error_of_corners(metric_, {&left, &above, &below, &right}) > allowed) return false;
  // Where there is contrast near by, what looks even may be the gap of a pattern.
  constexpr double kShare = 1.0 / 24;
  const glm::vec4 coded = 0.25f * (left.coded + right.coded + above.coded + below.coded);
  if (kShare * contrast_farther(x, y, dvec4(coded)) > allowed) return false;
  Sample& sample = samples_[index(x, y)];
  sample.color = (left.color + right.color + above.color + below.color) * 0.25f;
  sample.coded = coded;
  return true;
}

CornerSamples::Corners CornerSamples::of_pixel(int x, int y) const {
  return {&samples_[index(x, y)], &samples_[index(x + 1, y)], &samples_[index(x, y + 1)],
          &samples_[index(x + 1, y + 1)]};
}

// How much two of the twelve corners around pixel (x, y), with the pixel between them, both differ from the mean of its own.
// Beside one straight edge they never do: it has the pixel on the side of one of the two. In a pattern they do, even where
// the pixel's own corners happen to be alike. `least` where it is less.
double CornerSamples::contrast_across(int x, int y, double least) const {
  constexpr std::size_t kAround = 12;
  constexpr std::array<std::pair<int, int>, kAround> kRing{
      {{-1, -1}, {0, -1}, {1, -1}, {2, -1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {-1, 2}, {-1, 1}, {-1, 0}}};
  const Corners own = of_pixel(x, y);
  const dvec4 mean(0.25f * (own[0]->coded + own[1]->coded + own[2]->coded + own[3]->coded));
  std::array<double, kAround> differences;
  const Sample* const first = &samples_[index(x, y)];
  double greatest = 0;
  for (std::size_t i = 0; i < kAround; ++i) {
    const Sample& sample = first[kRing[i].second * area_of_black_.columns() + kRing[i].first];
    differences[i] = metric_.mean_square(dvec4(sample.coded) - mean);
    greatest = std::max(greatest, differences[i]);
  }
  if (greatest <= least) return least;
  double most = least;
  for (std::size_t i = 0; i < kAround; ++i) {
    // The line to the fifth, sixth and seventh along the ring crosses the pixel.
    const double across = std::max({differences[(i + 5) % kAround], differences[(i + 6) % kAround],
                                    differences[(i + 7) % kAround]});
    most = std::max(most, std::min(differences[i], across));
  }
  return most;
}

double CornerSamples::error_of_pixel(int x, int y, double allowed) const {
  constexpr double kShare = 1.0 / 16;
  const double error = error_of_corners(metric_, of_pixel(x, y));
  return error > allowed ? error : kShare * contrast_across(x, y, error / kShare);
}

}  // namespace lute
