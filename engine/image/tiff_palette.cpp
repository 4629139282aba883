// Colour-mapped TIFF files. The colour map is read here, the indices, which may be stored in many ways, by the library of formats: from a copy
// of the file in memory that says they are shades of grey. Layout: TIFF 6.0 specification (Adobe, 1992).
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/image/byte_reader.hpp"
#include "engine/image/color_mapped.hpp"
#include "engine/image/format_library.hpp"

namespace lute {
namespace {

enum Tag { kBitsPerSample = 258, kPhotometric = 262, kSamplesPerPixel = 277, kColorMap = 320 };
enum Photometric : std::uint8_t { kBlackIsZero = 1, kPalette = 3 };
constexpr std::uint32_t kShort = 3;

struct Entry {
  std::uint32_t type = 0, count = 0;
  std::size_t place = 0;  // of its values in the file
};

// Numbers in the order of bytes that the file has.
class TiffReader {
 public:
  explicit TiffReader(ByteReader& file) : file_(file) {
    const std::uint32_t order = file.little_endian(2);
    big_endian_ = order == 0x4d4d;
    valid_ = (big_endian_ || order == 0x4949) && number(2) == 42;
  }
  bool valid() const { return valid_; }
  bool big_endian() const { return big_endian_; }
  std::uint32_t number(int size) {
    if (!big_endian_) return file_.little_endian(size);
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value = value << 8 | file_.byte();
    return value;
  }
  std::uint32_t short_at(std::size_t place) {
    file_.seek(place);
    return number(2);
  }
  // The first directory.
  std::map<std::uint32_t, Entry> directory() {
    file_.seek(4);
    file_.seek(number(4));
    std::map<std::uint32_t, Entry> entries;
    for (std::uint32_t left = number(2); left > 0; --left) {
      const std::uint32_t tag = number(2);
      Entry entry{number(2), number(4), file_.position()};
      const std::uint32_t offset = number(4);
      if (entry.type == kShort && entry.count > 2) entry.place = offset;
      entries[tag] = entry;
    }
    return entries;
  }

 private:
  ByteReader& file_;
  bool big_endian_ = false, valid_ = false;
};

// Values of 16 bits; if none is above 255, the program that wrote them meant 8 bits, as many did.
std::vector<Image::Pixel> read_palette(TiffReader& tiff, const Entry& map, std::size_t size) {
  std::vector<std::uint32_t> values;
  for (std::size_t i = 0; i < 3 * size; ++i) values.push_back(tiff.short_at(map.place + 2 * i));
  const std::uint32_t maximum = *std::ranges::max_element(values) < 256 ? 255 : 65535;
  std::vector<Image::Pixel> palette;
  for (std::size_t i = 0; i < size; ++i)
    palette.push_back(palette_entry(values[i], values[size + i], values[2 * size + i], maximum));
  return palette;
}

}  // namespace

std::optional<ColorMapped> read_color_mapped_tiff(const std::string& path, std::string& error) {
  try {
    ByteReader file(path);
    TiffReader tiff(file);
    if (!tiff.valid()) return std::nullopt;
    auto entries = tiff.directory();
    const auto value = [&](Tag tag, std::uint32_t otherwise) {
      const auto found = entries.find(tag);
      return found == entries.end() ? otherwise : tiff.short_at(found->second.place);
    };
    const std::uint32_t bits = value(kBitsPerSample, 1);
    if (value(kPhotometric, kBlackIsZero) != kPalette || value(kSamplesPerPixel, 1) != 1 || bits > 8) return std::nullopt;
    const std::uint32_t colors = 1u << bits;
    const Entry map = entries[kColorMap];
    if (map.type != kShort || map.count != 3 * colors) throw std::runtime_error("it has no colour map");
    ColorMapped image;
    image.palette = read_palette(tiff, map, colors);
    std::vector<std::uint8_t> as_grey = file.bytes();
    as_grey[entries[kPhotometric].place + (tiff.big_endian() ? 1 : 0)] = kBlackIsZero;
    const FormatLibrary* library = format_library(error);
    ImagePixels pixels;
    ImageFileInfo info;
    if (library == nullptr || !library->read(path, as_grey, pixels, info, error)) return std::nullopt;
    if (pixels.channels != 1) throw std::runtime_error("it has more than a colour map");
    image.width = pixels.width;
    image.height = pixels.height;
    const auto largest = static_cast<float>(colors - 1);
    for (const float v : pixels.values) image.indices.push_back(static_cast<std::uint8_t>(std::lround(v * largest)));
    return image;
  } catch (const std::runtime_error& failure) {
    error = failure.what();
    return std::nullopt;
  }
}

}  // namespace lute
