// lathe, sor, prism, sphere_sweep.
#include <cmath>
#include <optional>
#include <string>

#include "parser/statement/curved_shape.hpp"

namespace lute {

namespace {

std::optional<PlanarSpline> accept_spline(Reader& reader) {
  if (reader.accept(Word::kLinearSpline)) return PlanarSpline::kLinear;
  if (reader.accept(Word::kQuadraticSpline)) return PlanarSpline::kQuadratic;
  if (reader.accept(Word::kCubicSpline)) return PlanarSpline::kCubic;
  if (reader.accept(Word::kBezierSpline)) return PlanarSpline::kBezier;
  return std::nullopt;
}

// `count {,? <x, y>}`
std::vector<dvec2> parse_points(Reader& reader, int count) {
  std::vector<dvec2> points;
  for (int i = 0; i < count; ++i) {
    reader.comma();
    points.push_back(reader.vector2());
  }
  return points;
}

}  // namespace

Lathe parse_lathe(Reader& reader) {
  Lathe lathe;
  while (const auto spline = accept_spline(reader)) lathe.spline = *spline;
  const int count = reader.integer();
  const int least = static_cast<int>(least_points(lathe.spline));
  switch (lathe.spline) {  // in the words of the reference, which is not always sure of what it reads
    case PlanarSpline::kLinear:
      if (count < least) reader.error("Lathe with linear splines must have at least two points.");
      break;
    case PlanarSpline::kQuadratic:
      if (count < least) reader.error("Lathe with quadratic splines must have at least three points.");
      break;
    case PlanarSpline::kCubic:
      if (count < least) reader.error("Prism with cubic splines must have at least four points.");
      break;
    case PlanarSpline::kBezier:
      if (count < least || count % 4 != 0) reader.error("Lathe with Bezier splines must have four points per segment.");
      break;
  }
  lathe.points = parse_points(reader, count);
  for (std::size_t i = 1; i + 1 < lathe.points.size(); ++i)
    if (lathe.points[i].x < 0) reader.error("Incorrect point in lathe.");
  return lathe;
}

Sor parse_sor(Reader& reader) {
  Sor sor;
  const int count = reader.integer();
  if (count < 4) reader.error("Surface of revolution must have at least four points.");
  sor.points = parse_points(reader, count);
  const std::vector<dvec2>& p = sor.points;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool descends = i >= 2 && i + 1 < p.size() && p[i].y <= p[i - 1].y;
    const bool flat = i >= 2 && std::abs(p[i].y - p[i - 2].y) < kEpsilon;
    if (p[i].x < 0 || descends || flat) reader.error("Incorrect point in surface of revolution.");
  }
  sor.open = reader.accept(Word::kOpen);
  return sor;
}

Prism parse_prism(Reader& reader) {
  Prism prism;
  while (true) {
    if (const auto spline = accept_spline(reader)) {
      prism.spline = *spline;
    } else if (reader.accept(Word::kLinearSweep)) {
      prism.conic = false;
    } else if (reader.accept(Word::kConicSweep)) {
      prism.conic = true;
    } else {
      break;
    }
  }
  prism.height_1 = reader.number();
  reader.comma();
  prism.height_2 = reader.number();
  reader.comma();
  const int count = reader.integer();
  switch (prism.spline) {
    case PlanarSpline::kLinear:
      if (count < 3) reader.error("Prism with linear splines must have at least three points.");
      break;
    case PlanarSpline::kQuadratic:
      if (count < 5) reader.error("Prism with quadratic splines must have at least five points.");
      break;
    case PlanarSpline::kCubic:
      if (count < 6) reader.error("Prism with cubic splines must have at least six points.");
      break;
    case PlanarSpline::kBezier:
      if (count < 4 || count % 4 != 0) reader.error("Prism with Bezier splines must have four points per segment.");
      break;
  }
  prism.points = parse_points(reader, count);
  prism.open = reader.accept(Word::kOpen);
  if (!prism_outline(prism).closed) {
    const bool linear = prism.spline == PlanarSpline::kLinear;
    reader.warning(linear ? "Linear prism not closed. Closing it." : "Prism not closed. Ignoring it.");
    if (prism.spline == PlanarSpline::kQuadratic || prism.spline == PlanarSpline::kCubic) reader.error("Too few points in prism.");
  }
  return prism;
}

SphereSweep parse_sphere_sweep(Reader& reader) {
  SphereSweep sweep;
  if (reader.accept(Word::kLinearSpline)) {
    sweep.spline = SphereSweep::Spline::kLinear;
  } else if (reader.accept(Word::kCubicSpline)) {
    sweep.spline = SphereSweep::Spline::kCubic;
  } else if (reader.accept(Word::kBSpline)) {
    sweep.spline = SphereSweep::Spline::kBSpline;
  } else {
    reader.error("Invalid type of interpolation.");
  }
  reader.comma();
  const int count = reader.integer();
  if (count < (sweep.spline == SphereSweep::Spline::kLinear ? 2 : 4))
    reader.error("Too few modeling spheres for interpolation type.");
  for (int i = 0; i < count; ++i) {
    reader.comma();
    SphereSweep::Ball ball;
    ball.center = reader.vector();
    reader.comma();
    ball.radius = reader.number();
    sweep.balls.push_back(ball);
  }
  if (reader.accept(Word::kTolerance)) sweep.tolerance = reader.number();
  return sweep;
}

}  // namespace lute
