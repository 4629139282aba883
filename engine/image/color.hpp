// Colours: linear RGB in the scene's working space, with POV-Ray's two transparencies. Single precision, never clamped before
// output (specification chapter 40 §1).
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

struct Rgb {
  float r = 0, g = 0, b = 0;

  Rgb() = default;
  constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}
  constexpr explicit Rgb(float grey_value) : r(grey_value), g(grey_value), b(grey_value) {}

  friend constexpr Rgb operator+(Rgb a, Rgb c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend constexpr Rgb operator-(Rgb a, Rgb c) { return {a.r - c.r, a.g - c.g, a.b - c.b}; }
  friend constexpr Rgb operator*(Rgb a, Rgb c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
  friend constexpr Rgb operator*(Rgb a, float s) { return {a.r * s, a.g * s, a.b * s}; }
  friend constexpr Rgb operator*(float s, Rgb a) { return a * s; }
  Rgb& operator+=(Rgb c) { return *this = *this + c; }
  Rgb& operator*=(Rgb c) { return *this = *this * c; }
  Rgb& operator*=(float s) { return *this = *this * s; }
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

// POV-Ray's grey, everywhere with the same weights; summed in double precision where it shades, and in single precision where it
// reads and writes files of greys.
template <class T>
constexpr T weighted_grey(T r, T g, T b) {
  return T(0.297) * r + T(0.589) * g + T(0.114) * b;
}
constexpr float grey(Rgb c) {
  return static_cast<float>(weighted_grey(static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)));
}
constexpr float file_grey(Rgb c) { return weighted_grey(c.r, c.g, c.b); }
constexpr float peak(Rgb c) { return c.r > c.g ? (c.r > c.b ? c.r : c.b) : (c.g > c.b ? c.g : c.b); }

struct Color {
  Rgb rgb;
  float filter = 0;    // light passes multiplied by rgb
  float transmit = 0;  // light passes unchanged

  friend constexpr Color operator+(Color a, Color c) { return {a.rgb + c.rgb, a.filter + c.filter, a.transmit + c.transmit}; }
  friend constexpr Color operator*(Color a, float s) { return {a.rgb * s, a.filter * s, a.transmit * s}; }
  Color& operator+=(Color c) { return *this = *this + c; }
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

// T(c): what a layer of colour c lets through, per channel.
constexpr Rgb pass_through(Color c) { return c.rgb * c.filter + Rgb(c.transmit); }
constexpr float opacity(Color c) { return 1.0f - c.filter - c.transmit; }

}  // namespace lute
