#include "engine/output/dither.hpp"

namespace lute {
namespace {

// Thresholds by column, then row.
constexpr std::array<std::array<float, 2>, 2> kBayer2{{{1, 3}, {4, 2}}};
constexpr std::array<std::array<float, 3>, 3> kBayer3{{{3, 7, 4}, {6, 1, 9}, {2, 8, 5}}};
constexpr std::array<std::array<float, 4>, 4> kBayer4{{{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}}};

template <std::size_t n>
float entry(const std::array<std::array<float, n>, n>& matrix, int column, int row) {
  const float value = matrix[static_cast<std::size_t>(column) % n][static_cast<std::size_t>(row) % n];
  return value / static_cast<float>(n * n) - 0.5f;
}

}  // namespace

Dither::Dither(DitherMethod method, int width) : method_(method) {
  if (!diffuses()) return;
  current_.resize(static_cast<std::size_t>(width) + 2);
  below_.resize(static_cast<std::size_t>(width) + 2);
}

void Dither::begin_row() {
  if (!diffuses()) return;
  current_.swap(below_);
  if (method_ == DitherMethod::kDiffusion1) {
    current_[index(0)] = below_.back();  // from the end of the row before
  } else {
    std::swap(current_[index(0)], first_column_);
  }
  below_.assign(below_.size(), PixelError{});
}

float Dither::step_offset(int column, int row) const {
  switch (method_) {
    case DitherMethod::kBayer2:
      return entry(kBayer2, column, row);
    case DitherMethod::kBayer3:
      return entry(kBayer3, column, row);
    case DitherMethod::kBayer4:
      return entry(kBayer4, column, row);
    default:
      return 0;
  }
}

void Dither::add(PixelError& target, const PixelError& error, float share) {
  for (std::size_t i = 0; i < target.size(); ++i) target[i] += share * error[i];
}

void Dither::spread(int column, const PixelError& error) {
  const std::size_t i = index(column);
  switch (method_) {
    case DitherMethod::kDiffusion1:
      add(current_[i + 1], error, 1);
      return;
    case DitherMethod::kDiffusion2:
      add(current_[i + 1], error, 1.0f / 2);
      add(below_[i], error, 1.0f / 4);
      add(below_[i + 1], error, 1.0f / 4);
      return;
    case DitherMethod::kFloydSteinberg:
      add(current_[i + 1], error, 7.0f / 16);
      add(below_[i - 1], error, 3.0f / 16);
      add(below_[i], error, 5.0f / 16);
      add(below_[i + 1], error, 1.0f / 16);
      return;
    default:
      return;
  }
}

}  // namespace lute
