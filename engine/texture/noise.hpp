// Lattice noise: the three scalar generators, vector noise and turbulence, bit-near to the reference.
// Source: specification chapter 50 §2-3.
#pragma once

#include <cstdint>

#include "engine/math/vec.hpp"

namespace lute {

// hash3 of chapter 50 §2.1: 0...4095.
std::uint32_t hash3(std::int64_t x, std::int64_t y, std::int64_t z);
// Entry `index` of the table of 4096 permuted numbers, index modulo 4096.
std::uint32_t hash_table(std::uint32_t index);
// The table itself, twice over: 8192 entries.
const std::uint16_t* hash_numbers();
// R of chapter 50 §1: MT19937 scaled to [0, 1), index modulo 32768.
double random_table(std::uint32_t index);
// The table itself, long enough for index 32767 + 2.
const double* random_numbers();

// 0...1; generator 1 (original), 2 (range corrected) or 3 (Perlin).
double noise(const dvec3& p, int generator);
// noise() of the point at `count` scales, each twice the one before.
void octaves_of_noise(const dvec3& p, double first_scale, int generator, int count, double* out);
// About -1...1 each component; the same for every generator.
dvec3 vector_noise(const dvec3& p);

struct Turbulence;
double turbulence(const dvec3& p, const Turbulence& t, int generator);
dvec3 vector_turbulence(const dvec3& p, const Turbulence& t);

// sin(2 pi v), the wave of ripples, wood and sine_wave.
double cycle_sine(double v);
// Floor, but one less at negative integers: FL of chapter 50 §1.
double quirk_floor(double v);
// A triangle of period 1: 0 at 0, 1 at 0.5.
double triangle_wave(double v);

}  // namespace lute
