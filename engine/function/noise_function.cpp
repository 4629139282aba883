#include "engine/function/noise_function.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {
namespace {

int generator_of(double parameter, int fallback) {
  const int g = static_cast<int>(std::clamp(parameter, -1e9, 1e9)) & 3;
  return g == 0 ? fallback : g;
}

constexpr int kDefaultGenerator = 2;

class Noise3d final : public Function {
 public:
  explicit Noise3d(int generator) : Function(3, 1), generator_(generator) {}
  void evaluate(const double* a, double* results) const override { results[0] = noise({a[0], a[1], a[2]}, generator_); }

 private:
  int generator_;
};

class NoiseGenerator final : public Function {
 public:
  explicit NoiseGenerator(int fallback) : Function(4, 1), fallback_(fallback) {}
  void evaluate(const double* a, double* results) const override {
    results[0] = noise({a[0], a[1], a[2]}, generator_of(a[3], fallback_));
  }

 private:
  int fallback_;
};

class NoPatternGiven final : public Function {
 public:
  NoPatternGiven() : Function(3, 1) {}
  void evaluate(const double*, double* results) const override { results[0] = 0; }
};

// Octaves are bounded: a scene may ask for any number, and each further one adds less than the last bit.
int octave_count(double octaves) { return static_cast<int>(std::clamp(octaves, 0.0, 1000.0)); }

}  // namespace

double hetero_multifractal(const double* a) {
  dvec3 p{a[0], a[1], a[2]};
  const double h = a[3], lambda = a[4], octaves = std::clamp(a[5], 0.0, 1000.0), offset = a[6];
  const int exponent = static_cast<int>(std::clamp(std::floor(a[7]), 0.0, 100.0)), generator = generator_of(a[8], kDefaultGenerator);
  double sum = 2 * noise(p, generator) - 1 + offset;
  p *= lambda;
  const double k = std::pow(lambda, -h);
  double e = k;
  for (int i = 1; i < octaves; ++i) {
    double increment = (2 * noise(p, generator) - 1 + offset) * e;
    for (int j = 0; j < exponent; ++j) increment *= sum;
    sum += increment;
    p *= lambda;
    e *= k;
  }
  if (const double rest = octaves - std::floor(octaves); rest != 0) sum += rest * (2 * noise(p, generator) - 1 + offset) * e * sum;
  return sum;
}

double ridge(const double* a) {
  const dvec3 p{a[0], a[1], a[2]};
  const double lambda = a[3], octaves = std::clamp(a[4], 0.0, 1000.0), omega = a[5], offset = a[6], height = a[7];
  const int generator = generator_of(a[8], kDefaultGenerator);
  const double ridge_scale = 1 / std::max(height, 1 - height), scale = 1 / std::max(offset, 1 - offset);
  const auto n = [&](const dvec3& q) { return std::fabs(noise(q, generator) - height) * ridge_scale - offset; };
  double value = n(p), total = 1, l = lambda, w = omega;
  for (int i = 2; i <= octave_count(octaves); ++i) {
    value += w * n(p * l);
    total += w;
    l *= lambda;
    w *= omega;
  }
  if (const double rest = octaves - std::floor(octaves); rest != 0) {
    value += rest * w * n(p * l);
    total += rest * w;
  }
  return value * scale / total;
}

double ridged_multifractal(const double* a) {
  dvec3 p{a[0], a[1], a[2]};
  const double h = a[3], lambda = a[4], octaves = std::clamp(a[5], 0.0, 1000.0), offset = a[6], gain = a[7];
  const int generator = generator_of(a[8], kDefaultGenerator);
  const auto square = [](double v) { return v * v; };
  const auto n = [&] { return square(offset - std::fabs(2 * noise(p, generator) - 1)); };
  double signal = n(), result = signal;
  for (int i = 1; i < octaves; ++i) {
    p *= lambda;
    signal = n() * std::clamp(signal * gain, 0.0, 1.0);
    result += signal * std::pow(lambda, -i * h);
  }
  return result;
}

FunctionPtr noise_function(int index, int noise_generator) {
  switch (index) {
    case 76: return std::make_shared<Noise3d>(noise_generator);
    case 77: return std::make_shared<NoPatternGiven>();
    case 78: return std::make_shared<NoiseGenerator>(noise_generator);
    default: return nullptr;
  }
}

}  // namespace lute
