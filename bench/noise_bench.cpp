// Noise points per second: the engine's, which adds four lanes at once, beside the formula of specification chapter 50 §2.3 as it is
// written, corner by corner and number by number.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>

#include "engine/texture/noise.hpp"
#include "engine/texture/noise_tables.hpp"
#include "engine/texture/pattern/feature_points.hpp"
#include "engine/texture/warp.hpp"

namespace lute {
namespace {

// A walk through many cells, no two steps of which see the same place.
class Walk {
 public:
  dvec3 next() {
    at_ += dvec3(0.01371, -0.00717, 0.0233);
    return at_;
  }

 private:
  dvec3 at_{0.1, 0.2, 0.3};
};

struct Axis {
  std::uint32_t cell;
  double fraction;
  explicit Axis(double c) {
    const double whole = std::trunc(c >= 0 ? c : c - (1 - 1e-10));
    fraction = c - whole;
    cell = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole) + 10000) & 4095u;
  }
  double weight(std::uint32_t bit) const {
    const double s = fraction * fraction * (3 - 2 * fraction);
    return bit != 0 ? s : 1 - s;
  }
};

double noise_by_formula(const dvec3& p) {
  const std::uint16_t* hash = noise_tables().hash;
  const double* table = noise_tables().gradients;
  const Axis x(p.x), y(p.y), z(p.z);
  double sum = 0;
  for (std::uint32_t a = 0; a < 2; ++a)
    for (std::uint32_t b = 0; b < 2; ++b)
      for (std::uint32_t d = 0; d < 2; ++d) {
        const std::uint32_t k = hash[hash[hash[x.cell + a] ^ (y.cell + b)] ^ (z.cell + d)] & 255u;
        const double g = 0.5 * table[k] + table[k + 1] * (x.fraction - a) + table[k + 2] * (y.fraction - b) + table[k + 3] * (z.fraction - d);
        sum += x.weight(a) * y.weight(b) * z.weight(d) * g;
      }
  return std::fmin(std::fmax((sum + 1.05242) * 0.48985582, 0.0), 1.0);
}

template <class Evaluate>
void run(benchmark::State& state, const Evaluate& evaluate) {
  Walk walk;
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(walk.next()));
  state.SetItemsProcessed(state.iterations());
}

void noise_as_written(benchmark::State& state) { run(state, [](const dvec3& p) { return noise_by_formula(p); }); }
BENCHMARK(noise_as_written);

void noise_generator(benchmark::State& state) {
  run(state, [generator = static_cast<int>(state.range(0))](const dvec3& p) { return noise(p, generator); });
}
BENCHMARK(noise_generator)->Arg(1)->Arg(2)->Arg(3);

void noise_of_vectors(benchmark::State& state) { run(state, [](const dvec3& p) { return vector_noise(p); }); }
BENCHMARK(noise_of_vectors);

void turbulence_of_six_octaves(benchmark::State& state) { run(state, [](const dvec3& p) { return turbulence(p, Turbulence{}, 2); }); }
BENCHMARK(turbulence_of_six_octaves);

// Neighbouring pixels: a hundred points on a line of one cube's length; the argument is twice the metric.
void crackle_of_neighbours(benchmark::State& state) {
  const double metric = static_cast<double>(state.range(0)) / 2;
  int i = 0;
  for (auto _ : state) {
    i = (i + 1) % 10000;
    benchmark::DoNotOptimize(crackle_points({0.01 * (i % 100), 0.01 * i / 100, 0.3}, metric, 2));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(crackle_of_neighbours)->Arg(2)->Arg(4)->Arg(5)->Arg(6);

}  // namespace
}  // namespace lute
