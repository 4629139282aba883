// What gives the colour of an image position: a scene seen through its camera, or in tests any function.
//
// Positions are in pixels, (0, 0) the centre of the top left one; they may be fractional and may lie outside of the
// image. The colour must depend on the position alone. A source may keep scratch memory and counters, so every thread
// makes its own.
#pragma once

#include <functional>
#include <memory>

#include "engine/accel/counters.hpp"
#include "engine/image/color.hpp"
#include "engine/math/vec.hpp"

namespace lute {

class PixelSource {
 public:
  virtual ~PixelSource() = default;
  virtual Color sample(dvec2 position) = 0;
  virtual Counters counters() const { return {}; }
};

// Called once for each thread, possibly at the same time.
using MakePixelSource = std::function<std::unique_ptr<PixelSource>()>;

}  // namespace lute
