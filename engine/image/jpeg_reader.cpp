#include "engine/image/jpeg_reader.hpp"

#include <cstdio>

#include <jpeglib.h>

#include <array>
#include <memory>
#include <stdexcept>

namespace lute {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// libjpeg's errors are exceptions; what it only warns of (a file that ends early) is no error.
[[noreturn]] void fail(j_common_ptr state) {
  std::array<char, JMSG_LENGTH_MAX> message{};
  state->err->format_message(state, message.data());
  throw std::runtime_error(message.data());
}

class Decompression {
 public:
  Decompression() {
    state.err = jpeg_std_error(&errors_);
    errors_.error_exit = fail;
    errors_.output_message = [](j_common_ptr) {};
    jpeg_create_decompress(&state);
  }
  ~Decompression() { jpeg_destroy_decompress(&state); }
  Decompression(const Decompression&) = delete;
  Decompression& operator=(const Decompression&) = delete;

  jpeg_decompress_struct state{};

 private:
  jpeg_error_mgr errors_{};
};

// Four inks as three colours. Files of Adobe's programs, which are nearly all, store them inverted.
std::vector<std::uint8_t> rgb_of_inks(const std::vector<std::uint8_t>& inks, bool inverted) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(inks.size() / 4 * 3);
  for (std::size_t i = 0; i + 3 < inks.size(); i += 4) {
    const int black = inverted ? inks[i + 3] : 255 - inks[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const int light = inverted ? inks[i + c] : 255 - inks[i + c];
      rgb.push_back(static_cast<std::uint8_t>((light * black + 127) / 255));
    }
  }
  return rgb;
}

void decode(std::FILE* file, JpegContent& content) {
  Decompression jpeg;
  jpeg_stdio_src(&jpeg.state, file);
  jpeg_read_header(&jpeg.state, TRUE);
  const bool inks = jpeg.state.num_components == 4;
  jpeg.state.out_color_space = inks ? JCS_CMYK : jpeg.state.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_start_decompress(&jpeg.state);
  content.width = static_cast<int>(jpeg.state.output_width);
  content.height = static_cast<int>(jpeg.state.output_height);
  content.channels = jpeg.state.output_components;
  const std::size_t row_size = std::size_t{jpeg.state.output_width} * static_cast<std::size_t>(content.channels);
  content.bytes.resize(row_size * jpeg.state.output_height);
  while (jpeg.state.output_scanline < jpeg.state.output_height) {
    JSAMPROW row = content.bytes.data() + row_size * jpeg.state.output_scanline;
    jpeg_read_scanlines(&jpeg.state, &row, 1);
  }
  jpeg_finish_decompress(&jpeg.state);
  if (inks) {
    content.bytes = rgb_of_inks(content.bytes, jpeg.state.saw_Adobe_marker != 0);
    content.channels = 3;
  }
}

}  // namespace

bool read_jpeg(const std::string& path, JpegContent& content, std::string& error) {
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) {
    error = "Cannot open '" + path + "'.";
    return false;
  }
  try {
    decode(file.get(), content);
    return true;
  } catch (const std::exception& failure) {
    error = "Cannot read JPEG image '" + path + "': " + failure.what() + ".";
    return false;
  }
}

}  // namespace lute
