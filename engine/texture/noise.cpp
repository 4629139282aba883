#include "engine/texture/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "engine/math/rounding.hpp"
#include "engine/texture/lattice_noise.hpp"
#include "engine/texture/noise_tables.hpp"
#include "engine/texture/warp.hpp"

namespace lute {
namespace {

// Gradients of the lattice noise (chapter 50 §2.2).
constexpr std::array<double, 267> kGradients = {
    -1, 0.604974, -0.937102, 0.414115, 0.576226, -0.0161593, 0.432334, 0.103685, 0.590539, 0.0286412,
    0.46981, -0.84622, -0.0734112, -0.304097, -0.40206, -0.210132, -0.919127, 0.652033, -0.83151, -0.183948,
    -0.671107, 0.852476, 0.043595, -0.404532, 0.75494, -0.335653, 0.618433, 0.605707, 0.708583, -0.477195,
    0.899474, 0.490623, 0.221729, -0.400381, -0.853727, -0.932586, 0.659113, 0.961303, 0.325948, -0.750851,
    0.842466, 0.734401, -0.649866, 0.394491, -0.466056, -0.434073, 0.109026, 0.0847028, -0.738857, 0.241505,
    0.16228, -0.71426, -0.883665, -0.150408, -0.90396, -0.686549, -0.785214, 0.488548, 0.0246433, 0.142473,
    -0.602136, 0.375845, -0.00779736, 0.498955, -0.268147, 0.856382, -0.386007, -0.596094, -0.867735, -0.570977,
    -0.914366, 0.28896, 0.672206, -0.233783, 0.94815, 0.895262, 0.343252, -0.173388, -0.767971, -0.314748,
    0.824308, -0.342092, 0.721431, -0.24004, -0.63653, 0.553277, 0.376272, 0.158984, -0.452659, 0.396323,
    -0.420676, -0.454154, 0.122179, 0.295857, 0.0664225, -0.202075, -0.724788, 0.453513, 0.224567, -0.908812,
    0.176349, -0.320516, -0.697139, 0.742702, -0.900786, 0.471489, -0.133532, 0.119127, -0.889769, -0.23183,
    -0.669673, -0.046891, -0.803433, -0.966735, 0.475578, -0.652644, 0.0112459, -0.730007, 0.128283, 0.145647,
    -0.619318, 0.272023, 0.392966, 0.646418, -0.0207675, -0.315908, 0.480797, 0.535668, -0.250172, -0.83093,
    -0.653773, -0.443809, 0.119982, -0.897642, 0.89453, 0.165789, 0.633875, -0.886839, 0.930877, -0.537194,
    0.587732, 0.722011, -0.209461, -0.0424659, -0.814267, -0.919432, 0.280262, -0.66302, -0.558099, -0.537469,
    -0.598779, 0.929656, -0.170794, -0.537163, 0.312581, 0.959442, 0.722652, 0.499931, 0.175616, -0.534874,
    -0.685115, 0.444999, 0.17171, 0.108202, -0.768704, -0.463828, 0.254231, 0.546014, 0.869474, 0.875212,
    -0.944427, 0.130724, -0.110185, 0.312184, -0.33138, -0.629206, 0.0606546, 0.722866, -0.0979477, 0.821561,
    0.0931258, -0.972808, 0.0318151, -0.867033, -0.387228, 0.280995, -0.218189, -0.539178, -0.427359, -0.602075,
    0.311971, 0.277974, 0.773159, 0.592493, -0.0331884, -0.630854, -0.269947, 0.339132, 0.581079, 0.209461,
    -0.317433, -0.284993, 0.181323, 0.341634, 0.804959, -0.229572, -0.758907, -0.336721, 0.605463, -0.991272,
    -0.0188754, -0.300191, 0.368307, -0.176135, -0.3832, -0.749569, 0.62356, -0.573938, 0.278309, -0.971313,
    0.839994, -0.830686, 0.439078, 0.66128, 0.694514, 0.0565042, 0.54342, -0.438804, -0.0228428, -0.687068,
    0.857267, 0.301991, -0.494255, -0.941039, 0.775509, 0.410575, -0.362081, -0.671534, -0.348379, 0.932433,
    0.886442, 0.868681, -0.225666, -0.062211, -0.0976425, -0.641444, -0.848112, 0.724697, 0.473503, 0.998749,
    0.174701, 0.559625, -0.029099, -0.337392, -0.958129, -0.659785, 0.236042, -0.246937, 0.659449, -0.027512,
    0.821897, -0.226215, 0.0181735, 0.500481, -0.420127, -0.427878, 0.566186,
};

// The reference's linear congruential generator; `draw` steps it and yields 15 bits.
struct Congruential {
  std::uint32_t state;
  constexpr std::uint32_t draw() {
    state = 1812433253u * state + 12345u;
    return (state >> 16) & 0x7FFFu;
  }
};

// 4096 permuted numbers, twice over so that index + 1 needs no wrapping (chapter 50 §2.1).
constexpr std::array<std::uint16_t, 8192> make_hash_table() {
  std::array<std::uint16_t, 8192> table{};
  for (std::uint32_t i = 0; i < 4096; ++i) table[i] = static_cast<std::uint16_t>(i);
  Congruential random{0};
  for (std::uint32_t i = 4096; i-- > 0;) {
    const std::uint32_t j = random.draw() % 4096;
    const std::uint16_t swapped = table[i];
    table[i] = table[j];
    table[j] = swapped;
  }
  for (std::uint32_t i = 0; i < 4096; ++i) table[4096 + i] = table[i];
  return table;
}
constexpr auto kHash = make_hash_table();

double smooth(double f) { return f * f * (3.0 - 2.0 * f); }

// Perlin's noise with its own tables (chapter 50 §2.4).
struct PerlinTables {
  static constexpr std::uint32_t kSize = 2048;
  std::array<std::uint16_t, 2 * kSize + 2> permutation{};
  std::array<dvec3, 2 * kSize + 2> gradients{};

  PerlinTables() {
    Congruential random{1};
    for (std::uint32_t i = 0; i < kSize; ++i) {
      dvec3 v;
      double length2 = 0;
      do {
        for (int j = 0; j < 3; ++j) v[j] = (static_cast<double>(random.draw() % 4096) - 2048) / 2048;
        length2 = glm::dot(v, v);
      } while (length2 > 1 || length2 < 1e-5);
      gradients[i] = v / std::sqrt(length2);
    }
    for (std::uint32_t i = 0; i < kSize; ++i) permutation[i] = static_cast<std::uint16_t>(i);
    permutation[kSize] = 0;
    for (std::uint32_t i = kSize; i >= 2; i -= 2) std::swap(permutation[i], permutation[random.draw() % kSize]);
    for (std::uint32_t i = 0; i < kSize + 2; ++i) {
      permutation[kSize + i] = permutation[i % kSize];
      gradients[kSize + i] = gradients[i % kSize];
    }
  }
};

double perlin(const dvec3& p) {
  static const PerlinTables tables;
  std::uint32_t b0[3], b1[3];
  double r0[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double t = p[axis] + 10000000.023157213;
    const double n = fast_floor(t);
    b0[axis] = static_cast<std::uint32_t>(cell_number(n)) & 2047u;
    b1[axis] = (b0[axis] + 1) & 2047u;
    r0[axis] = t - n;
  }
  const auto corner = [&](int a, int b, int d) {
    const std::uint32_t i = tables.permutation[a ? b1[0] : b0[0]];
    const std::uint32_t j = tables.permutation[i + (b ? b1[1] : b0[1])];
    const dvec3& g = tables.gradients[j + (d ? b1[2] : b0[2])];
    return g.x * (r0[0] - a) + g.y * (r0[1] - b) + g.z * (r0[2] - d);
  };
  const auto lerp = [](double t, double a, double b) { return a + t * (b - a); };
  const double sx = smooth(r0[0]), sy = smooth(r0[1]), sz = smooth(r0[2]);
  const double near_y0 = lerp(sx, corner(0, 0, 0), corner(1, 0, 0)), near_y1 = lerp(sx, corner(0, 1, 0), corner(1, 1, 0));
  const double far_y0 = lerp(sx, corner(0, 0, 1), corner(1, 0, 1)), far_y1 = lerp(sx, corner(0, 1, 1), corner(1, 1, 1));
  return lerp(sz, lerp(sy, near_y0, near_y1), lerp(sy, far_y0, far_y1));
}

constexpr std::size_t kRandomNumbers = 32768;

}  // namespace

const std::uint16_t* hash_numbers() { return kHash.data(); }

NoiseTables noise_tables() { return {kHash.data(), kGradients.data()}; }

std::uint32_t hash_table(std::uint32_t index) { return kHash[index & 4095u]; }

std::uint32_t hash3(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto low = [](std::int64_t v) { return static_cast<std::uint32_t>(v & 4095); };
  return kHash[kHash[kHash[low(x)] ^ low(y)] ^ low(z)];
}

const double* random_numbers() {
  static const std::vector<double> table = [] {
    std::mt19937 generator;  // default seed 5489
    std::vector<double> values(kRandomNumbers + 2);
    for (std::size_t i = 0; i < kRandomNumbers; ++i) values[i] = static_cast<double>(generator()) / 4294967296.0;
    for (std::size_t i = 0; i < 2; ++i) values[kRandomNumbers + i] = values[i];
    return values;
  }();
  return table.data();
}

double random_table(std::uint32_t index) { return random_numbers()[index & (kRandomNumbers - 1)]; }

double noise(const dvec3& p, int generator) {
  if (generator == 3) return std::clamp(0.5 * (1.59 * perlin(p) + 0.985), 0.0, 1.0);
  return scaled_noise(lattice_sum(p), generator);
}

void octaves_of_noise(const dvec3& p, double first_scale, int generator, int count, double* out) {
  if (generator != 3) return lattice_octaves(p, first_scale, generator, count, out);
  for (int i = 0; i < count; ++i, first_scale *= 2) out[i] = noise(p * first_scale, generator);
}

double turbulence(const dvec3& p, const Turbulence& t, int generator) {
  if (generator != 3) return lattice_turbulence(p, t, generator);
  double value = std::clamp(2 * noise(p, generator) - 0.5, 0.0, 1.0);
  double l = t.lambda, o = t.omega;
  for (int i = 2; i <= t.octaves; ++i) {
    value += o * (2 * noise(p * l, generator) - 0.5);
    l *= t.lambda;
    o *= t.omega;
  }
  return value;
}

namespace {

// The factors of h, h^3, ... in the Taylor series of sin(2 pi h): those that count for h up to 1/4.
constexpr std::array<double, 11> kSineSeries = [] {
  std::array<double, 11> series{};
  double term = 2 * kPi;
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i] = term;
    const auto n = static_cast<double>(2 * i + 2);
    term *= -(2 * kPi) * (2 * kPi) / (n * (n + 1));
  }
  return series;
}();

}  // namespace

// Without a branch, which the quadrants of a pattern would make the processor guess wrong: the cycle is folded into its first quarter
// exactly, and the series is summed up in pairs, so that few terms wait for each other.
double cycle_sine(double v) {
  const double size = std::fabs(v), turned = size - fast_floor(size);
  const double half = std::min(turned, 1 - turned), h = std::min(half, 0.5 - half);
  const std::array<double, 11>& c = kSineSeries;
  const double h2 = h * h, h4 = h2 * h2, h8 = h4 * h4;
  const double low = (c[0] + c[1] * h2) + (c[2] + c[3] * h2) * h4;
  const double middle = (c[4] + c[5] * h2) + (c[6] + c[7] * h2) * h4;
  const double high = (c[8] + c[9] * h2) + c[10] * h4;
  const double sine = h * (low + (middle + high * h8) * h8);
  return std::copysign(sine, 0.5 - turned) * std::copysign(1.0, v);
}

double quirk_floor(double v) { return v >= 0 ? fast_floor(v) : -fast_floor(-v) - 1; }

double triangle_wave(double v) {
  const double o = v >= 0 ? v - fast_floor(v) : v + 1 + fast_floor(std::fabs(v));
  return o >= 0.5 ? 2 * (1 - o) : 2 * o;
}

}  // namespace lute
