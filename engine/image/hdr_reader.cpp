#include "engine/image/hdr_reader.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "engine/image/byte_reader.hpp"

namespace lute {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr int kShortestCodedRow = 8, kLongestCodedRow = 32767;  // of the new way
constexpr int kLongestSide = 1 << 16;

std::string line(ByteReader& file) {
  std::string text;
  for (char c = static_cast<char>(file.byte()); c != '\n'; c = static_cast<char>(file.byte())) text += c;
  if (text.ends_with('\r')) text.pop_back();
  return text;
}

void read_size(ByteReader& file, HdrContent& content) {
  if (!line(file).starts_with("#?")) throw std::runtime_error("it is not in HDR format");
  while (!line(file).empty()) {
  }
  std::istringstream size(line(file));
  std::string first_axis, second_axis;
  size >> first_axis >> content.height >> second_axis >> content.width;
  const auto possible = [](int side) { return side >= 1 && side <= kLongestSide; };
  if (!size || !possible(content.width) || !possible(content.height)) throw std::runtime_error("its size is not possible");
}

Rgbe read_pixel(ByteReader& file) {
  Rgbe pixel;
  for (std::uint8_t& byte : pixel) byte = file.byte();
  return pixel;
}

// The old way: the pixel (1, 1, 1, n) repeats the one before n times; several in a row are digits of base 256, the lowest first.
void read_plain_row(ByteReader& file, std::vector<Rgbe>& row, Rgbe pixel) {
  unsigned shift = 0;
  for (std::size_t filled = 0;;) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && filled > 0) {
      const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : row.size();
      if (count > row.size() - filled) throw std::runtime_error("a run leaves its row");
      for (std::size_t i = 0; i < count; ++i, ++filled) row[filled] = row[filled - 1];
      shift += 8;
    } else {
      row[filled++] = pixel;
      shift = 0;
    }
    if (filled == row.size()) return;
    pixel = read_pixel(file);
  }
}

// The new way: each of the four bytes has its own runs (128 + count, value) and pieces (count, values) along the row.
void read_coded_row(ByteReader& file, std::vector<Rgbe>& row) {
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t column = 0; column < row.size();) {
      const std::size_t code = file.byte();
      const bool run = code > 128;
      const std::size_t count = run ? code - 128 : code;
      if (count == 0 || count > row.size() - column) throw std::runtime_error("a run leaves its row");
      const std::uint8_t value = run ? file.byte() : std::uint8_t{0};
      for (std::size_t i = 0; i < count; ++i) row[column++][channel] = run ? value : file.byte();
    }
  }
}

void read_row(ByteReader& file, std::vector<Rgbe>& row) {
  const Rgbe first = read_pixel(file);
  const auto width = static_cast<int>(row.size());
  const bool may_be_coded = width >= kShortestCodedRow && width <= kLongestCodedRow;
  if (may_be_coded && first[0] == 2 && first[1] == 2 && (first[2] & 128) == 0) {
    if (first[2] * 256 + first[3] != width) throw std::runtime_error("a row has another length");
    read_coded_row(file, row);
  } else {
    read_plain_row(file, row, first);
  }
}

}  // namespace

bool read_hdr(const std::string& path, HdrContent& content, std::string& error) {
  try {
    ByteReader file(path);
    read_size(file, content);
    std::vector<Rgbe> row(static_cast<std::size_t>(content.width));
    for (int y = 0; y < content.height; ++y) {
      read_row(file, row);
      for (const Rgbe& pixel : row) {
        for (std::size_t c = 0; c < 3; ++c) {
          const float middle = static_cast<float>(pixel[c]) + 0.5f;
          content.values.push_back(pixel[3] == 0 ? 0.0f : std::ldexp(middle, pixel[3] - 136));
        }
      }
    }
    return true;
  } catch (const std::runtime_error& failure) {
    error = failure.what();
    return false;
  }
}

}  // namespace lute
