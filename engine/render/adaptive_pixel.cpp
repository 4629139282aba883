#include "engine/render/adaptive_pixel.hpp"

#include <array>
#include <vector>

#include "engine/camera/jitter.hpp"

namespace lute {
namespace {

struct Sample {
  Color color, encoded;
  bool known = false;
};

// One pixel as a grid of nodes, 2^(depth-1) steps a side; a node is traced at most once.
class AdaptivePixel {
 public:
  AdaptivePixel(const Antialiasing& settings, const ColorMetric& metric, PixelSource& source, bool estimates)
      : metric_(metric),
        source_(source),
        estimates_(estimates),
        steps_(1 << (settings.depth - 1)),
        amount_(static_cast<double>(settings.jitter) / ((1 << settings.depth) + 1)),
        nodes_(static_cast<std::size_t>(steps_ + 1) * static_cast<std::size_t>(steps_ + 1)) {}

  // `corners`: top left, bottom left, top right, bottom right.
  Color render(int x, int y, const std::array<const Sample*, 4>& corners) {
    for (Sample& node : nodes_) node.known = false;
    left_ = x - 0.5;
    top_ = y - 0.5;
    node(0, 0) = *corners[0];
    node(0, steps_) = *corners[1];
    node(steps_, 0) = *corners[2];
    node(steps_, steps_) = *corners[3];
    variance_ = dvec4(0);
    return square(0, 0, steps_);
  }

  // Of the pixel rendered last, in the working space.
  const dvec4& variance() const { return variance_; }

 private:
  Sample& node(int i, int j) {
    return nodes_[static_cast<std::size_t>(j) * static_cast<std::size_t>(steps_ + 1) + static_cast<std::size_t>(i)];
  }

  void need(int i, int j) {
    Sample& sample = node(i, j);
    if (sample.known) return;
    dvec2 position(left_ + static_cast<double>(i) / steps_, top_ + static_cast<double>(j) / steps_);
    if (amount_ != 0) position += amount_ * jitter(position);
    sample.color = source_.sample(position);
    sample.encoded = metric_.encode(sample.color);
    sample.known = true;
  }

  bool corners_differ(const std::array<const Sample*, 4>& corners) const {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = i + 1; k < 4; ++k) {
        if (metric_.differ(corners[i]->encoded, corners[k]->encoded)) return true;
      }
    }
    return false;
  }

  void add_variance(const std::array<const Sample*, 4>& corners, int size) {
    const double area = static_cast<double>(size * size) / (steps_ * steps_);
    const auto side = [&](std::size_t a, std::size_t b) {
      const dvec4 difference = channels(corners[a]->color) - channels(corners[b]->color);
      return difference * difference;
    };
    variance_ += kCornerWeight * area * area * (side(0, 1) + side(1, 3) + side(3, 2) + side(2, 0));
  }

  // The square from node (i, j), `size` steps a side.
  Color square(int i, int j, int size) {
    const std::array<const Sample*, 4> corners{&node(i, j), &node(i, j + size), &node(i + size, j),
                                               &node(i + size, j + size)};
    if (size == 1 || !corners_differ(corners)) {
      if (estimates_) add_variance(corners, size);
      return (corners[0]->color + corners[1]->color + corners[2]->color + corners[3]->color) * 0.25f;
    }
    const int half = size / 2;
    need(i, j + half);
    need(i + half, j);
    need(i + size, j + half);
    need(i + half, j + size);
    need(i + half, j + half);
    return (square(i, j, half) + square(i, j + half, half) + square(i + half, j, half) +
            square(i + half, j + half, half)) *
           0.25f;
  }

  const ColorMetric& metric_;
  PixelSource& source_;
  bool estimates_;
  int steps_;
  double amount_;
  std::vector<Sample> nodes_;
  double left_ = 0, top_ = 0;
  dvec4 variance_{0};
};

}  // namespace

void render_adaptive_block(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric,
                           PixelSource& source, Film& film, const ErrorRecord* errors) {
  const std::size_t stride = static_cast<std::size_t>(block.columns()) + 1;
  std::vector<Sample> corners(stride * (static_cast<std::size_t>(block.rows()) + 1));
  const auto corner = [&](int x, int y) -> Sample& {
    return corners[static_cast<std::size_t>(y - block.first_row) * stride +
                   static_cast<std::size_t>(x - block.first_column)];
  };
  for (int y = block.first_row; y <= block.last_row + 1; ++y) {
    for (int x = block.first_column; x <= block.last_column + 1; ++x) {
      Sample& sample = corner(x, y);
      sample.color = source.sample({x - 0.5, y - 0.5});
      sample.encoded = metric.encode(sample.color);
      sample.known = true;
    }
  }
  AdaptivePixel pixel(settings, metric, source, errors != nullptr);
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) {
      film.at(x, y) = pixel.render(x, y, {&corner(x, y), &corner(x, y + 1), &corner(x + 1, y), &corner(x + 1, y + 1)});
      if (errors == nullptr) continue;
      errors->map.at(x, y) =
          static_cast<float>(glm::dot(errors->metric.sensitivity(film.at(x, y)), pixel.variance()));
    }
  }
}

}  // namespace lute
