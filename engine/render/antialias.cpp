#include "engine/render/antialias.hpp"

#include <cmath>
#include <vector>

#include "engine/camera/jitter.hpp"
#include "engine/render/adaptive_pixel.hpp"

namespace lute {
namespace {

// A pixel of a block on its way: its colour, the colour as compared, and whether it has all its samples.
struct Cell {
  Color color, encoded;
  bool supersampled = false;
};

// A block with the row above and the column to the left of it, which are compared with but never changed from here.
class NeighbourBlock {
 public:
  NeighbourBlock(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric, PixelSource& source,
                 const ErrorRecord* errors)
      : block_(block),
        settings_(settings),
        metric_(metric),
        source_(source),
        errors_(errors),
        stride_(static_cast<std::size_t>(block.columns()) + 1) {
    cells_.resize(stride_ * (static_cast<std::size_t>(block.rows()) + 1));
  }

  void render() {
    for (int x = block_.first_column; x <= block_.last_column; ++x) trace(x, block_.first_row - 1, true);
    for (int y = block_.first_row; y <= block_.last_row; ++y) {
      trace(block_.first_column - 1, y, true);
      for (int x = block_.first_column; x <= block_.last_column; ++x) {
        trace(x, y, false);
        compare(x, y);
      }
    }
  }

  const Color& color(int x, int y) { return cell(x, y).color; }

 private:
  Cell& cell(int x, int y) {
    return cells_[static_cast<std::size_t>(y - block_.first_row + 1) * stride_ +
                  static_cast<std::size_t>(x - block_.first_column + 1)];
  }

  void trace(int x, int y, bool supersampled) {
    Cell& c = cell(x, y);
    c.color = source_.sample({x, y});
    c.encoded = metric_.encode(c.color);
    c.supersampled = supersampled;
  }

  // All comparisons come before any pixel is replaced.
  void compare(int x, int y) {
    const bool left = metric_.differ(cell(x - 1, y).encoded, cell(x, y).encoded);
    const bool top = metric_.differ(cell(x, y - 1).encoded, cell(x, y).encoded);
    if (left) supersample(x - 1, y);
    if (top) supersample(x, y - 1);
    if (left || top) supersample(x, y);
  }

  void supersample(int x, int y) {
    Cell& c = cell(x, y);
    if (c.supersampled) return;
    const int n = settings_.depth;
    const double step = 1.0 / n, range = 0.5 - step / 2;
    const double amount = static_cast<double>(settings_.jitter) / n;
    grid_.clear();
    for (double dy = -range; dy <= range + kEpsilon; dy += step) {
      for (double dx = -range; dx <= range + kEpsilon; dx += step) {
        dvec2 position(x + dx, y + dy);
        if (amount != 0) position += amount * jitter(position);
        const Color sample = source_.sample(position);
        c.color += sample;
        if (errors_ != nullptr) grid_.push_back(channels(sample));
      }
    }
    c.color = c.color * (1.0f / static_cast<float>(n * n + 1));
    c.encoded = metric_.encode(c.color);
    c.supersampled = true;
    if (errors_ != nullptr && n > 1) record_error(x, y, c.color);
  }

  void record_error(int x, int y, const Color& color) {
    const auto n = static_cast<std::size_t>(settings_.depth);
    dvec4 squares(0);
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      const dvec4 right = i % n + 1 < n ? grid_[i + 1] - grid_[i] : dvec4(0);
      const dvec4 below = i + n < grid_.size() ? grid_[i + n] - grid_[i] : dvec4(0);
      squares += right * right + below * below;
    }
    // Edges outside of the outermost samples separate none: one of n.
    squares *= static_cast<double>(n) / static_cast<double>(n - 1);
    const double share = 1.0 / static_cast<double>(n * n + 1);  // of one sample in the mean
    errors_->map.at(x, y) =
        static_cast<float>(kSideWeight * share * share * glm::dot(errors_->metric.sensitivity(color), squares));
  }

  const PixelArea block_;
  const Antialiasing& settings_;
  const ColorMetric& metric_;
  PixelSource& source_;
  const ErrorRecord* errors_;
  std::vector<dvec4> grid_;  // the samples of one pixel, row by row, for the estimate of its error
  std::size_t stride_;
  std::vector<Cell> cells_;
};

float srgb_to_linear(float v) { return v < 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

}  // namespace

ColorMetric::ColorMetric(const Antialiasing& settings, GammaMode mode, double assumed_gamma)
    : threshold_(settings.threshold), decode_srgb_(mode == GammaMode::kSrgb), exponent_(1) {
  const auto near_one = [](double gamma) { return std::abs(1 - 1 / gamma) <= 0.01; };
  const bool encodes = settings.gamma > 0 && !near_one(settings.gamma);
  const double working = mode == GammaMode::kPower && !near_one(assumed_gamma) ? assumed_gamma : 1;
  exponent_ = static_cast<float>(working / (encodes ? settings.gamma : 1));
}

Color ColorMetric::encode(const Color& color) const {
  const auto channel = [this](float v) {
    if (decode_srgb_) v = srgb_to_linear(v);
    if (exponent_ == 1.0f) return v;
    return v > 0 ? std::pow(v, exponent_) : 0.0f;
  };
  return {{channel(color.rgb.r), channel(color.rgb.g), channel(color.rgb.b)}, color.filter, color.transmit};
}

bool ColorMetric::differ(const Color& a, const Color& b) const {
  return std::abs(a.rgb.r - b.rgb.r) + std::abs(a.rgb.g - b.rgb.g) + std::abs(a.rgb.b - b.rgb.b) +
             std::abs(a.transmit - b.transmit) >=
         threshold_;
}

void render_block(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric, PixelSource& source,
                  Film& film, const ErrorRecord* errors) {
  if (settings.method == 1) {
    NeighbourBlock neighbours(block, settings, metric, source, errors);
    neighbours.render();
    for (int y = block.first_row; y <= block.last_row; ++y) {
      for (int x = block.first_column; x <= block.last_column; ++x) film.at(x, y) = neighbours.color(x, y);
    }
    return;
  }
  if (settings.method == 2) {
    render_adaptive_block(block, settings, metric, source, film, errors);
    return;
  }
  for (int y = block.first_row; y <= block.last_row; ++y) {
    for (int x = block.first_column; x <= block.last_column; ++x) film.at(x, y) = source.sample({x, y});
  }
}

}  // namespace lute
