#include "engine/image/image_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <new>

#include "engine/image/format_library.hpp"
#include "engine/image/color_mapped.hpp"
#include "engine/image/hdr_reader.hpp"
#include "engine/image/jpeg_reader.hpp"
#include "engine/image/png_reader.hpp"
#include "engine/image/pnm_reader.hpp"
#include "engine/image/tga_reader.hpp"

namespace lute {
namespace {

using Convert = std::function<float(float)>;

// From stored values to the working space. `curve`: the file's own; nothing: values are taken as being in the working space.
Convert conversion(const ImageFileOptions& options, std::optional<GammaCurve> curve) {
  const auto same = [](float v) { return v; };
  if (options.file_gamma)
    curve = options.file_gamma;
  else if (!options.for_colors)
    return same;
  if (!options.working || !curve || *curve == *options.working) {
    // Values that are not colours become linear light by an explicit `gamma`, whatever the working space.
    if (!options.for_colors && curve) return [c = *curve](float v) { return c.decode(v); };
    return same;
  }
  if (!options.for_colors) return [c = *curve](float v) { return c.decode(v); };
  return [c = *curve, w = *options.working](float v) { return w.encode(c.decode(v)); };
}

std::vector<float> table(std::size_t size, const Convert& convert) {
  std::vector<float> values(size);
  for (std::size_t i = 0; i < size; ++i) values[i] = convert(static_cast<float>(i) / static_cast<float>(size - 1));
  return values;
}

// The reference brings grey files back to 8 bits after decoding, by way of its grey formula in single precision, and truncates.
void requantise_grey(std::vector<float>& decoded) {
  for (float& v : decoded) {
    const float grey_value = file_grey(Rgb(v));
    v = std::trunc(255.0f * grey_value) / 255.0f;
  }
}

std::optional<GammaCurve> curve_of_png(const PngContent& png, const ImageFileOptions& options) {
  if (png.srgb) return GammaCurve::srgb();
  if (png.gamma > 0) return GammaCurve::power(1 / png.gamma);
  if (options.legacy) return std::nullopt;
  return GammaCurve::srgb();
}

std::optional<GammaCurve> curve_of_format(const std::string& format, const ImageFileOptions& options) {
  if (format == "openexr" || format == "hdr") return GammaCurve::linear();
  const bool picture = format == "jpeg" || format == "gif" || format == "bmp" || format == "targa" || format == "tga";
  if (picture && !options.legacy) return GammaCurve::srgb();
  return std::nullopt;
}

std::shared_ptr<Image> make_png(const std::string& path, const ImageFileOptions& options, std::string& error) {
  PngContent png;
  if (!read_png(path, png, error)) return nullptr;
  const Convert convert = conversion(options, curve_of_png(png, options));
  if (!png.palette.empty()) {
    for (Image::Pixel& p : png.palette) p.rgb = {convert(p.rgb.r), convert(p.rgb.g), convert(p.rgb.b)};
    auto image = std::make_shared<Image>(png.width, png.height, std::move(png.bytes), std::move(png.palette));
    image->set_format_keeps_alpha();
    return image;
  }
  if (png.deep) return std::make_shared<Image>(png.width, png.height, png.channels, std::move(png.words), table(65536, convert));
  std::vector<float> decoded = table(256, convert);
  if (png.grey_file) requantise_grey(decoded);
  return std::make_shared<Image>(png.width, png.height, png.channels, std::move(png.bytes), std::move(decoded));
}

std::shared_ptr<Image> make_jpeg(const std::string& path, const ImageFileOptions& options, std::string& error) {
  JpegContent jpeg;
  if (!read_jpeg(path, jpeg, error)) return nullptr;
  const Convert convert = conversion(options, curve_of_format("jpeg", options));
  return std::make_shared<Image>(jpeg.width, jpeg.height, jpeg.channels, std::move(jpeg.bytes), table(256, convert));
}

std::shared_ptr<Image> make_pnm(const std::string& path, const std::string& type, const ImageFileOptions& options, std::string& error) {
  PnmContent pnm;
  if (!read_pnm(path, type, pnm, error)) return nullptr;
  const Convert convert = conversion(options, curve_of_format("pnm", options));
  if (pnm.deep) return std::make_shared<Image>(pnm.width, pnm.height, pnm.channels, std::move(pnm.words), table(65536, convert));
  return std::make_shared<Image>(pnm.width, pnm.height, pnm.channels, std::move(pnm.bytes), table(256, convert));
}

std::shared_ptr<Image> make_color_mapped(ColorMapped file, const Convert& convert, bool keeps_alpha) {
  for (Image::Pixel& p : file.palette) p.rgb = {convert(p.rgb.r), convert(p.rgb.g), convert(p.rgb.b)};
  auto image = std::make_shared<Image>(file.width, file.height, std::move(file.indices), std::move(file.palette));
  if (keeps_alpha) image->set_format_keeps_alpha();
  return image;
}

std::shared_ptr<Image> make_tga(TgaContent tga, const Convert& convert) {
  if (!tga.palette.empty()) return make_color_mapped({tga.width, tga.height, std::move(tga.bytes), std::move(tga.palette)}, convert, true);
  return std::make_shared<Image>(tga.width, tga.height, tga.channels, std::move(tga.bytes), table(256, convert));
}

std::shared_ptr<Image> make_hdr(const std::string& path, const ImageFileOptions& options, std::string& error) {
  HdrContent hdr;
  if (!read_hdr(path, hdr, error)) return nullptr;
  std::ranges::transform(hdr.values, hdr.values.begin(), conversion(options, curve_of_format("hdr", options)));
  auto image = std::make_shared<Image>(hdr.width, hdr.height, 3, std::move(hdr.values));
  image->set_format_keeps_alpha();
  return image;
}

// A POT file, of FractInt, is a GIF file of twice the width: high bytes in the left half, low bytes in the right one.
std::shared_ptr<Image> make_pot(const std::string& path, const ImageFileOptions& options, std::string& error) {
  const std::optional<ColorMapped> file = read_gif(path, error);
  if (!file) return nullptr;
  const int width = file->width / 2;
  std::vector<std::uint16_t> heights;
  for (int row = 0; row < file->height; ++row) {
    const auto line = static_cast<std::size_t>(row) * static_cast<std::size_t>(file->width);
    for (int column = 0; column < width; ++column) {
      const std::uint8_t* high = &file->indices[line + static_cast<std::size_t>(column)];
      heights.push_back(static_cast<std::uint16_t>(256 * high[0] + high[width]));
    }
  }
  return std::make_shared<Image>(width, file->height, 1, std::move(heights), table(65536, conversion(options, std::nullopt)));
}

template <class Integer>
std::vector<Integer> integers(const std::vector<float>& values) {
  constexpr float kMaximum = static_cast<float>(std::numeric_limits<Integer>::max());
  std::vector<Integer> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
                 [](float v) { return static_cast<Integer>(std::lround(std::clamp(v, 0.0f, 1.0f) * kMaximum)); });
  return result;
}

void drop_alpha(ImagePixels& pixels) {
  const auto channels = static_cast<std::size_t>(pixels.channels);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pixels.values.size(); ++i)
    if (i % channels != channels - 1) pixels.values[kept++] = pixels.values[i];
  pixels.values.resize(kept);
  --pixels.channels;
}

// TIFF files are read with 8 bits, alpha multiplied into the colours. The reference takes grey as it is stored, and its alpha only if it is
// stored as such in 8 bits.
std::shared_ptr<Image> make_tiff(ImagePixels pixels, const ImageFileInfo& info, const Convert& convert) {
  if (pixels.channels == 2 && (!info.has_alpha || info.stored != ChannelType::kUint8)) drop_alpha(pixels);
  std::vector<std::uint8_t> bytes;
  // Of 16 bits, grey files keep the upper eight, others the nearest of 256 codes.
  if (info.stored == ChannelType::kUint16)
    for (const int v : integers<std::uint16_t>(pixels.values))
      bytes.push_back(static_cast<std::uint8_t>(pixels.channels < 3 ? v >> 8 : (v + 128) / 257));
  else
    bytes = integers<std::uint8_t>(pixels.values);
  if (pixels.channels == 4 && !info.alpha_premultiplied) {
    const auto channels = static_cast<std::size_t>(pixels.channels);
    for (std::size_t first = 0; first + channels <= bytes.size(); first += channels) {
      const int alpha = bytes[first + channels - 1];
      for (std::size_t c = 0; c + 1 < channels; ++c)
        bytes[first + c] = static_cast<std::uint8_t>((bytes[first + c] * alpha + 127) / 255);
    }
  }
  return std::make_shared<Image>(pixels.width, pixels.height, pixels.channels, std::move(bytes), table(256, convert));
}

// OpenImageIO finds out the format by the file's content; the word in the scene must be right, too.
bool is_of_type(const std::string& type, const std::string& format) {
  static const std::map<std::string, std::string> formats = {
      {"tga", "targa"}, {"tiff", "tiff"}, {"bmp", "bmp"}, {"exr", "openexr"}};
  const auto found = formats.find(type);
  return found == formats.end() || found->second == format;
}

std::shared_ptr<Image> make_other(const std::string& path, const std::string& type, const ImageFileOptions& options,
                                  std::string& error) {
  const FormatLibrary* library = format_library(error);
  if (library == nullptr) return nullptr;
  ImagePixels pixels;
  ImageFileInfo info;
  if (!library->read(path, pixels, info, error)) return nullptr;
  if (!is_of_type(type, info.format)) {
    error = "the file is of another format (" + info.format + ")";
    return nullptr;
  }
  const Convert convert = conversion(options, curve_of_format(info.format, options));
  std::shared_ptr<Image> image;
  if (info.format == "tiff" && (info.stored == ChannelType::kUint8 || info.stored == ChannelType::kUint16)) {
    image = make_tiff(std::move(pixels), info, convert);
  } else if (info.stored == ChannelType::kUint8) {
    image = std::make_shared<Image>(pixels.width, pixels.height, pixels.channels, integers<std::uint8_t>(pixels.values),
                                    table(256, convert));
  } else if (info.stored == ChannelType::kUint16) {
    image = std::make_shared<Image>(pixels.width, pixels.height, pixels.channels, integers<std::uint16_t>(pixels.values),
                                    table(65536, convert));
  } else {
    const bool has_alpha = pixels.channels % 2 == 0;
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
      const bool is_alpha = has_alpha && static_cast<int>(i % static_cast<std::size_t>(pixels.channels)) == pixels.channels - 1;
      if (!is_alpha) pixels.values[i] = convert(pixels.values[i]);
    }
    image = std::make_shared<Image>(pixels.width, pixels.height, pixels.channels, std::move(pixels.values));
  }
  const bool always_premultiplied = info.format == "tiff" || info.format == "openexr";
  if (always_premultiplied) image->set_format_keeps_alpha();
  image->set_premultiplied(always_premultiplied || info.alpha_premultiplied);
  return image;
}

std::shared_ptr<Image> make_image(const std::string& path, const std::string& type, const ImageFileOptions& options,
                                  std::string& error) {
  if (type == "png") return make_png(path, options, error);
  if (type == "jpeg") return make_jpeg(path, options, error);
  if (type == "ppm" || type == "pgm") return make_pnm(path, type, options, error);
  if (type == "pot") return make_pot(path, options, error);
  if (type == "hdr") return make_hdr(path, options, error);
  const Convert convert = conversion(options, curve_of_format(type, options));
  TgaContent tga;
  if (type == "tga" && read_tga(path, tga, error)) return make_tga(std::move(tga), convert);
  std::optional<ColorMapped> file;
  if (type == "gif") file = read_gif(path, error);
  if (type == "bmp") file = read_color_mapped_bmp(path, error);
  if (type == "tiff") file = read_color_mapped_tiff(path, error);
  if (file) return make_color_mapped(std::move(*file), convert, type == "gif");
  return error.empty() ? make_other(path, type, options, error) : nullptr;
}

}  // namespace

std::string image_type_of(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos) return "";
  std::string extension = path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static const std::map<std::string, std::string> types = {
      {"gif", "gif"},   {"tga", "tga"}, {"png", "png"},   {"jpg", "jpeg"}, {"jpeg", "jpeg"}, {"tif", "tiff"}, {"tiff", "tiff"},
      {"bmp", "bmp"},   {"ppm", "ppm"}, {"pgm", "pgm"},   {"exr", "exr"},  {"hdr", "hdr"},   {"iff", "iff"},  {"pot", "pot"}};
  const auto found = types.find(extension);
  return found == types.end() ? "" : found->second;
}

ImagePtr ImageFiles::load(const std::string& path, const ImageFileOptions& options, std::string& error) {
  const auto key = std::make_pair(path, options);
  if (const auto it = loaded_.find(key); it != loaded_.end()) return it->second;
  const std::string type = options.type.empty() ? image_type_of(path) : options.type;
  if (type == "iff") {  // of the Amiga; what the format library takes for IFF is another format
    error = "IFF files are not supported; convert it to PNG";
    return nullptr;
  }
  std::shared_ptr<Image> image;
  try {
    image = make_image(path, type, options, error);
  } catch (const std::bad_alloc&) {
    error = "its pixels need more memory than there is";
  }
  if (image == nullptr) return nullptr;
  if (options.premultiplied) image->set_premultiplied(*options.premultiplied);
  return loaded_[key] = image;
}

}  // namespace lute
