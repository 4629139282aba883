// Whether points lie inside an object: what an object pattern asks. engine/build makes it from the solid it builds.
#pragma once

#include <functional>
#include <memory>

#include "engine/math/vec.hpp"

namespace lute {

struct Object;

class InsideTest {
 public:
  virtual ~InsideTest() = default;
  virtual bool inside(const dvec3& point) const = 0;
};
using InsideTestMaker = std::function<std::shared_ptr<const InsideTest>(const std::shared_ptr<const Object>&)>;

}  // namespace lute
