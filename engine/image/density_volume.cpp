#include "engine/image/density_volume.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

namespace lute {

std::shared_ptr<const DensityVolume> DensityVolume::load(const std::string& path, std::string& error) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    error = "Cannot open density file '" + path + "'.";
    return nullptr;
  }
  return parse({std::istreambuf_iterator<char>(file), {}}, error);
}

std::shared_ptr<const DensityVolume> DensityVolume::parse(const std::vector<std::uint8_t>& content, std::string& error) {
  auto volume = std::make_shared<DensityVolume>();
  if (content.size() >= 6) {
    std::uint64_t voxels = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      volume->size_[axis] = content[2 * axis] * std::uint64_t{256} + content[2 * axis + 1];
      voxels *= volume->size_[axis];
    }
    const std::uint64_t bytes = content.size() - 6;
    for (const int each : {4, 2, 1})
      if (voxels != 0 && bytes == voxels * static_cast<std::uint64_t>(each)) {
        volume->bytes_per_voxel_ = each;
        volume->data_.assign(content.begin() + 6, content.end());
        return volume;
      }
  }
  error = "Invalid density file size";
  return nullptr;
}

double DensityVolume::voxel(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
  const auto bytes = static_cast<std::size_t>(bytes_per_voxel_);
  const std::uint8_t* p = &data_[((z * size_[1] + y) * size_[0] + x) * bytes];
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | p[i];
  return static_cast<double>(value) / (bytes == 4 ? 4294967295.0 : bytes == 2 ? 65535.0 : 255.0);
}

double DensityVolume::at(const dvec3& p, Interpolation interpolation) const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= 0 && p[axis] < 1)) return 0;
  const dvec3 scaled{p.x * static_cast<double>(size_[0]), p.y * static_cast<double>(size_[1]), p.z * static_cast<double>(size_[2])};
  switch (interpolation) {
    case Interpolation::kLinear: return linear(scaled);
    case Interpolation::kCubic: return cubic(scaled);
    case Interpolation::kNone: break;
  }
  // A coordinate just below 1 may round up to the size.
  const auto index = [&](int axis) {
    const auto i = static_cast<std::uint64_t>(scaled[axis]), size = size_[static_cast<std::size_t>(axis)];
    return i < size ? i : size - 1;
  };
  return voxel(index(0), index(1), index(2));
}

double DensityVolume::linear(const dvec3& s) const {
  std::uint64_t lo[3], hi[3];
  double t[3];
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t size = size_[static_cast<std::size_t>(axis)], i = static_cast<std::uint64_t>(s[axis]);
    t[axis] = s[axis] - static_cast<double>(i);
    lo[axis] = i % size;
    hi[axis] = (i + 1) % size;
  }
  const auto along_x = [&](std::uint64_t y, std::uint64_t z) {
    return voxel(lo[0], y, z) * (1 - t[0]) + voxel(hi[0], y, z) * t[0];
  };
  const auto along_y = [&](std::uint64_t z) { return along_x(lo[1], z) * (1 - t[1]) + along_x(hi[1], z) * t[1]; };
  return along_y(lo[2]) * (1 - t[2]) + along_y(hi[2]) * t[2];
}

double DensityVolume::cubic(const dvec3& s) const {
  // The index before the first wraps as an unsigned number, as the reference has it: only sizes that are powers of two wrap to
  // the far side.
  std::uint64_t index[3][4];
  float t[3];
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t size = size_[static_cast<std::size_t>(axis)], i = static_cast<std::uint64_t>(s[axis]);
    t[axis] = static_cast<float>(s[axis] - static_cast<double>(i));
    for (std::uint64_t k = 0; k < 4; ++k) index[axis][k] = (i - 1 + k) % size;
  }
  const auto curve = [](float at, float a, float b, float c, float d) {
    const float m = (c - a) / 2, n = (d - b) / 2;
    const float e = 2 * (b - c) + m + n, f = -3 * (b - c) - 2 * m - n;
    return ((e * at + f) * at + m) * at + b;
  };
  float plane[4], row[4], column[4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) column[k] = static_cast<float>(voxel(index[0][i], index[1][j], index[2][k]));
      row[j] = curve(t[2], column[0], column[1], column[2], column[3]);
    }
    plane[i] = curve(t[1], row[0], row[1], row[2], row[3]);
  }
  const double value = static_cast<double>(curve(t[0], plane[0], plane[1], plane[2], plane[3]));
  return value < 0 ? 0 : value;
}

}  // namespace lute
