#include "engine/render/error_driven_pixel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/render/sobol_cell.hpp"

namespace lute {
namespace {

constexpr int kDeepest = 5;                  // 32 × 32 cells
constexpr int kSide = 1 << kDeepest;         // of the smallest cells in a pixel
constexpr double kGainOfDivision = 7.0 / 8;  // an edge crosses two of four parts, each with a quarter of the area

struct Cell {
  int level, column, row;
  dvec2 at;  // the sample, in the pixel's square
  Color color;
  double error = 0;  // its share of the pixel's mean square error

  int size() const { return kSide >> level; }  // in smallest cells
  double area() const { return 1.0 / static_cast<double>(1 << (2 * level)); }
};

// Which cell covers each of the smallest ones.
using CellMap = std::array<std::uint16_t, kSide * kSide>;

constexpr CellMap kFourCells = [] {
  CellMap map{};
  for (int i = 0; i < kSide * kSide; ++i) {
    map[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(2 * (i / kSide * 2 / kSide) + i % kSide * 2 / kSide);
  }
  return map;
}();

// Of the mean of four corners: in the order of CornerSamples::Corners.
double error_of_corners(const DisplayMetric& metric, const CornerSamples::Corners& at) {
  const auto side = [&](std::size_t a, std::size_t b) {
    return metric.mean_square(dvec4(at[a]->coded) - dvec4(at[b]->coded));
  };
  return kCornerWeight * (side(0, 1) + side(1, 3) + side(3, 2) + side(2, 0));
}

// One pixel under division. Kept for the pixels of a block, so that its memory is.
class DividedPixel {
 public:
  DividedPixel(const DisplayMetric& metric, PixelSource& source, double bound)
      : metric_(metric), source_(source), allowed_(bound * bound) {}

  Color render(int x, int y, const CornerSamples::Corners& corners) {
    left_ = x - 0.5;
    top_ = y - 0.5;
    for (std::size_t i = 0; i < 4; ++i) corners_[i] = channels(corners[i]->color);
    const SobolCells points((static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
                            static_cast<std::uint32_t>(y));
    cells_.clear();
    for (int i = 0; i < 4; ++i) cells_.push_back(sampled(points, 1, i & 1, i >> 1));
    owner_ = kFourCells;
    estimate();
    if (error_ <= allowed_) return mean_with(corners);
    while (error_ > allowed_ && divide_worst(points)) estimate();
    return mean();
  }

  double error() const { return error_; }

 private:
  Cell sampled(const SobolCells& points, int level, int column, int row) {
    const dvec2 at = points.point(level, column, row);
    return {level, column, row, at, source_.sample({left_ + at.x, top_ + at.y})};
  }

  void paint(std::size_t number) {
    const Cell& cell = cells_[number];
    const int size = cell.size();
    for (int y = cell.row * size; y < (cell.row + 1) * size; ++y) {
      std::fill_n(&owner_[static_cast<std::size_t>(y * kSide + cell.column * size)], size,
                  static_cast<std::uint16_t>(number));
    }
  }

  Color mean() const {
    Color sum;
    for (const Cell& cell : cells_) sum += cell.color * static_cast<float>(cell.area());
    return sum;
  }

  void estimate() {
    const dvec4 sensitivity = metric_.sensitivity(mean());
    error_ = 0;
    for (Cell& cell : cells_) {
      cell.error = std::min(1.0, kSideWeight * cell.area() * cell.area() * contrast(cell, sensitivity));
      error_ += cell.error;
    }
    error_ = std::min(error_, 1.0);
  }

  // An edge that crosses the pixel anywhere makes the mean of four cells off by h² / 48, that of the corners by h² /
  // 12: together they are best with weights of 4 and 1.
  Color mean_with(const CornerSamples::Corners& corners) {
    Color sum = mean() * 0.8f;
    for (const CornerSamples::Sample* corner : corners) sum += corner->color * 0.05f;
    error_ *= 0.8;
    return sum;
  }

  // What stands beside a cell at the border of the pixel, `along` it from 0 to 1: between two corners.
  dvec4 border(std::size_t from, std::size_t to, double along) const {
    return corners_[from] + along * (corners_[to] - corners_[from]);
  }

  // Squared differences from what is beside the cell, over its four sides. An edge between two samples lies in the cell
  // with the chance of its share of the way between them; an edge before the border always does.
  double contrast(const Cell& cell, const dvec4& sensitivity) const {
    const dvec4 own = channels(cell.color);
    const int size = cell.size(), x = cell.column * size, y = cell.row * size;
    const auto square = [&](const dvec4& other) { return glm::dot(sensitivity, (other - own) * (other - own)); };
    const auto inside = [&](int first_x, int first_y, int step_x, int step_y) {
      double sum = 0;
      for (int i = 0; i < size;) {
        const Cell& other = cell_at(first_x + i * step_x, first_y + i * step_y);
        const int touched = std::min(size, other.size());
        sum += square(channels(other.color)) * touched / (size + other.size());
        i += touched;
      }
      return sum;
    };
    const double along_x = (x + 0.5 * size) / kSide, along_y = (y + 0.5 * size) / kSide;
    double sum = x == 0 ? square(border(0, 2, along_y)) : inside(x - 1, y, 0, 1);
    sum += x + size == kSide ? square(border(1, 3, along_y)) : inside(x + size, y, 0, 1);
    sum += y == 0 ? square(border(0, 1, along_x)) : inside(x, y - 1, 1, 0);
    sum += y + size == kSide ? square(border(2, 3, along_x)) : inside(x, y + size, 1, 0);
    return sum;
  }

  const Cell& cell_at(int x, int y) const { return cells_[owner_[static_cast<std::size_t>(y * kSide + x)]]; }

  // Divides as few cells as should bring the error below the bound; false when none can be divided.
  bool divide_worst(const SobolCells& points) {
    order_.clear();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i].level < kDeepest && cells_[i].error > 0) order_.push_back(i);
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [this](std::size_t a, std::size_t b) { return cells_[a].error > cells_[b].error; });
    double expected = error_;
    for (const std::size_t number : order_) {
      if (expected <= allowed_) break;
      expected -= kGainOfDivision * cells_[number].error;
      divide(points, number);
    }
    return !order_.empty();
  }

  // The part that holds the cell's own point keeps it.
  void divide(const SobolCells& points, std::size_t number) {
    const Cell whole = cells_[number];
    const int level = whole.level + 1, cells = 1 << level;
    const int own_column = static_cast<int>(whole.at.x * cells), own_row = static_cast<int>(whole.at.y * cells);
    for (int i = 0; i < 4; ++i) {
      const int column = 2 * whole.column + (i & 1), row = 2 * whole.row + (i >> 1);
      if (column == own_column && row == own_row) {
        cells_[number] = {level, column, row, whole.at, whole.color};
        paint(number);
      } else {
        cells_.push_back(sampled(points, level, column, row));
        paint(cells_.size() - 1);
      }
    }
  }

  const DisplayMetric& metric_;
  PixelSource& source_;
  double allowed_;
  double left_ = 0, top_ = 0;
  std::array<dvec4, 4> corners_{};
  std::vector<Cell> cells_;
  CellMap owner_{};
  std::vector<std::size_t> order_;
  double error_ = 0;
};

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
  sample.color = source.sample({x - 0.5, y - 0.5});
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
// the pixel's own corners happen to be alike.
double CornerSamples::contrast_across(int x, int y) const {
  constexpr std::size_t kAround = 12;
  constexpr std::array<std::pair<int, int>, kAround> kRing{
      {{-1, -1}, {0, -1}, {1, -1}, {2, -1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {-1, 2}, {-1, 1}, {-1, 0}}};
  const Corners own = of_pixel(x, y);
  const dvec4 mean(0.25f * (own[0]->coded + own[1]->coded + own[2]->coded + own[3]->coded));
  std::array<double, kAround> differences;
  for (std::size_t i = 0; i < kAround; ++i) differences[i] = difference(x + kRing[i].first, y + kRing[i].second, mean);
  double most = 0;
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
  return error > allowed ? error : std::max(error, kShare * contrast_across(x, y));
}

void render_error_driven_block(const PixelArea& block, double bound, const CornerSamples& corners,
                               const DisplayMetric& metric, PixelSource& source, Film& film, ErrorMap& errors) {
  DividedPixel pixel(metric, source, bound);
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) {
      const CornerSamples::Corners at = corners.of_pixel(x, y);
      const double error = corners.error_of_pixel(x, y, bound * bound);
      if (error <= bound * bound) {
        film.at(x, y) = (at[0]->color + at[1]->color + at[2]->color + at[3]->color) * 0.25f;
        errors.at(x, y) = static_cast<float>(error);
      } else {
        film.at(x, y) = pixel.render(x, y, at);
        errors.at(x, y) = static_cast<float>(pixel.error());
      }
    }
  }
}

}  // namespace lute
