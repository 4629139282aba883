// A picture as its file stores it: coded values (sRGB for 8-bit files, linear for EXR), four channels, top row first.
//
// Values of integer files are 0…1; a file without alpha has alpha 1; grey files fill all three colours. Alpha is not
// multiplied into the colours when the format stores them apart. Errors: std::runtime_error naming the file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lute::compare {

struct Picture {
  static constexpr int kChannels = 4;

  int width = 0, height = 0;
  std::vector<float> values;  // width · height · 4, RGBA

  Picture() = default;
  Picture(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * kChannels) {}

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  float* at(int x, int y) { return values.data() + offset(x, y); }
  const float* at(int x, int y) const { return values.data() + offset(x, y); }

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * kChannels;
  }
};

// Light 0…1 as sRGB files code it (IEC 61966-2-1); what lies outside is clamped.
double srgb_encoded(double light);

Picture read_picture(const std::filesystem::path& path);

// The colours; the extension chooses the format: single-precision values as they are for .exr, else 8 bits a channel.
void write_picture(const Picture& picture, const std::filesystem::path& path);

}  // namespace lute::compare
