#include "engine/image/color_mapped.hpp"

#include <algorithm>

namespace lute {

Image::Pixel palette_entry(std::uint32_t red, std::uint32_t green, std::uint32_t blue, std::uint32_t maximum) {
  const auto unit = [&](std::uint32_t v) { return static_cast<float>(v) / static_cast<float>(maximum); };
  return {{unit(red), unit(green), unit(blue)}};
}

bool check_indices(const ColorMapped& image, const std::string& path, std::string& error) {
  const auto found = std::ranges::max_element(image.indices);
  if (found == image.indices.end() || *found < image.palette.size()) return true;
  error = "Cannot read image '" + path + "': a pixel's index lies outside the palette.";
  return false;
}

}  // namespace lute
