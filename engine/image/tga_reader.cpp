// Layout: Truevision TGA file format specification 2.0.
#include "engine/image/tga_reader.hpp"

#include <algorithm>
#include <array>

#include "engine/image/byte_reader.hpp"

namespace lute {
namespace {

enum Kind { kColorMapped = 1, kTrueColor = 2, kGrey = 3 };
constexpr int kRuns = 8;  // added to the kind
constexpr int kFromTop = 0x20;

struct Header {
  int id_length = 0, map_type = 0, type = 0;
  int first_color = 0, colors = 0, color_bits = 0;
  int width = 0, height = 0, bits = 0, order = 0;

  int kind() const { return type & ~kRuns; }
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

// A pixel or an entry of a palette in the order of the channels of an image.
struct Color {
  std::array<std::uint8_t, 4> bytes{};
  int channels = 3;
};

std::uint8_t five_bits(std::uint32_t packed, int shift) { return static_cast<std::uint8_t>((packed >> shift & 31) << 3); }

Color read_color(ByteReader& file, int bits) {
  if (bits == 15 || bits == 16) {
    const std::uint32_t packed = file.little_endian(2);
    const auto alpha = static_cast<std::uint8_t>((packed & 0x8000) != 0 ? 255 : 0);
    return {{five_bits(packed, 10), five_bits(packed, 5), five_bits(packed, 0), alpha}, bits == 16 ? 4 : 3};
  }
  if (bits != 24 && bits != 32) throw std::runtime_error("its colours have an unknown size");
  const std::uint8_t blue = file.byte(), green = file.byte(), red = file.byte();
  if (bits == 24) return {{red, green, blue, 255}, 3};
  return {{red, green, blue, file.byte()}, 4};
}

Color read_pixel(ByteReader& file, const Header& h) {
  if (h.kind() == kTrueColor) return read_color(file, h.bits);
  const std::uint8_t value = file.byte();
  if (h.bits == 8) return {{value}, 1};
  if (h.bits != 16) throw std::runtime_error("its pixels have an unknown size");
  return {{value, file.byte()}, 2};
}

void read_palette(ByteReader& file, const Header& h, TgaContent& content) {
  content.palette.resize(static_cast<std::size_t>(h.first_color));
  for (int i = 0; i < h.colors; ++i) {
    const Color color = read_color(file, h.color_bits);
    const auto unit = [&](std::size_t c) { return static_cast<float>(color.bytes[c]) / 255.0f; };
    content.palette.push_back({{unit(0), unit(1), unit(2)}, color.channels == 4 ? unit(3) : 1.0f});
  }
}

// The pixels in the order of the file.
std::vector<std::uint8_t> read_pixels(ByteReader& file, const Header& h, TgaContent& content) {
  const std::size_t count = static_cast<std::size_t>(h.width) * static_cast<std::size_t>(h.height);
  std::vector<std::uint8_t> stored;
  const auto put = [&](const Color& color) {
    content.channels = color.channels;
    stored.insert(stored.end(), color.bytes.begin(), color.bytes.begin() + color.channels);
  };
  for (std::size_t read = 0; read < count;) {
    const int packet = (h.type & kRuns) != 0 ? file.byte() : 0;
    const auto length = std::min(static_cast<std::size_t>(packet & 127) + 1, count - read);
    Color color;
    for (std::size_t i = 0; i < length; ++i) {
      if (i == 0 || (packet & 128) == 0) color = read_pixel(file, h);
      put(color);
    }
    read += length;
  }
  return stored;
}

void check_indices(const TgaContent& content) {
  const auto largest = std::ranges::max_element(content.bytes);
  if (*largest >= content.palette.size()) throw std::runtime_error("a pixel's index lies outside the palette");
}

bool read_content(ByteReader& file, TgaContent& content) {
  const Header h = read_header(file);
  if (h.kind() < kColorMapped || h.kind() > kGrey) throw std::runtime_error("it is not in TGA format");
  if (h.width < 1 || h.height < 1) throw std::runtime_error("its size is not possible");
  const bool mapped = h.kind() == kColorMapped;
  if (mapped && (h.map_type != 1 || h.bits != 8 || h.first_color + h.colors > 256)) return false;
  file.seek(file.position() + static_cast<std::size_t>(h.id_length));
  if (h.map_type == 1) read_palette(file, h, content);
  if (!mapped) content.palette.clear();  // true colour may bring a palette for poorer screens
  content.width = h.width;
  content.height = h.height;
  content.bytes = read_pixels(file, h, content);
  if (mapped) check_indices(content);
  if ((h.order & kFromTop) == 0) {
    const auto row = static_cast<std::ptrdiff_t>(content.bytes.size()) / h.height;
    for (int top = 0, bottom = h.height - 1; top < bottom; ++top, --bottom) {
      const auto upper = content.bytes.begin() + top * row, lower = content.bytes.begin() + bottom * row;
      std::swap_ranges(upper, upper + row, lower);
    }
  }
  return true;
}

}  // namespace

bool read_tga(const std::string& path, TgaContent& content, std::string& error) {
  try {
    ByteReader file(path);
    return read_content(file, content);
  } catch (const std::runtime_error& failure) {
    error = failure.what();
    return false;
  }
}

}  // namespace lute
