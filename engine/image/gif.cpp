// GIF through giflib.
#include <gif_lib.h>

#include <memory>
#include <stdexcept>

#include "engine/image/color_mapped.hpp"

namespace lute {
namespace {

struct CloseGif {
  void operator()(GifFileType* file) const {
    int error = 0;
    DGifCloseFile(file, &error);
  }
};

// giflib has no text for some of its own codes.
std::string text_of(int code) {
  const char* text = GifErrorString(code);
  return text != nullptr ? text : "it is damaged";
}

void check(int result, const GifFileType& file) {
  if (result == GIF_ERROR) throw std::runtime_error(text_of(file.Error));
}

// Reads an extension; the transparent index if it has one, else the one known so far.
int read_extension(GifFileType& file, int transparent) {
  int code = 0;
  GifByteType* block = nullptr;
  check(DGifGetExtension(&file, &code, &block), file);
  while (block != nullptr) {
    GraphicsControlBlock control{};
    if (code == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK) {
      transparent = control.TransparentColor;
    }
    check(DGifGetExtensionNext(&file, &block), file);
  }
  return transparent;
}

ColorMapped read_pixels(GifFileType& file, int transparent) {
  check(DGifGetImageDesc(&file), file);
  const GifImageDesc& picture = file.Image;
  const ColorMapObject* colors = picture.ColorMap != nullptr ? picture.ColorMap : file.SColorMap;
  if (colors == nullptr) throw std::runtime_error("it has no colour map");
  if (picture.Width < 1 || picture.Height < 1) throw std::runtime_error("it is empty");
  ColorMapped image;
  image.width = picture.Width;
  image.height = picture.Height;
  for (int row = 0; row < image.height; ++row) {
    // Row by row: a short file may promise any size.
    const std::size_t begin = image.indices.size();
    image.indices.resize(begin + static_cast<std::size_t>(image.width));
    check(DGifGetLine(&file, &image.indices[begin], image.width), file);
  }
  for (int i = 0; i < colors->ColorCount; ++i) {
    const GifColorType& c = colors->Colors[i];
    image.palette.push_back(palette_entry(c.Red, c.Green, c.Blue));
    if (i == transparent) image.palette.back().alpha = 0;
  }
  return image;
}

ColorMapped read_first_picture(GifFileType& file) {
  int transparent = NO_TRANSPARENT_COLOR;
  for (;;) {
    GifRecordType record = UNDEFINED_RECORD_TYPE;
    check(DGifGetRecordType(&file, &record), file);
    if (record == IMAGE_DESC_RECORD_TYPE) return read_pixels(file, transparent);
    if (record != EXTENSION_RECORD_TYPE) throw std::runtime_error("it has no picture");
    transparent = read_extension(file, transparent);
  }
}

}  // namespace

std::optional<ColorMapped> read_gif(const std::string& path, std::string& error) {
  int code = 0;
  const std::unique_ptr<GifFileType, CloseGif> file(DGifOpenFileName(path.c_str(), &code));
  if (file == nullptr) {
    error = "Cannot read GIF image '" + path + "': " + text_of(code) + ".";
    return std::nullopt;
  }
  try {
    ColorMapped image = read_first_picture(*file);
    if (check_indices(image, path, error)) return image;
  } catch (const std::runtime_error& failure) {
    error = "Cannot read GIF image '" + path + "': " + failure.what() + ".";
  }
  return std::nullopt;
}

}  // namespace lute
