#include "parser/value/spline.hpp"

#include <algorithm>
#include <limits>

#include "engine/function/enclosure.hpp"

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
  const std::size_t segment = segment_of(t);
  if (times_.size() == 2 || kind_for_this_call == SplineKind::kLinear) return each([&](std::size_t k) { return linear(segment, t, k); });
  if (kind_for_this_call == SplineKind::kQuadratic) return each([&](std::size_t k) { return quadratic(segment, t, k); });
  Tridiagonal system;
  return each([&](std::size_t k) {
    find_second_derivatives(k, system);
    return natural(segment, t, k, system.m);
  });
}

std::size_t Spline::segment_of(double t) const {
  return static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), t) - times_.begin()) - 1;
}

template <class T>
T Spline::linear(std::size_t i, const T& t, std::size_t k) const {
  const double dt = times_[i + 1] - times_[i];
  return values_[i][k] + (t - times_[i]) * (values_[i + 1][k] - values_[i][k]) / dt;
}

// The parabola through three neighbouring points, in Lagrange's form.
template <class T>
T Spline::quadratic(std::size_t i, const T& t, std::size_t k) const {
  const std::size_t first = i == 0 ? 0 : i - 1;
  const double t0 = times_[first], t1 = times_[first + 1], t2 = times_[first + 2];
  const T w0 = (t - t1) * (t - t2) / ((t0 - t1) * (t0 - t2));
  const T w1 = (t - t0) * (t - t2) / ((t1 - t0) * (t1 - t2));
  const T w2 = (t - t0) * (t - t1) / ((t2 - t0) * (t2 - t1));
  return w0 * values_[first][k] + w1 * values_[first + 1][k] + w2 * values_[first + 2][k];
}

// Catmull-Rom type: the first and the last point only guide the tangents.
template <class T>
T Spline::cubic(std::size_t i, const T& t, std::size_t k) const {
  const double dt = times_[i + 1] - times_[i];
  const T s = (t - times_[i]) / dt;
  const auto slope = [&](std::size_t j) { return (values_[j + 1][k] - values_[j][k]) / (times_[j + 1] - times_[j]); };
  const double d0 = 0.5 * dt * (slope(i - 1) + slope(i)), d1 = 0.5 * dt * (slope(i + 1) + slope(i));
  return values_[i][k] * (2 * s * s * s - 3 * s * s + 1) + values_[i + 1][k] * (3 * s * s - 2 * s * s * s) +
         d0 * (s * s * s - 2 * s * s + s) + d1 * (s * s * s - s * s);
}

Spline::Point Spline::cubic(double t) const {
  const std::size_t n = times_.size() - 1;
  if (n == 1) return each([&](std::size_t k) { return (values_[0][k] + values_[1][k]) / 2; });
  if (!(t > times_[1])) return values_[1];
  if (!(t < times_[n - 1]) || n == 2) return values_[n - 1];
  const std::size_t segment = segment_of(t);
  return each([&](std::size_t k) { return cubic(segment, t, k); });
}

// Natural cubic spline: second derivative 0 at both ends; tridiagonal system solved by elimination.
void Spline::find_second_derivatives(std::size_t k, Tridiagonal& system) const {
  const std::size_t n = times_.size() - 1;
  auto& [u, w, m] = system;
  for (std::vector<double>* row : {&u, &w, &m}) row->resize(n + 1);
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
}

template <class T>
T Spline::natural(std::size_t i, const T& t, std::size_t k, const std::vector<double>& m) const {
  const double h = times_[i + 1] - times_[i], b = (values_[i + 1][k] - values_[i][k]) / h;
  const T d = t - times_[i];
  return values_[i][k] + d * (-h * (m[i + 1] + 2 * m[i]) / 6 + b + d * (m[i] / 2 + d * (m[i + 1] - m[i]) / (6 * h)));
}

// The curve is continuous, each segment differentiable: where t runs over several, both the values and all difference quotients lie between
// the least and the greatest of any. Beyond its ends it is constant. Each segment is computed as for numbers, rounded outward.
Enclosure Spline::enclose(const Enclosure& t, std::size_t k) const {
  if (times_.size() < 2 || (times_.size() == 2 && kind == SplineKind::kCubic)) return evaluate(0)[k];
  const std::size_t n = times_.size() - 1, first = kind == SplineKind::kCubic ? 1 : 0, last = kind == SplineKind::kCubic ? n - 1 : n;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Enclosure result(kInfinity, -kInfinity, kInfinity, -kInfinity);
  const auto add = [&](const Enclosure& e) {
    result = {std::min(result.lo, e.lo), std::max(result.hi, e.hi), std::min(result.slope_lo, e.slope_lo),
              std::max(result.slope_hi, e.slope_hi)};
  };
  if (!(t.lo > times_[first])) add(values_[first][k]);
  if (!(t.hi < times_[last])) add(values_[last][k]);
  const bool is_linear = n == 1 || kind == SplineKind::kLinear;
  Tridiagonal system;
  if (kind == SplineKind::kNatural && !is_linear) find_second_derivatives(k, system);
  for (std::size_t i = first; i < last; ++i) {
    if (t.lo > times_[i + 1] || t.hi < times_[i]) continue;
    const Enclosure part(std::max(t.lo, times_[i]), std::min(t.hi, times_[i + 1]), t.slope_lo, t.slope_hi);
    add(is_linear                        ? linear(i, part, k)
        : kind == SplineKind::kQuadratic ? quadratic(i, part, k)
        : kind == SplineKind::kCubic     ? cubic(i, part, k)
                                         : natural(i, part, k, system.m));
  }
  return result;
}

}  // namespace lute
