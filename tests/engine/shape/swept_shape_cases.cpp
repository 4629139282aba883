// Swept shapes: lathes, surfaces of revolution, prisms, sweeps, text.
#include <algorithm>
#include <cmath>
#include <limits>

#include "shape_case_parts.hpp"
#include "tests/file_text.hpp"

namespace lute::test {
namespace {

ShapeCase ovus(std::string name, double bottom, double top) {
  return {std::move(name), maker(Ovus{bottom, top}), bottom + top, {0, bottom / 2, 0}};
}

// The sphere of a sweep's spline at a parameter: centre and radius.
dvec4 sweep_ball(const SphereSweep& s, double at) {
  const bool linear = s.spline == SphereSweep::Spline::kLinear;
  const std::size_t segments = s.balls.size() - (linear ? 1 : 3);
  const std::size_t i = std::min(static_cast<std::size_t>(at), segments - 1);
  const double u = at - static_cast<double>(i);
  const auto ball = [&](std::size_t k) { return dvec4(s.balls[i + k].center, s.balls[i + k].radius); };
  if (linear) return ball(0) + u * (ball(1) - ball(0));
  const dvec4 p0 = ball(0), p1 = ball(1), p2 = ball(2), p3 = ball(3);
  if (s.spline == SphereSweep::Spline::kBSpline)
    return (p0 + 4.0 * p1 + p2 + 3.0 * u * (p2 - p0) + 3.0 * u * u * (p0 - 2.0 * p1 + p2) + u * u * u * (p3 - p0 + 3.0 * (p1 - p2))) / 6.0;
  return p1 + 0.5 * (u * (p2 - p0) + u * u * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) + u * u * u * (p3 - p0 + 3.0 * (p1 - p2)));
}

// A hit lies on one of the spheres, but splines also show parts of spheres that others cover (specification chapter 20 §5.14).
ShapeCase sweep(std::string name, SphereSweep::Spline spline) {
  SphereSweep s;
  s.spline = spline;
  s.balls = {{{-1.2, -0.6, 0}, 0.2}, {{-0.6, 0.3, 0.1}, 0.3}, {{0, -0.3, -0.2}, 0.25}, {{0.6, 0.4, 0}, 0.2}, {{1.2, 0.3, 0.2}, 0.3}};
  ShapeCase c{std::move(name), maker(s), 1.2};
  if (spline == SphereSweep::Spline::kLinear) return c;
  c.parity = false;
  c.own_normals = true;
  c.distance = [s](const dvec3& p) {
    const auto outside = [&](double at) {
      const dvec4 ball = sweep_ball(s, at);
      return glm::length(p - dvec3(ball)) - ball.w;
    };
    constexpr int kSteps = 400;
    const double step = static_cast<double>(s.balls.size() - 3) / kSteps;
    double least = std::numeric_limits<double>::infinity();
    int nearest = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double here = outside(i * step);
      if (i > 0 && (here < 0) != (outside((i - 1) * step) < 0)) return 0.0;  // a sphere in between passes through the point
      if (std::abs(here) < least) {
        least = std::abs(here);
        nearest = i;
      }
    }
    // The point is on the envelope: the least distance lies next to the best step.
    double lo = std::max(0, nearest - 1) * step, hi = std::min(kSteps, nearest + 1) * step;
    for (int i = 0; i < 100; ++i) {
      const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
      (std::abs(outside(a)) < std::abs(outside(b)) ? hi : lo) = std::abs(outside(a)) < std::abs(outside(b)) ? b : a;
    }
    return std::abs(outside(0.5 * (lo + hi)));
  };
  return c;
}

}  // namespace

void add_swept_shapes(std::vector<ShapeCase>& cases) {
  cases.push_back({"sor", maker(Sor{{{0, -1.2}, {0.5, -0.9}, {0.7, -0.4}, {0.25, 0.2}, {0.4, 0.7}, {0.45, 0.9}, {0.4, 1}}})});
  const std::vector<dvec2> closed_profile{{0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}};
  cases.push_back({"lathe_linear", maker(Lathe{PlanarSpline::kLinear, closed_profile})});
  cases.push_back({"lathe_quadratic", maker(Lathe{PlanarSpline::kQuadratic, {{0.3, -1.3}, {0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}}})});
  cases.push_back({"lathe_cubic", maker(Lathe{PlanarSpline::kCubic, {{0, -1.3}, {0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}, {0, 1.2}}})});
  cases.push_back({"lathe_bezier", maker(Lathe{PlanarSpline::kBezier, {{0, -1}, {0.9, -1}, {0.9, -0.2}, {0.3, 0}, {0.3, 0}, {0.1, 0.4}, {0.8, 0.6}, {0, 0.9}}, true})});
  const std::vector<dvec2> outline{{-0.6, -0.6}, {0.6, -0.6}, {0.8, 0.3}, {0, 0.9}, {-0.8, 0.3}, {-0.6, -0.6}, {-0.3, -0.3}, {0.2, -0.3}, {0.1, 0.3}, {-0.3, -0.3}};
  cases.push_back({"prism_linear", maker(Prism{PlanarSpline::kLinear, false, -0.5, 0.6, outline})});
  cases.push_back({"prism_conic", maker(Prism{PlanarSpline::kLinear, true, 0.2, 0.9, outline}), 1, {0, 0.5, 0}});
  cases.push_back({"prism_quadratic", maker(Prism{PlanarSpline::kQuadratic, false, -0.5, 0.6, {{-1, 0}, {0, -1}, {1.1, -0.2}, {0.5, 0.9}, {-0.8, 0.6}, {0, -1}}})});
  cases.push_back({"prism_cubic", maker(Prism{PlanarSpline::kCubic, false, -0.5, 0.6,
                                              {{-0.9, 0.9}, {-1, -0.8}, {0.2, -1.1}, {1.1, -0.6}, {0.8, 0.8}, {-0.9, 0.9}, {-1, -0.8}, {0.2, -1.1}}})});
  cases.push_back({"prism_bezier", maker(Prism{PlanarSpline::kBezier, false, -0.5, 0.6,
                                               {{-1, 0}, {-1, -0.9}, {0.8, -1}, {0.9, 0.1}, {0.9, 0.1}, {0.7, 1}, {-1, 1.1}, {-1, 0}}})});
  // Outlines that overlap: where they do, even and odd alternate.
  cases.push_back({"prism_overlapping", maker(Prism{PlanarSpline::kLinear, false, -0.5, 0.6,
      {{-0.8, -0.7}, {0.4, -0.8}, {0.3, 0.5}, {-0.8, -0.7}, {-0.4, -0.4}, {0.9, -0.3}, {0, 0.9}, {-0.4, -0.4}, {0, -0.2}, {0.2, -0.2}, {0.1, 0.1}, {0, -0.2}}})});
  cases.push_back({"prism_bezier_outlines", maker(Prism{PlanarSpline::kBezier, false, -0.5, 0.6,
      {{-1, 0}, {-1, -0.9}, {0.8, -1}, {0.9, 0.1}, {0.9, 0.1}, {0.7, 1}, {-1, 1.1}, {-1, 0}, {-0.3, 0}, {-0.3, -0.5}, {0.4, -0.5}, {0.4, 0}, {0.4, 0}, {0.4, 0.5}, {-0.3, 0.5}, {-0.3, 0}}})});
  cases.push_back(ovus("ovus_slim", 0.7, 0.3));
  cases.push_back(ovus("ovus_stout", 0.5, 0.6));
  cases.push_back(sweep("sphere_sweep_linear", SphereSweep::Spline::kLinear));
  cases.push_back(sweep("sphere_sweep_cubic", SphereSweep::Spline::kCubic));
  cases.push_back(sweep("sphere_sweep_b_spline", SphereSweep::Spline::kBSpline));
  const std::string font = file_text("/usr/share/povray-3.7/include/timrom.ttf");
  if (font.empty()) return;  // povray-includes is not installed
  cases.push_back({"text", maker(Text{std::make_shared<const std::string>(font), u"Bg8", 0.5, dvec3(0)}), 0.8, {0.7, 0.3, 0.2}});
}

}  // namespace lute::test
