// The module behind engine/image/format_library.hpp: the one place that includes OpenImageIO.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

#include "engine/image/format_library.hpp"

namespace lute {
namespace {

OIIO::TypeDesc to_oiio(ChannelType type) {
  switch (type) {
    case ChannelType::kUint8: return OIIO::TypeDesc::UINT8;
    case ChannelType::kUint16: return OIIO::TypeDesc::UINT16;
    case ChannelType::kHalf: return OIIO::TypeDesc::HALF;
    case ChannelType::kFloat: return OIIO::TypeDesc::FLOAT;
  }
  return OIIO::TypeDesc::UINT8;
}

ChannelType from_oiio(OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8: return ChannelType::kUint8;
    case OIIO::TypeDesc::HALF: return ChannelType::kHalf;
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE: return ChannelType::kFloat;
    default: return ChannelType::kUint16;
  }
}

bool read_from(OIIO::ImageInput* input, ImagePixels& pixels, ImageFileInfo& info, std::string& error) {
  if (input == nullptr) {
    error = OIIO::geterror();
    return false;
  }
  const OIIO::ImageSpec& spec = input->spec();
  pixels.width = spec.width;
  pixels.height = spec.height;
  pixels.channels = std::min(spec.nchannels, 4);
  pixels.values.resize(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) *
                       static_cast<std::size_t>(pixels.channels));
  if (!input->read_image(0, 0, 0, pixels.channels, OIIO::TypeDesc::FLOAT, pixels.values.data())) {
    error = input->geterror();
    return false;
  }
  info.stored = from_oiio(spec.format);
  info.format = input->format_name();
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  info.gamma = static_cast<double>(spec.get_float_attribute("oiio:Gamma", 0.0f));
  info.srgb = space == "sRGB";
  info.has_alpha = spec.alpha_channel >= 0;
  const bool float_file = info.format == "openexr" || info.format == "tiff";
  info.alpha_premultiplied = float_file && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
  return true;
}

OIIO::ImageSpec pixels_as_stored() {
  OIIO::ImageSpec wish;
  wish["oiio:UnassociatedAlpha"] = 1;
  return wish;
}

class OpenImageIoLibrary final : public FormatLibrary {
 public:
  bool read(const std::string& path, ImagePixels& pixels, ImageFileInfo& info, std::string& error) const override {
    const OIIO::ImageSpec wish = pixels_as_stored();
    return read_from(OIIO::ImageInput::open(path, &wish).get(), pixels, info, error);
  }

  bool read(const std::string& path, std::span<const std::uint8_t> bytes, ImagePixels& pixels, ImageFileInfo& info,
            std::string& error) const override {
    OIIO::Filesystem::IOMemReader content(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
    OIIO::Filesystem::IOProxy* proxy = &content;
    OIIO::ImageSpec wish = pixels_as_stored();
    wish.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);  // as a parameter of open() it is forgotten when there are wishes
    return read_from(OIIO::ImageInput::open(path, &wish, proxy).get(), pixels, info, error);
  }

  bool write(const std::string& path, const ImagePixels& pixels, const WriteOptions& options, std::string& error) const override {
    const auto output = OIIO::ImageOutput::create(options.format);
    if (!output) {
      error = OIIO::geterror();
      return false;
    }
    OIIO::ImageSpec spec(pixels.width, pixels.height, pixels.channels, to_oiio(options.type));
    spec["oiio:UnassociatedAlpha"] = 1;
    spec["CompressionQuality"] = options.jpeg_quality;
    if (options.format == "jpeg") spec["jpeg:subsampling"] = "4:4:4";
    if (options.format == "targa") spec["compression"] = options.rle ? "rle" : "none";
    if (options.format == "openexr") {
      spec["oiio:UnassociatedAlpha"] = 0;
      spec["compression"] = "zip";
    }
    if (!output->open(path, spec) || !output->write_image(OIIO::TypeDesc::FLOAT, pixels.values.data()) || !output->close()) {
      error = output->geterror();
      return false;
    }
    return true;
  }
};

}  // namespace
}  // namespace lute

extern "C" const lute::FormatLibrary* lute_format_library() {
  static const lute::OpenImageIoLibrary library;
  return &library;
}
