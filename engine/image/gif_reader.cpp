#include "engine/image/gif_reader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace lute {
namespace {

// The bytes of a file, read from the front.
class Bytes {
 public:
  explicit Bytes(std::vector<std::uint8_t> data) : data_(std::move(data)) {}

  std::uint8_t byte() {
    if (at_ == data_.size()) throw std::runtime_error("the file ends too early");
    return data_[at_++];
  }
  int word() {
    const int low = byte();
    return low + 256 * byte();
  }
  void skip(std::size_t count) {
    if (count > data_.size() - at_) throw std::runtime_error("the file ends too early");
    at_ += count;
  }
  // Sub-blocks: a length and as many bytes, up to a length of 0. A file that is cut off ends the block.
  std::vector<std::uint8_t> block() {
    std::vector<std::uint8_t> joined;
    while (at_ < data_.size()) {
      const std::size_t length = data_[at_++];
      if (length == 0) break;
      const std::size_t there = std::min(length, data_.size() - at_);
      const auto first = data_.begin() + static_cast<std::ptrdiff_t>(at_);
      joined.insert(joined.end(), first, first + static_cast<std::ptrdiff_t>(there));
      at_ += there;
    }
    return joined;
  }

 private:
  std::vector<std::uint8_t> data_;
  std::size_t at_ = 0;
};

// Lempel, Ziv and Welch's code as GIF writes it: codes grow from least_bits + 1 to 12 bits, lowest bit first. At most `count` indices.
std::vector<std::uint8_t> unpack(const std::vector<std::uint8_t>& packed, int least_bits, std::size_t count) {
  if (least_bits < 1 || least_bits > 8) throw std::runtime_error("impossible code size");
  constexpr int kMostCodes = 4096;
  const int clear = 1 << least_bits, end = clear + 1;
  // A code stands for the string of `prefix` followed by `last`.
  std::array<std::uint16_t, kMostCodes> prefix{};
  std::array<std::uint8_t, kMostCodes> last{};
  for (int i = 0; i < clear; ++i) last[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
  std::vector<std::uint8_t> out, reversed;
  int bits = least_bits + 1, next = end + 1, previous = -1;
  std::uint32_t pending = 0;
  int pending_bits = 0;
  std::uint8_t first_of_previous = 0;
  for (const std::uint8_t byte : packed) {
    pending |= static_cast<std::uint32_t>(byte) << pending_bits;
    pending_bits += 8;
    while (pending_bits >= bits) {
      const int code = static_cast<int>(pending & ((1u << bits) - 1));
      pending >>= bits;
      pending_bits -= bits;
      if (code == end || out.size() >= count) return out;
      if (code == clear) {
        bits = least_bits + 1;
        next = end + 1;
        previous = -1;
        continue;
      }
      if (code > next || (code == next && previous < 0)) throw std::runtime_error("a code that is not defined yet");
      reversed.clear();
      int walk = code;
      if (code == next) {  // the string before, and its own first index
        reversed.push_back(first_of_previous);
        walk = previous;
      }
      for (; walk > end; walk = prefix[static_cast<std::size_t>(walk)]) reversed.push_back(last[static_cast<std::size_t>(walk)]);
      first_of_previous = last[static_cast<std::size_t>(walk)];
      reversed.push_back(first_of_previous);
      out.insert(out.end(), reversed.rbegin(), reversed.rend());
      if (previous >= 0 && next < kMostCodes) {
        prefix[static_cast<std::size_t>(next)] = static_cast<std::uint16_t>(previous);
        last[static_cast<std::size_t>(next)] = first_of_previous;
        if (++next == 1 << bits && bits < 12) ++bits;
      }
      previous = code;
    }
  }
  return out;
}

std::vector<Image::Pixel> read_palette(Bytes& bytes, int flags) {
  std::vector<Image::Pixel> palette(std::size_t{2} << (flags & 7));
  const auto unit = [&] { return static_cast<float>(bytes.byte()) / 255; };
  for (Image::Pixel& p : palette) {
    p.rgb.r = unit();
    p.rgb.g = unit();
    p.rgb.b = unit();
  }
  return palette;
}

// The rows of an interlaced picture in the order in which they are stored.
std::vector<int> row_order(int height, bool interlaced) {
  std::vector<int> rows;
  if (!interlaced)
    for (int row = 0; row < height; ++row) rows.push_back(row);
  else
    for (const auto& [first, step] : {std::pair(0, 8), std::pair(4, 8), std::pair(2, 4), std::pair(1, 2)})
      for (int row = first; row < height; row += step) rows.push_back(row);
  return rows;
}

void read_picture(Bytes& bytes, GifContent& content) {
  const int left = bytes.word(), top = bytes.word(), width = bytes.word(), height = bytes.word();
  const int flags = bytes.byte();
  if ((flags & 0x80) != 0) content.palette = read_palette(bytes, flags);
  if (content.palette.empty()) throw std::runtime_error("it has no palette");
  const int least_bits = bytes.byte();
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> indices = unpack(bytes.block(), least_bits, size);
  indices.resize(size);
  for (const std::uint8_t index : indices)
    if (index >= content.palette.size()) throw std::runtime_error("a pixel's index lies outside the palette");
  std::size_t from = 0;
  for (const int row : row_order(height, (flags & 0x40) != 0))
    for (int column = 0; column < width; ++column, ++from)
      if (left + column < content.width && top + row < content.height)
        content.indices[static_cast<std::size_t>(top + row) * static_cast<std::size_t>(content.width) +
                        static_cast<std::size_t>(left + column)] = indices[from];
}

void read(Bytes& bytes, GifContent& content) {
  if (bytes.byte() != 'G' || bytes.byte() != 'I' || bytes.byte() != 'F') throw std::runtime_error("it is no GIF file");
  bytes.skip(3);  // version
  content.width = bytes.word();
  content.height = bytes.word();
  if (content.width == 0 || content.height == 0) throw std::runtime_error("it is empty");
  const int flags = bytes.byte();
  bytes.skip(2);  // ground, aspect ratio
  if ((flags & 0x80) != 0) content.palette = read_palette(bytes, flags);
  content.indices.assign(static_cast<std::size_t>(content.width) * static_cast<std::size_t>(content.height), 0);
  std::size_t transparent = 256;
  for (;;) {
    switch (bytes.byte()) {
      case '!': {  // extension
        const bool graphic_control = bytes.byte() == 0xF9;
        const std::vector<std::uint8_t> block = bytes.block();  // flags, two bytes of delay, the transparent index
        if (graphic_control && block.size() >= 4 && (block[0] & 1) != 0) transparent = block[3];
        break;
      }
      case ',':
        read_picture(bytes, content);
        if (transparent < content.palette.size()) content.palette[transparent].alpha = 0;
        return;
      default: throw std::runtime_error("it has no picture");
    }
  }
}

}  // namespace

bool read_gif(const std::string& path, GifContent& content, std::string& error) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    error = "Cannot open '" + path + "'.";
    return false;
  }
  try {
    Bytes bytes(std::vector<std::uint8_t>(std::istreambuf_iterator<char>(file), {}));
    read(bytes, content);
    return true;
  } catch (const std::exception& failure) {
    error = "Cannot read GIF image '" + path + "': " + failure.what() + ".";
    return false;
  }
}

}  // namespace lute
