// A df3 file: a block of densities over the unit cube (specification chapter 50 §6.5).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/math/vec.hpp"

namespace lute {

class DensityVolume {
 public:
  // Null, with `error` set, when the file cannot be read or has no valid size.
  static std::shared_ptr<const DensityVolume> load(const std::string& path, std::string& error);
  static std::shared_ptr<const DensityVolume> parse(const std::vector<std::uint8_t>& content, std::string& error);

  enum class Interpolation : std::uint8_t { kNone, kLinear, kCubic };
  double at(const dvec3& point, Interpolation interpolation) const;  // 0 outside the unit cube

 private:
  double voxel(std::uint64_t x, std::uint64_t y, std::uint64_t z) const;
  double linear(const dvec3& scaled) const;
  double cubic(const dvec3& scaled) const;

  std::array<std::uint64_t, 3> size_{};
  int bytes_per_voxel_ = 1;
  std::vector<std::uint8_t> data_;  // as in the file: big-endian, x fastest
};

}  // namespace lute
