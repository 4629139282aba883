#include "engine/output/write_image.hpp"

#include <stdexcept>

#include "engine/output/atomic_file.hpp"
#include "engine/output/encode.hpp"
#include "engine/output/png_writer.hpp"
#include "engine/output/pnm_writer.hpp"

namespace lute {
namespace {

ImagePixels scaled(const EncodedImage& encoded) {
  ImagePixels image{encoded.width, encoded.height, encoded.channels, {}};
  image.values.reserve(encoded.codes.size());
  for (const std::uint16_t code : encoded.codes)
    image.values.push_back(static_cast<float>(code) / static_cast<float>(encoded.max));
  return image;
}

WriteOptions library_options(const OutputSettings& settings) {
  WriteOptions options;
  switch (settings.format) {
    case FileFormat::kTarga:
      options.format = "targa";
      break;
    case FileFormat::kTargaRle:
      options.format = "targa";
      options.rle = true;
      break;
    case FileFormat::kBmp:
      options.format = "bmp";
      break;
    case FileFormat::kJpeg:
      options.format = "jpeg";
      if (settings.compression > 1) options.jpeg_quality = settings.compression > 100 ? 100 : settings.compression;
      break;
    case FileFormat::kOpenExr:
      options.format = "openexr";
      options.type = ChannelType::kHalf;
      break;
    case FileFormat::kRadianceHdr:
      options.format = "hdr";
      options.type = ChannelType::kFloat;
      break;
    case FileFormat::kPng:
    case FileFormat::kPpm:
      break;
  }
  return options;
}

void write_by_library(const std::string& path, const ImagePixels& image, const WriteOptions& options) {
  std::string error;
  const FormatLibrary* library = format_library(error);
  if (library == nullptr || !library->write(path, image, options, error)) throw std::runtime_error(error);
}

void write_content(const std::string& path, const Film& film, const WorkingSpace& working,
                   const OutputSettings& settings) {
  const Transfer transfer(working, settings.file_gamma, settings.display_gamma);
  if (traits_of(settings.format).linear_light) {
    write_by_library(path, linear_light(film, transfer, settings), library_options(settings));
    return;
  }
  const EncodedImage encoded = encode(film, transfer, settings);
  switch (settings.format) {
    case FileFormat::kPng:
      write_png(path, encoded, transfer.declared());
      break;
    case FileFormat::kPpm:
      write_pnm(path, encoded);
      break;
    default:
      write_by_library(path, scaled(encoded), library_options(settings));
      break;
  }
}

}  // namespace

void write_image(const std::string& path, const Film& film, const WorkingSpace& working,
                 const OutputSettings& settings) {
  AtomicFile file(path);
  try {
    write_content(file.temporary_path(), film, working, settings);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot write '" + path + "': " + error.what());
  }
  file.commit();
}

}  // namespace lute
