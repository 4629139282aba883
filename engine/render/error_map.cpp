#include "engine/render/error_map.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double centre_error(const std::array<dvec4, 9>& coded, const DisplayMetric& metric) {
  const auto second_difference = [&](std::size_t a, std::size_t b) {
    return metric.mean_square(coded[a] - 2.0 * coded[4] + coded[b]);
  };
  // An edge between two columns gives 4 h² in the sum over both, and one of them has the error h² / 12.
  constexpr double kWeight = 1.0 / 48;
  return kWeight * (second_difference(3, 5) + second_difference(1, 7) +
                    0.5 * (second_difference(0, 8) + second_difference(2, 6)));
}

ErrorMap::ErrorMap(const PixelArea& area) : area_(area), values_(static_cast<std::size_t>(area.pixels()), -1.0f) {}

std::size_t ErrorMap::index(int x, int y) const {
  return static_cast<std::size_t>(y - area_.first_row) * static_cast<std::size_t>(area_.columns()) +
         static_cast<std::size_t>(x - area_.first_column);
}

void ErrorMap::estimate_centres(const Film& film, const DisplayMetric& metric) {
  for (int y = area_.first_row; y <= area_.last_row; ++y) {
    for (int x = area_.first_column; x <= area_.last_column; ++x) {
      if (at(x, y) >= 0) continue;
      std::array<dvec4, 9> coded;
      for (int i = 0; i < 9; ++i) {
        const int column = std::clamp(x + i % 3 - 1, area_.first_column, area_.last_column);
        const int row = std::clamp(y + i / 3 - 1, area_.first_row, area_.last_row);
        coded[static_cast<std::size_t>(i)] = metric.coded(film.at(column, row));
      }
      at(x, y) = static_cast<float>(centre_error(coded, metric));
    }
  }
}

double ErrorMap::rmse() const {
  double sum = 0;
  for (const float value : values_) sum += std::max(value, 0.0f);
  return values_.empty() ? 0 : std::sqrt(sum / static_cast<double>(values_.size()));
}

}  // namespace lute
