// Layout: the manual pages ppm(5) and pgm(5) of netpbm.
#include "engine/image/pnm_reader.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/image/byte_reader.hpp"

namespace lute {
namespace {

constexpr std::uint32_t kLargest = 65535;

bool is_space(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The next number of a header, or of a file of numbers, and the one character after it. Comments go to the end of their line.
std::uint32_t read_number(ByteReader& file, bool may_end_file = false) {
  std::uint8_t c = file.byte();
  while (is_space(c) || c == '#') {
    if (c == '#')
      while (c != '\n') c = file.byte();
    c = file.byte();
  }
  if (c < '0' || c > '9') throw std::runtime_error("it has something else where a number is expected");
  std::uint32_t number = 0;
  while (c >= '0' && c <= '9') {
    number = 10 * number + static_cast<std::uint32_t>(c - '0');
    if (number > 1000000) throw std::runtime_error("it has a number that is too large");
    if (may_end_file && file.at_end()) break;
    c = file.byte();
  }
  return number;
}

std::uint32_t read_value(ByteReader& file, bool as_numbers, std::uint32_t maximum) {
  if (as_numbers) return read_number(file, true);
  const std::uint32_t first = file.byte();
  return maximum < 256 ? first : 256 * first + file.byte();
}

void read_content(ByteReader& file, const std::string& type, PnmContent& content) {
  const std::uint8_t letter = file.byte(), digit = file.byte();
  content.channels = type == "ppm" ? 3 : 1;
  const std::uint8_t numbers = content.channels == 3 ? '3' : '2', bytes = content.channels == 3 ? '6' : '5';
  if (letter != 'P' || (digit != numbers && digit != bytes))
    throw std::runtime_error(content.channels == 3 ? "it is not in PPM format" : "it is not in PGM format");
  const std::uint32_t width = read_number(file), height = read_number(file), maximum = read_number(file);
  if (width == 0 || height == 0) throw std::runtime_error("it has no pixels");
  if (maximum == 0 || maximum > kLargest) throw std::runtime_error("its maximum value is not possible");
  content.width = static_cast<int>(width);
  content.height = static_cast<int>(height);
  content.deep = maximum != 255;
  const std::uint64_t count = std::uint64_t{width} * height * static_cast<std::uint64_t>(content.channels);
  for (std::uint64_t i = 0; i < count; ++i) {  // a file that ends too early ends the loop
    const std::uint32_t value = std::min(read_value(file, digit == numbers, maximum), maximum);
    if (content.deep)
      content.words.push_back(static_cast<std::uint16_t>((2 * kLargest * std::uint64_t{value} + maximum) / (2 * maximum)));
    else
      content.bytes.push_back(static_cast<std::uint8_t>(value));
  }
}

}  // namespace

bool read_pnm(const std::string& path, const std::string& type, PnmContent& content, std::string& error) {
  try {
    ByteReader file(path);
    read_content(file, type, content);
    return true;
  } catch (const std::runtime_error& failure) {
    error = failure.what();
    return false;
  }
}

}  // namespace lute
