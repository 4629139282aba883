#include "engine/image/png_reader.hpp"

#include <png.h>

#include <bit>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace lute {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// libpng's errors become exceptions, so that everything is freed on the way out.
[[noreturn]] void raise(png_structp, png_const_charp message) { throw std::runtime_error(message); }
void ignore(png_structp, png_const_charp) {}

struct Reader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, raise, ignore);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void read_palette(const Reader& reader, PngContent& content) {
  png_colorp colors = nullptr;
  int count = 0;
  png_get_PLTE(reader.png, reader.info, &colors, &count);
  png_bytep alpha = nullptr;
  int alpha_count = 0;
  png_get_tRNS(reader.png, reader.info, &alpha, &alpha_count, nullptr);
  const auto unit = [](png_byte v) { return static_cast<float>(v) / 255; };
  // Indices may be larger than the palette in broken files: fill up to what a byte can say.
  content.palette.assign(256, Image::Pixel{});
  for (int i = 0; i < count; ++i) {
    Image::Pixel& p = content.palette[static_cast<std::size_t>(i)];
    p.rgb = {unit(colors[i].red), unit(colors[i].green), unit(colors[i].blue)};
    if (i < alpha_count) p.alpha = unit(alpha[i]);
  }
  content.palette.resize(static_cast<std::size_t>(count));
}

// Asks libpng for whole bytes or words, palettes kept, transparent colours as alpha.
void choose_transformations(const Reader& reader, PngContent& content) {
  const png_byte type = png_get_color_type(reader.png, reader.info), depth = png_get_bit_depth(reader.png, reader.info);
  content.deep = depth == 16;
  content.grey_file = type == PNG_COLOR_TYPE_GRAY && depth <= 8;
  if (type == PNG_COLOR_TYPE_PALETTE) {
    read_palette(reader, content);
    png_set_packing(reader.png);
  } else {
    if (type == PNG_COLOR_TYPE_GRAY && depth < 8) png_set_expand_gray_1_2_4_to_8(reader.png);
    if (png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(reader.png);
  }
  if (content.deep && std::endian::native == std::endian::little) png_set_swap(reader.png);
  int intent = 0;
  content.srgb = png_get_sRGB(reader.png, reader.info, &intent) != 0;
  double gamma = 0;
  if (png_get_gAMA(reader.png, reader.info, &gamma) != 0) content.gamma = gamma;
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
}

// No deflate stream is longer than 1032 times its file: what a broken header promises is not allocated. To be asked before the
// transformations are chosen, which make the rows longer.
void check_length(const Reader& reader, std::uintmax_t file_bytes) {
  const std::uintmax_t stored = std::uintmax_t{png_get_rowbytes(reader.png, reader.info)} * png_get_image_height(reader.png, reader.info);
  if (stored / 1032 > file_bytes) throw std::runtime_error("it is too short for its size");
}

void read_pixels(const Reader& reader, PngContent& content) {
  content.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  content.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  content.channels = png_get_channels(reader.png, reader.info);
  const auto samples = static_cast<std::size_t>(content.width) * static_cast<std::size_t>(content.channels);
  const auto rows = static_cast<std::size_t>(content.height);
  std::vector<png_bytep> row(rows);
  if (content.deep) {
    content.words.resize(samples * rows);
    for (std::size_t i = 0; i < rows; ++i) row[i] = reinterpret_cast<png_bytep>(&content.words[i * samples]);
  } else {
    content.bytes.resize(samples * rows);
    for (std::size_t i = 0; i < rows; ++i) row[i] = &content.bytes[i * samples];
  }
  png_read_image(reader.png, row.data());
  const std::size_t colors = content.palette.size();
  if (colors != 0)
    for (const std::uint8_t index : content.bytes)
      if (index >= colors) throw std::runtime_error("a pixel's index lies outside the palette");
}

}  // namespace

bool read_png(const std::string& path, PngContent& content, std::string& error) {
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) {
    error = "Cannot open '" + path + "'.";
    return false;
  }
  try {
    const Reader reader;
    if (reader.info == nullptr) throw std::runtime_error("out of memory");
    png_init_io(reader.png, file.get());
    png_read_info(reader.png, reader.info);
    check_length(reader, std::filesystem::file_size(path));
    choose_transformations(reader, content);
    read_pixels(reader, content);
    return true;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    error = "Cannot read PNG image '" + path + "': " + failure.what() + ".";
    return false;
  }
}

}  // namespace lute
