#include "parser/value/spline.hpp"

#include <algorithm>

namespace lute {

namespace {

// Lays `f` over all five components.
template <class F>
Spline::Point each(F&& f) {
  Spline::Point result{};
  for (std::size_t k = 0; k < 5; ++k) result[k] = f(k);
  return result;
}

}  // namespace

void Spline::insert(double t, const Point& value) {
  const auto at = std::lower_bound(times_.begin(), times_.end(), t);
  const auto index = at - times_.begin();
  if (at != times_.end() && *at == t) {
    // A second value replaces the first, but not that of the last of several times.
    if (at + 1 != times_.end() || times_.size() == 1) values_[static_cast<std::size_t>(index)] = value;
    return;
  }
  times_.insert(at, t);
  values_.insert(values_.begin() + index, value);
}

Spline::Point Spline::evaluate(double t, SplineKind kind_for_this_call) const {
  if (times_.empty()) return {};
  if (times_.size() == 1) return values_[0];
  if (kind_for_this_call == SplineKind::kCubic) return cubic(t);
  if (!(t > times_.front())) return values_.front();
  if (!(t < times_.back())) return values_.back();
  const auto segment = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), t) - times_.begin()) - 1;
  if (times_.size() == 2 || kind_for_this_call == SplineKind::kLinear) return linear(segment, t);
  return kind_for_this_call == SplineKind::kQuadratic ? quadratic(segment, t) : natural(segment, t);
}

Spline::Point Spline::linear(std::size_t i, double t) const {
  const double dt = times_[i + 1] - times_[i];
  return each([&](std::size_t k) { return values_[i][k] + (t - times_[i]) * (values_[i + 1][k] - values_[i][k]) / dt; });
}

// The parabola through three neighbouring points, in Lagrange's form.
Spline::Point Spline::quadratic(std::size_t i, double t) const {
  const std::size_t first = i == 0 ? 0 : i - 1;
  const double t0 = times_[first], t1 = times_[first + 1], t2 = times_[first + 2];
  const double w0 = (t - t1) * (t - t2) / ((t0 - t1) * (t0 - t2));
  const double w1 = (t - t0) * (t - t2) / ((t1 - t0) * (t1 - t2));
  const double w2 = (t - t0) * (t - t1) / ((t2 - t0) * (t2 - t1));
  return each([&](std::size_t k) { return w0 * values_[first][k] + w1 * values_[first + 1][k] + w2 * values_[first + 2][k]; });
}

// Catmull-Rom type: the first and the last point only guide the tangents.
Spline::Point Spline::cubic(double t) const {
  const std::size_t n = times_.size() - 1;
  if (n == 1) return each([&](std::size_t k) { return (values_[0][k] + values_[1][k]) / 2; });
  if (!(t > times_[1])) return values_[1];
  if (!(t < times_[n - 1]) || n == 2) return values_[n - 1];
  const auto i = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), t) - times_.begin()) - 1;
  const double dt = times_[i + 1] - times_[i], s = (t - times_[i]) / dt;
  return each([&](std::size_t k) {
    const auto slope = [&](std::size_t j) { return (values_[j + 1][k] - values_[j][k]) / (times_[j + 1] - times_[j]); };
    const double d0 = 0.5 * dt * (slope(i - 1) + slope(i)), d1 = 0.5 * dt * (slope(i + 1) + slope(i));
    return values_[i][k] * (2 * s * s * s - 3 * s * s + 1) + values_[i + 1][k] * (3 * s * s - 2 * s * s * s) +
           d0 * (s * s * s - 2 * s * s + s) + d1 * (s * s * s - s * s);
  });
}

// Natural cubic spline: second derivative 0 at both ends; tridiagonal system solved by elimination.
Spline::Point Spline::natural(std::size_t segment, double t) const {
  const std::size_t n = times_.size() - 1;
  std::vector<double> u(n + 1), w(n + 1), m(n + 1);
  return each([&](std::size_t k) {
    const auto h = [&](std::size_t i) { return times_[i + 1] - times_[i]; };
    const auto b = [&](std::size_t i) { return (values_[i + 1][k] - values_[i][k]) / h(i); };
    u[1] = 2 * (h(0) + h(1));
    w[1] = 6 * (b(1) - b(0));
    for (std::size_t i = 2; i < n; ++i) {
      u[i] = 2 * (h(i) + h(i - 1)) - h(i - 1) * h(i - 1) / u[i - 1];
      w[i] = 6 * (b(i) - b(i - 1)) - h(i - 1) * w[i - 1] / u[i - 1];
    }
    m[n] = m[0] = 0;
    for (std::size_t i = n - 1; i >= 1; --i) m[i] = (w[i] - h(i) * m[i + 1]) / u[i];
    const double hi = h(segment), d = t - times_[segment];
    return values_[segment][k] +
           d * (-hi * (m[segment + 1] + 2 * m[segment]) / 6 + b(segment) +
                d * (m[segment] / 2 + d * (m[segment + 1] - m[segment]) / (6 * hi)));
  });
}

}  // namespace lute
