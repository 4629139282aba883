#include "compare/picture.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace lute::compare {

namespace {

// Spreads the channels of a file (grey, grey + alpha, RGB, RGB + alpha) over RGBA.
void spread(const std::vector<float>& raw, int channels, Picture& picture) {
  const bool grey = channels <= 2;
  const bool alpha = channels == 2 || channels >= 4;
  const auto stride = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < picture.pixels(); ++i) {
    const float* from = raw.data() + i * stride;
    float* to = picture.values.data() + i * Picture::kChannels;
    for (std::size_t c = 0; c < 3; ++c) to[c] = from[grey ? 0 : c];
    to[3] = alpha ? from[grey ? 1 : 3] : 1.0f;
  }
}

}  // namespace

double srgb_encoded(double light) {
  const double v = std::clamp(light, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Picture read_picture(const std::filesystem::path& path) {
  OIIO::ImageSpec configuration;
  configuration.attribute("oiio:UnassociatedAlpha", 1);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &configuration);
  if (!input) throw std::runtime_error("cannot read " + path.string() + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) {
    throw std::runtime_error("not a two-dimensional picture: " + path.string());
  }
  Picture picture(spec.width, spec.height);
  std::vector<float> raw(picture.pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, raw.data())) {
    throw std::runtime_error("cannot read " + path.string() + ": " + input->geterror());
  }
  spread(raw, spec.nchannels, picture);
  return picture;
}

void write_picture(const Picture& picture, const std::filesystem::path& path) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path.string());
  if (!output) throw std::runtime_error("cannot write " + path.string() + ": " + OIIO::geterror());
  const bool integer = path.extension() != ".exr";
  OIIO::ImageSpec spec(picture.width, picture.height, 3, integer ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  constexpr OIIO::stride_t kPixelStride = Picture::kChannels * sizeof(float);
  const bool written = output->open(path.string(), spec) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, picture.values.data(), kPixelStride) &&
                       output->close();
  if (!written) throw std::runtime_error("cannot write " + path.string() + ": " + output->geterror());
}

}  // namespace lute::compare
