#include "engine/shape/slope_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/function/enclosure.hpp"

namespace lute {

SlopeProof::SlopeProof(const Function& function, const Aabb& box, double limit) : box_(box), limit_(limit) {
  const int origin[3] = {0, 0, 0};
  possible_ = prove(function, origin, kSide);
  everywhere_ = possible_ && unproven_.none();
}

Aabb SlopeProof::cell_box(const int first[3], int count) const {
  Aabb cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = (box_.hi[axis] - box_.lo[axis]) / kSide;
    cell.lo[axis] = box_.lo[axis] + side * first[axis];
    cell.hi[axis] = box_.lo[axis] + side * (first[axis] + count);
  }
  return cell;
}

// A bound of the length of the gradient over the cell; negative if the function has no enclosure.
double SlopeProof::steepest(const Function& function, const Aabb& cell) const {
  double sum = 0;
  for (int along = 0; along < 3; ++along) {
    Enclosure arguments[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double slope = axis == along ? 1 : 0;
      arguments[axis] = {cell.lo[axis], cell.hi[axis], slope, slope};
    }
    Enclosure result;
    if (!function.enclose(arguments, result)) return -1;
    sum += result.steepest() * result.steepest();
  }
  return std::sqrt(sum);
}

bool SlopeProof::is_gentle_at_samples(const Function& function, const Aabb& cell) const {
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 p(corner & 1 ? cell.hi.x : cell.lo.x, corner & 2 ? cell.hi.y : cell.lo.y, corner & 4 ? cell.hi.z : cell.lo.z);
    if (!(steepest(function, {p, p}) <= limit_)) return false;
  }
  return true;
}

bool SlopeProof::prove(const Function& function, const int first[3], int count) {
  const Aabb cell = cell_box(first, count);
  const double bound = steepest(function, cell);
  if (bound < 0) return false;
  if (bound <= limit_) return true;
  // Steeper in the middle: much of the cell will be, and looking closer is not worth it.
  const dvec3 middle = cell.center();
  const bool hopeless = count <= kSide / 4 && !(steepest(function, {middle, middle}) <= limit_);
  if (count == 1 && !hopeless && bound <= kBelief * limit_ && is_gentle_at_samples(function, cell)) return true;
  if (count == 1 || hopeless) {
    for (int x = 0; x < count; ++x)
      for (int y = 0; y < count; ++y)
        for (int z = 0; z < count; ++z)
          unproven_.set(static_cast<std::size_t>(((first[0] + x) * kSide + first[1] + y) * kSide + first[2] + z));
    return true;
  }
  const int half = count / 2;
  for (int octant = 0; octant < 8; ++octant) {
    const int part[3] = {first[0] + (octant & 1 ? half : 0), first[1] + (octant & 2 ? half : 0), first[2] + (octant & 4 ? half : 0)};
    if (!prove(function, part, half)) return false;
  }
  return true;
}

void SlopeProof::doubtful(const Ray& ray, Interval depths, std::vector<Interval>& out) const {
  out.clear();
  if (!possible_ || everywhere_) return;
  // From cell to cell (J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987).
  const dvec3 start = ray.at(depths.lo);
  int cell[3], step[3];
  double next[3], stride[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double side = (box_.hi[axis] - box_.lo[axis]) / kSide, d = ray.direction[axis];
    cell[axis] = std::clamp(static_cast<int>((start[axis] - box_.lo[axis]) / side), 0, kSide - 1);
    step[axis] = d < 0 ? -1 : 1;
    stride[axis] = d == 0 ? std::numeric_limits<double>::infinity() : side / std::abs(d);
    const double border = box_.lo[axis] + side * (cell[axis] + (d < 0 ? 0 : 1));
    next[axis] = d == 0 ? std::numeric_limits<double>::infinity() : (border - ray.origin[axis]) / d;
  }
  // Where cells meet, both count: depths are rounded.
  const double slack = 1e-9 * (depths.hi - depths.lo);
  for (double begin = depths.lo;;) {
    const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double end = std::min(next[axis], depths.hi);
    if (unproven_.test(static_cast<std::size_t>((cell[0] * kSide + cell[1]) * kSide + cell[2]))) {
      if (!out.empty() && begin <= out.back().hi + slack)
        out.back().hi = end + slack;
      else
        out.push_back({begin - slack, end + slack});
    }
    cell[axis] += step[axis];
    if (next[axis] >= depths.hi || cell[axis] < 0 || cell[axis] >= kSide) break;
    begin = next[axis];
    next[axis] += stride[axis];
  }
}

}  // namespace lute
