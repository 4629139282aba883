#include "engine/render/divided_pixel.hpp"

#include <algorithm>

#include "engine/render/error_map.hpp"

namespace lute {
namespace {

constexpr double kGainOfDivision = 7.0 / 8;  // an edge crosses two of four parts, each with a quarter of the area
constexpr std::size_t kFewestForAPattern = 10;  // cells: fewer can differ all round beside one edge
constexpr double kLongestEdge = 2.6;  // in sides of the pixel: the steps that cells make of one straight edge, with their roughness

// Of the pixel divided evenly.
template <class CellMap>
constexpr CellMap cells_of_level(int level, int side) {
  CellMap map{};
  const int size = side >> level;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      map[static_cast<std::size_t>(y * side + x)] = static_cast<std::uint16_t>((y / size << level) + x / size);
    }
  }
  return map;
}

}  // namespace

Color DividedPixel::render(int x, int y, const CornerSamples::Corners& corners, int first_level) {
  left_ = x - 0.5;
  top_ = y - 0.5;
  for (std::size_t i = 0; i < 4; ++i) corners_[i] = channels(corners[i]->color);
  const SobolCells points((static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
                          static_cast<std::uint32_t>(y));
  cells_.clear();
  static constexpr auto kFirstLevel = cells_of_level<CellMap>(1, kSide), kSecondLevel = cells_of_level<CellMap>(2, kSide);
  owner_ = first_level == 1 ? kFirstLevel : kSecondLevel;
  const int across = 1 << first_level;
  for (int i = 0; i < across * across; ++i) cells_.push_back(sampled(points, first_level, i % across, i / across));
  estimate();
  if (error_ <= allowed_ && first_level == 1) return mean_with(corners);
  while (error_ > allowed_ && divide_worst(points)) estimate();
  return mean();
}

DividedPixel::Cell DividedPixel::sampled(const SobolCells& points, int level, int column, int row) {
  const dvec2 at = points.point(level, column, row);
  return {level, column, row, at, source_.sample({left_ + at.x, top_ + at.y})};
}

void DividedPixel::paint(std::size_t number) {
  const Cell& cell = cells_[number];
  const int size = cell.size();
  for (int y = cell.row * size; y < (cell.row + 1) * size; ++y) {
    std::fill_n(&owner_[static_cast<std::size_t>(y * kSide + cell.column * size)], size,
                static_cast<std::uint16_t>(number));
  }
}

Color DividedPixel::mean() const {
  Color sum;
  for (const Cell& cell : cells_) sum += cell.color * static_cast<float>(cell.area());
  return sum;
}

// An edge that crosses the pixel anywhere makes the mean of four cells off by h² / 48, that of the corners by h² / 12:
// together they are best with weights of 4 and 1.
Color DividedPixel::mean_with(const CornerSamples::Corners& corners) {
  Color sum = mean() * 0.8f;
  for (const CornerSamples::Sample* corner : corners) sum += corner->color * 0.05f;
  error_ *= 0.8;
  return sum;
}

void DividedPixel::estimate() {
  const dvec4 sensitivity = metric_.sensitivity(mean());
  Sides sides;
  error_ = 0;
  for (Cell& cell : cells_) {
    cell.error = std::min(1.0, kSideWeight * cell.area() * cell.area() * contrast(cell, sensitivity, sides));
    error_ += cell.error;
  }
  pattern_ = 0;
  const double variance = unresolved(sides, sensitivity);
  if (variance > 0) {
    error_ = 0;
    for (Cell& cell : cells_) {
      cell.error = std::max(cell.error, cell.area() * cell.area() * variance);
      error_ += cell.error;
    }
  }
  error_ = std::min(error_, 1.0);
}

// Notes the variance of a pattern, and returns the part of it that is finer than the cells: all where neighbours differ as much as
// any two samples, nothing where they differ half as much.
double DividedPixel::unresolved(const Sides& sides, const dvec4& sensitivity) {
  if (cells_.size() < kFewestForAPattern || !(sides.squares > 0)) return 0;
  const dvec4 middle = channels(mean());
  double variance = 0;
  for (const Cell& cell : cells_) {
    const dvec4 off = channels(cell.color) - middle;
    variance += cell.area() * glm::dot(sensitivity, off * off);
  }
  variance = std::min(variance, 0.25);
  // Two colours in equal parts have a variance of a quarter of their squared difference.
  const double length = 0.5 / kSide * sides.squares / std::max(4 * variance, 0.5 * sides.greatest);
  if (length < kLongestEdge) return 0;
  pattern_ = variance;
  const double likeness = sides.squares / (2 * variance * sides.length);
  return variance * std::clamp(2 * likeness - 1, 0.0, 1.0);
}

// Squared differences from what is beside the cell, over its four sides. An edge between two samples lies in the cell
// with the chance of its share of the way between them; an edge before the border always does. Beside a cell at the border stands
// what is between two corners.
double DividedPixel::contrast(const Cell& cell, const dvec4& sensitivity, Sides& sides) const {
  const dvec4 own = channels(cell.color);
  const int size = cell.size(), x = cell.column * size, y = cell.row * size;
  const auto square = [&](const dvec4& other) { return glm::dot(sensitivity, (other - own) * (other - own)); };
  const auto border = [&](std::size_t from, std::size_t to, double along) {
    return square(corners_[from] + along * (corners_[to] - corners_[from]));
  };
  const auto inside = [&](int first_x, int first_y, int step_x, int step_y) {
    double sum = 0;
    for (int i = 0; i < size;) {
      const Cell& other = cell_at(first_x + i * step_x, first_y + i * step_y);
      const int touched = std::min(size, other.size());
      const double difference = square(channels(other.color));
      sum += difference * touched / (size + other.size());
      sides.length += touched;
      sides.squares += touched * difference;
      sides.greatest = std::max(sides.greatest, difference);
      i += touched;
    }
    return sum;
  };
  const double along_x = (x + 0.5 * size) / kSide, along_y = (y + 0.5 * size) / kSide;
  double sum = x == 0 ? border(0, 2, along_y) : inside(x - 1, y, 0, 1);
  sum += x + size == kSide ? border(1, 3, along_y) : inside(x + size, y, 0, 1);
  sum += y == 0 ? border(0, 1, along_x) : inside(x, y - 1, 1, 0);
  sum += y + size == kSide ? border(2, 3, along_x) : inside(x, y + size, 1, 0);
  return sum;
}

// Divides as few cells as should bring the error below the bound; false when none can be divided.
bool DividedPixel::divide_worst(const SobolCells& points) {
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
void DividedPixel::divide(const SobolCells& points, std::size_t number) {
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

}  // namespace lute
