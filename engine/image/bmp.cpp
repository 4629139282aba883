// Colour-mapped Windows bitmaps. Layout: Microsoft's BITMAPFILEHEADER, BITMAPINFOHEADER and the older BITMAPCOREHEADER.
#include <algorithm>
#include <cstdlib>

#include "engine/image/byte_reader.hpp"
#include "engine/image/color_mapped.hpp"

namespace lute {
namespace {

constexpr std::uint32_t kCoreHeader = 12;
enum Compression : std::uint32_t { kPlain = 0, kRle8 = 1, kRle4 = 2 };

struct Header {
  std::uint32_t pixels = 0;  // where they begin
  int width = 0, height = 0;
  bool from_top = false;
  int bits = 0;
  std::uint32_t compression = kPlain;
};

Header read_header(ByteReader& file, ColorMapped& image) {
  Header header;
  file.seek(10);
  header.pixels = file.little_endian(4);
  const std::uint32_t size = file.little_endian(4);
  const bool core = size == kCoreHeader;
  const int field = core ? 2 : 4;
  header.width = static_cast<int>(file.little_endian(field));
  header.height = static_cast<int>(file.little_endian(field));
  file.little_endian(2);  // planes
  header.bits = static_cast<int>(file.little_endian(2));
  std::uint32_t colors = 0;
  if (!core) {
    header.compression = file.little_endian(4);
    file.seek(46);
    colors = file.little_endian(4);
  }
  header.from_top = header.height < 0;
  header.height = std::abs(header.height);
  if (header.bits > 8) return header;
  if (colors == 0 || colors > 256) colors = 1u << header.bits;
  file.seek(14 + size);
  for (std::uint32_t i = 0; i < colors; ++i) {
    const std::uint8_t blue = file.byte(), green = file.byte(), red = file.byte();
    if (!core) file.byte();
    image.palette.push_back(palette_entry(red, green, blue));
  }
  return header;
}

void read_plain(ByteReader& file, const Header& header, ColorMapped& image) {
  const int per_byte = 8 / header.bits;
  const int mask = (1 << header.bits) - 1;
  for (int row = 0; row < header.height; ++row) {
    const std::size_t begin = file.position();
    std::uint8_t* out = &image.indices[static_cast<std::size_t>(header.height - 1 - row) * static_cast<std::size_t>(header.width)];
    for (int column = 0; column < header.width; column += per_byte) {
      const int packed = file.byte();
      for (int i = 0; i < per_byte && column + i < header.width; ++i) {
        out[column + i] = static_cast<std::uint8_t>((packed >> (8 - header.bits * (i + 1))) & mask);
      }
    }
    file.seek(begin + (file.position() - begin + 3) / 4 * 4);
  }
}

// Runs (count, value), and after a 0: 0 end of row, 1 end of picture, 2 a jump, else so many pixels as they are.
void read_runs(ByteReader& file, const Header& header, ColorMapped& image) {
  int column = 0, row = 0;
  const auto put = [&](int index) {
    if (row >= header.height) throw std::runtime_error("a run leaves the picture");
    const auto line = static_cast<std::size_t>(header.height - 1 - row);
    // Some programs fill their rows up to a multiple of four pixels.
    if (column < header.width)
      image.indices[line * static_cast<std::size_t>(header.width) + static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(index);
    ++column;
  };
  const auto half = [&](int byte, int i) { return header.bits == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15; };
  for (;;) {
    const int count = file.byte(), value = file.byte();
    if (count > 0) {
      for (int i = 0; i < count; ++i) put(half(value, i));
    } else if (value == 0) {
      column = 0;
      ++row;
    } else if (value == 1) {
      return;
    } else if (value == 2) {
      column += file.byte();
      row += file.byte();
    } else {
      const std::size_t begin = file.position();
      int byte = 0;
      for (int i = 0; i < value; ++i) {
        if (header.bits == 8 || i % 2 == 0) byte = file.byte();
        put(half(byte, i));
      }
      file.seek(begin + (file.position() - begin + 1) / 2 * 2);
    }
  }
}

void turn_upside_down(ColorMapped& image) {
  const auto width = static_cast<std::ptrdiff_t>(image.width);
  for (int top = 0, bottom = image.height - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(image.indices.begin() + top * width, image.indices.begin() + (top + 1) * width,
                     image.indices.begin() + bottom * width);
  }
}

}  // namespace

std::optional<ColorMapped> read_color_mapped_bmp(const std::string& path, std::string& error) {
  try {
    ByteReader file(path);
    if (file.byte() != 'B' || file.byte() != 'M') return std::nullopt;
    ColorMapped image;
    const Header header = read_header(file, image);
    if (header.bits != 1 && header.bits != 4 && header.bits != 8) return std::nullopt;
    constexpr int kLargest = 1 << 16;
    if (header.width < 1 || header.height < 1 || header.width > kLargest || header.height > kLargest) {
      throw std::runtime_error("its size is not possible");
    }
    image.width = header.width;
    image.height = header.height;
    image.indices.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
    file.seek(header.pixels);
    if (header.compression == kPlain) {
      read_plain(file, header, image);
    } else if (header.compression == kRle8 || header.compression == kRle4) {
      read_runs(file, header, image);
    } else {
      throw std::runtime_error("its compression is unknown");
    }
    if (header.from_top) turn_upside_down(image);
    if (!check_indices(image, path, error)) return std::nullopt;
    return image;
  } catch (const std::runtime_error& failure) {
    error = "Cannot read BMP image '" + path + "': " + failure.what() + ".";
    return std::nullopt;
  }
}

}  // namespace lute
