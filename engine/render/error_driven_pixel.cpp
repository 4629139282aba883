#include "engine/render/error_driven_pixel.hpp"

#include <algorithm>
#include <cmath>

#include "engine/render/sobol_cell.hpp"

namespace lute {
namespace {

constexpr int kDeepest = 5;                  // 32 × 32 cells
constexpr int kSide = 1 << kDeepest;         // of the smallest cells in a pixel
constexpr double kGainOfDivision = 7.0 / 8;  // an edge crosses two of four parts, each with a quarter of the area

struct Cell {
  int level, column, row;
  Color color;
  double error = 0;  // its share of the pixel's mean square error

  int size() const { return kSide >> level; }  // in smallest cells
  double area() const { return 1.0 / static_cast<double>(1 << (2 * level)); }
};

// One pixel under division. Kept for the pixels of a block, so that its memory is.
class DividedPixel {
 public:
  DividedPixel(const DisplayMetric& metric, PixelSource& source, double bound)
      : metric_(metric), source_(source), allowed_(bound * bound) {}

  Color render(int x, int y, const std::array<dvec4, 9>& around) {
    left_ = x - 0.5;
    top_ = y - 0.5;
    around_ = around;
    const SobolCells points((static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
                            static_cast<std::uint32_t>(y));
    cells_.clear();
    for (int i = 0; i < 4; ++i) cells_.push_back(sampled(points, 1, i & 1, i >> 1));
    for (std::size_t i = 0; i < 4; ++i) paint(i);
    estimate();
    while (error_ > allowed_ && divide_worst(points)) estimate();
    return mean();
  }

  double error() const { return error_; }

 private:
  Cell sampled(const SobolCells& points, int level, int column, int row) {
    const dvec2 at = points.point(level, column, row);
    return {level, column, row, source_.sample({left_ + at.x, top_ + at.y})};
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

  // The square of a difference, times the chance that an edge between the samples lies in the cell: its share of the
  // way, `size` of size + `other`.
  static double pair(const dvec4& difference, const dvec4& sensitivity, int size, int other) {
    return glm::dot(sensitivity, difference * difference) * size / (size + other);
  }

  // The sum over the four sides, and the corners where the cell lies in one of the pixel's.
  double contrast(const Cell& cell, const dvec4& sensitivity) const {
    const dvec4 own = channels(cell.color);
    const int size = cell.size(), x = cell.column * size, y = cell.row * size;
    const auto outside = [&](std::size_t neighbour) {
      return pair(around_[neighbour] - own, sensitivity, size, kSide);
    };
    const auto inside = [&](int first_x, int first_y, int step_x, int step_y) {
      double sum = 0;
      for (int i = 0; i < size;) {
        const Cell& other =
            cells_[owner_[static_cast<std::size_t>((first_y + i * step_y) * kSide + first_x + i * step_x)]];
        const int touched = std::min(size, other.size());
        sum += pair(channels(other.color) - own, sensitivity, size, other.size()) * touched / size;
        i += touched;
      }
      return sum;
    };
    const bool left = x == 0, right = x + size == kSide, top = y == 0, bottom = y + size == kSide;
    double sum = left ? outside(3) : inside(x - 1, y, 0, 1);
    sum += right ? outside(5) : inside(x + size, y, 0, 1);
    sum += top ? outside(1) : inside(x, y - 1, 1, 0);
    sum += bottom ? outside(7) : inside(x, y + size, 1, 0);
    if (left && top) sum += outside(0);
    if (right && top) sum += outside(2);
    if (left && bottom) sum += outside(6);
    if (right && bottom) sum += outside(8);
    return sum;
  }

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
    const dvec2 at = points.point(whole.level, whole.column, whole.row);
    const int level = whole.level + 1;
    const int own_column = static_cast<int>(at.x * (1 << level)), own_row = static_cast<int>(at.y * (1 << level));
    for (int i = 0; i < 4; ++i) {
      const int column = 2 * whole.column + (i & 1), row = 2 * whole.row + (i >> 1);
      if (column == own_column && row == own_row) {
        cells_[number] = {level, column, row, whole.color};
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
  std::array<dvec4, 9> around_{};
  std::vector<Cell> cells_;
  std::array<std::uint16_t, kSide * kSide> owner_{};  // the cell that covers each smallest one
  std::vector<std::size_t> order_;
  double error_ = 0;
};

}  // namespace

CentreSamples::CentreSamples(const PixelArea& area, const DisplayMetric& metric)
    : ring_{area.first_column - 1, area.first_row - 1, area.last_column + 1, area.last_row + 1}, metric_(metric) {
  samples_.resize(static_cast<std::size_t>(ring_.pixels()));
}

std::size_t CentreSamples::index(int x, int y) const {
  return static_cast<std::size_t>(y - ring_.first_row) * static_cast<std::size_t>(ring_.columns()) +
         static_cast<std::size_t>(x - ring_.first_column);
}

void CentreSamples::take(const PixelArea& block, PixelSource& source) {
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) {
      Sample& sample = samples_[index(x, y)];
      sample.color = source.sample({x, y});
      sample.coded = glm::vec4(metric_.coded(sample.color));
    }
  }
}

std::array<dvec4, 9> CentreSamples::coded_around(int x, int y) const {
  std::array<dvec4, 9> result;
  for (int i = 0; i < 9; ++i) {
    result[static_cast<std::size_t>(i)] = dvec4(samples_[index(x + i % 3 - 1, y + i / 3 - 1)].coded);
  }
  return result;
}

std::array<dvec4, 9> CentreSamples::channels_around(int x, int y) const {
  std::array<dvec4, 9> result;
  for (int i = 0; i < 9; ++i) result[static_cast<std::size_t>(i)] = channels(color(x + i % 3 - 1, y + i / 3 - 1));
  return result;
}

void render_error_driven_block(const PixelArea& block, double bound, const CentreSamples& centres,
                               const DisplayMetric& metric, PixelSource& source, Film& film, ErrorMap& errors) {
  DividedPixel pixel(metric, source, bound);
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) {
      const double error = centre_error(centres.coded_around(x, y), metric);
      if (error <= bound * bound) {
        film.at(x, y) = centres.color(x, y);
        errors.at(x, y) = static_cast<float>(error);
      } else {
        film.at(x, y) = pixel.render(x, y, centres.channels_around(x, y));
        errors.at(x, y) = static_cast<float>(pixel.error());
      }
    }
  }
}

}  // namespace lute
