// Image files that store an index into a table of colours for each pixel. The library of formats turns them into plain
// colours; scenes name the entries (`filter 3, 0.5`, `use_index`) and height fields take the indices as heights.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/image/image.hpp"

namespace lute {

struct ColorMapped {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;  // rows from the top, every one below the size of the palette
  std::vector<Image::Pixel> palette;  // values as stored / 255
};

// The first picture of a GIF file, without the screen around it; a transparent index has alpha 0. The rows of an interlaced file stay
// in the order in which they are stored, as the reference takes them. Nothing, with `error` set, when it cannot be read.
std::optional<ColorMapped> read_gif(const std::string& path, std::string& error);

// A BMP file of 1, 4 or 8 bits a pixel, plain or run-length encoded. Nothing and no error: the file has no colour map; nothing and
// an error: it has one, and is broken.
std::optional<ColorMapped> read_color_mapped_bmp(const std::string& path, std::string& error);

// A TIFF file of up to 8 bits a pixel; errors as above.
std::optional<ColorMapped> read_color_mapped_tiff(const std::string& path, std::string& error);

// An entry of a palette whose values go from 0 to `maximum`.
Image::Pixel palette_entry(std::uint32_t red, std::uint32_t green, std::uint32_t blue, std::uint32_t maximum = 255);

// Pixels must have an entry in the palette: false, with `error` set, if one has none.
bool check_indices(const ColorMapped& image, const std::string& path, std::string& error);

}  // namespace lute
