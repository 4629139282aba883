// Colour-mapped Targa files. Layout: Truevision TGA file format specification 2.0.
#include <algorithm>

#include "engine/image/byte_reader.hpp"
#include "engine/image/color_mapped.hpp"

namespace lute {
namespace {

constexpr int kColorMapped = 1, kColorMappedRuns = 9;
constexpr int kFromTop = 0x20, kFromRight = 0x10;

struct Header {
  int id_length = 0, map_type = 0, type = 0;
  int first_color = 0, colors = 0, color_bits = 0;
  int width = 0, height = 0, bits = 0, order = 0;
};

Header read_header(ByteReader& file) {
  Header h;
  h.id_length = file.byte();
  h.map_type = file.byte();
  h.type = file.byte();
  h.first_color = static_cast<int>(file.little_endian(2));
  h.colors = static_cast<int>(file.little_endian(2));
  h.color_bits = file.byte();
  file.little_endian(4);  // origin on a screen
  h.width = static_cast<int>(file.little_endian(2));
  h.height = static_cast<int>(file.little_endian(2));
  h.bits = file.byte();
  h.order = file.byte();
  return h;
}

Image::Pixel read_color(ByteReader& file, int bits) {
  if (bits == 15 || bits == 16) {
    const std::uint32_t packed = file.little_endian(2);
    return palette_entry(packed >> 10 & 31, packed >> 5 & 31, packed & 31, 31);
  }
  if (bits != 24 && bits != 32) throw std::runtime_error("the colours of its map have an unknown size");
  const std::uint8_t blue = file.byte(), green = file.byte(), red = file.byte();
  if (bits == 32) file.byte();
  return palette_entry(red, green, blue);
}

std::vector<std::uint8_t> read_indices(ByteReader& file, std::size_t count, bool runs) {
  std::vector<std::uint8_t> indices;
  indices.reserve(count);
  while (indices.size() < count) {
    if (!runs) {
      indices.push_back(file.byte());
      continue;
    }
    const int packet = file.byte();
    const auto length = std::min(static_cast<std::size_t>(packet & 127) + 1, count - indices.size());
    if ((packet & 128) != 0) {
      indices.insert(indices.end(), length, file.byte());
    } else {
      for (std::size_t i = 0; i < length; ++i) indices.push_back(file.byte());
    }
  }
  return indices;
}

}  // namespace

std::optional<ColorMapped> read_color_mapped_tga(const std::string& path, std::string& error) {
  try {
    ByteReader file(path);
    const Header h = read_header(file);
    if ((h.type != kColorMapped && h.type != kColorMappedRuns) || h.map_type != 1 || h.bits != 8) return std::nullopt;
    if (h.width < 1 || h.height < 1 || h.first_color + h.colors > 256) throw std::runtime_error("its size is not possible");
    file.seek(file.position() + static_cast<std::size_t>(h.id_length));
    ColorMapped image;
    image.width = h.width;
    image.height = h.height;
    image.palette.resize(static_cast<std::size_t>(h.first_color));
    for (int i = 0; i < h.colors; ++i) image.palette.push_back(read_color(file, h.color_bits));
    const auto width = static_cast<std::size_t>(h.width), height = static_cast<std::size_t>(h.height);
    const std::vector<std::uint8_t> stored = read_indices(file, width * height, h.type == kColorMappedRuns);
    image.indices.resize(width * height);
    for (std::size_t row = 0; row < height; ++row) {
      const std::size_t from = (h.order & kFromTop) != 0 ? row : height - 1 - row;
      for (std::size_t column = 0; column < width; ++column) {
        const std::size_t source = (h.order & kFromRight) != 0 ? width - 1 - column : column;
        image.indices[row * width + column] = stored[from * width + source];
      }
    }
    if (!check_indices(image, path, error)) return std::nullopt;
    return image;
  } catch (const std::runtime_error& failure) {
    error = "Cannot read Targa image '" + path + "': " + failure.what() + ".";
    return std::nullopt;
  }
}

}  // namespace lute
