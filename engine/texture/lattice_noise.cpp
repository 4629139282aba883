#include "engine/texture/lattice_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "engine/math/rounding.hpp"
#include "engine/texture/noise_tables.hpp"
#include "engine/texture/warp.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/texture/lattice_noise.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lute::HWY_NAMESPACE {
namespace {

// Four doubles that are worked on at once, in one register or two.
using Four = double __attribute__((vector_size(32)));

// Truncation and fraction as the reference makes them; beyond 32 bits the lattice is meaningless, but must not be undefined.
struct Lattice {
  std::uint32_t cell;
  double fraction;
  explicit HWY_INLINE Lattice(double c) {
    const double shifted = c - (c < 0 ? 1 - kEpsilon : 0);
    std::int64_t i = 0;
    if (std::fabs(shifted) < kAllIntegers) {
      i = static_cast<std::int64_t>(shifted);
      fraction = c - static_cast<double>(i);
    } else {
      i = cell_number(shifted);
      fraction = c - shifted;
    }
    cell = static_cast<std::uint32_t>(i + 10000) & 4095u;
  }
  HWY_INLINE double smooth() const { return fraction * fraction * (3.0 - 2.0 * fraction); }
};

constexpr std::size_t kCorners = 8;

// The corners of a point's cell, x first, z last. A corner's term is the sum of four numbers of the gradients' table times
// 1/2 and the three distances from the corner, all times its weight.
struct Cell {
  const double* gradient[kCorners];
  double weight[kCorners];
  Four half_and_fractions;

  HWY_INLINE Cell(const dvec3& p, const NoiseTables& tables) {
    const Lattice x(p.x), y(p.y), z(p.z);
    const std::uint16_t* const hash = tables.hash;
    const double* const numbers = tables.gradients;
    const std::uint32_t x0 = hash[x.cell], x1 = hash[x.cell + 1], y1 = y.cell + 1, z1 = z.cell + 1;
    const std::uint32_t h00 = hash[x0 ^ y.cell], h10 = hash[x1 ^ y.cell], h01 = hash[x0 ^ y1], h11 = hash[x1 ^ y1];
    gradient[0] = numbers + (hash[h00 ^ z.cell] & 255u);
    gradient[1] = numbers + (hash[h10 ^ z.cell] & 255u);
    gradient[2] = numbers + (hash[h01 ^ z.cell] & 255u);
    gradient[3] = numbers + (hash[h11 ^ z.cell] & 255u);
    gradient[4] = numbers + (hash[h00 ^ z1] & 255u);
    gradient[5] = numbers + (hash[h10 ^ z1] & 255u);
    gradient[6] = numbers + (hash[h01 ^ z1] & 255u);
    gradient[7] = numbers + (hash[h11 ^ z1] & 255u);

    half_and_fractions = Four{0.5, x.fraction, y.fraction, z.fraction};
    const double sx = x.smooth(), sy = y.smooth(), sz = z.smooth(), tx = 1 - sx, ty = 1 - sy, tz = 1 - sz;
    const double near = tx * ty, right = sx * ty, up = tx * sy, both = sx * sy;
    weight[0] = near * tz;
    weight[1] = right * tz;
    weight[2] = up * tz;
    weight[3] = both * tz;
    weight[4] = near * sz;
    weight[5] = right * sz;
    weight[6] = up * sz;
    weight[7] = both * sz;
  }

  // What the gradient's four numbers are multiplied by.
  HWY_INLINE void factors(std::size_t corner, Four& out) const {
    constexpr Four kCorner[kCorners] = {{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0},
                                        {0, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 1, 1, 1}};
    out = (half_and_fractions - kCorner[corner]) * weight[corner];
  }
};

HWY_INLINE void load(const double* numbers, Four& out) { std::memcpy(&out, numbers, sizeof out); }

HWY_INLINE double total(const Four& sum) { return (sum[0] + sum[2]) + (sum[1] + sum[3]); }

// Written out by fold expressions, so that the corners' numbers stay in registers.
using Corners = std::make_index_sequence<kCorners>;

HWY_INLINE void add_corner(const Cell& cell, std::size_t corner, Four& sum) {
  Four factors, numbers;
  cell.factors(corner, factors);
  load(cell.gradient[corner], numbers);
  sum += factors * numbers;
}

template <std::size_t... corner>
HWY_INLINE double noise_sum(const dvec3& p, const NoiseTables& tables, std::index_sequence<corner...>) {
  const Cell cell(p, tables);
  Four near{0, 0, 0, 0}, far{0, 0, 0, 0};
  (add_corner(cell, corner, corner < kCorners / 2 ? near : far), ...);
  return total(near + far);
}

// The four parts of three sums, still apart.
struct VectorSum {
  Four x{0, 0, 0, 0}, y{0, 0, 0, 0}, z{0, 0, 0, 0};

  HWY_INLINE void add_corner(const Cell& cell, std::size_t corner) {
    Four factors, gx, gy, gz;
    cell.factors(corner, factors);
    const double* numbers = cell.gradient[corner];
    load(numbers, gx);
    load(numbers + 4, gy);
    load(numbers + 8, gz);
    x += factors * gx;
    y += factors * gy;
    z += factors * gz;
  }

  template <std::size_t... corner>
  HWY_INLINE void add_noise(const dvec3& p, const NoiseTables& tables, std::index_sequence<corner...>) {
    const Cell cell(p, tables);
    (add_corner(cell, corner), ...);
  }

  HWY_INLINE void add(const VectorSum& other, double amount) {
    x += amount * other.x;
    y += amount * other.y;
    z += amount * other.z;
  }

  HWY_INLINE dvec3 totals() const { return {total(x), total(y), total(z)}; }
};

double sum(const dvec3& p) { return noise_sum(p, noise_tables(), Corners()); }

void octaves(const dvec3& p, double scale, int generator, int count, double* out) {
  const NoiseTables tables = noise_tables();
  for (int i = 0; i < count; ++i, scale *= 2) out[i] = scaled_noise(noise_sum(p * scale, tables, Corners()), generator);
}

void vector_noise(const dvec3& p, dvec3& out) {
  const NoiseTables tables = noise_tables();
  VectorSum noise;
  noise.add_noise(p, tables, Corners());
  out = noise.totals();
}

double turbulence(const dvec3& p, const Turbulence& t, int generator) {
  const NoiseTables tables = noise_tables();
  double value = scaled_noise(noise_sum(p, tables, Corners()), generator);
  if (generator > 1) value = std::clamp(2 * value - 0.5, 0.0, 1.0);
  double l = t.lambda, o = t.omega;
  for (int i = 2; i <= t.octaves; ++i) {
    const double n = scaled_noise(noise_sum(p * l, tables, Corners()), generator);
    value += generator > 1 ? o * (2 * n - 0.5) : o * n;
    l *= t.lambda;
    o *= t.omega;
  }
  return value;
}

void vector_turbulence(const dvec3& p, const Turbulence& t, dvec3& out) {
  const NoiseTables tables = noise_tables();
  VectorSum noise;
  noise.add_noise(p, tables, Corners());
  double l = t.lambda, o = t.omega;
  for (int i = 2; i <= t.octaves; ++i) {
    VectorSum octave;
    octave.add_noise(p * l, tables, Corners());
    noise.add(octave, o);
    l *= t.lambda;
    o *= t.omega;
  }
  out = noise.totals();
}

}  // namespace
}  // namespace lute::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lute {
namespace {

HWY_EXPORT(sum);
HWY_EXPORT(octaves);
HWY_EXPORT(vector_noise);
HWY_EXPORT(turbulence);
HWY_EXPORT(vector_turbulence);

}  // namespace

double lattice_sum(const dvec3& p) { return HWY_DYNAMIC_DISPATCH(sum)(p); }

void lattice_octaves(const dvec3& p, double first_scale, int generator, int count, double* out) {
  HWY_DYNAMIC_DISPATCH(octaves)(p, first_scale, generator, count, out);
}

double lattice_turbulence(const dvec3& p, const Turbulence& t, int generator) {
  return HWY_DYNAMIC_DISPATCH(turbulence)(p, t, generator);
}

dvec3 vector_noise(const dvec3& p) {
  dvec3 result;
  HWY_DYNAMIC_DISPATCH(vector_noise)(p, result);
  return result;
}

dvec3 vector_turbulence(const dvec3& p, const Turbulence& t) {
  dvec3 result;
  HWY_DYNAMIC_DISPATCH(vector_turbulence)(p, t, result);
  return result;
}

}  // namespace lute
#endif
