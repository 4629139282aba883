#include "engine/function/internal_function.hpp"

#include <array>

#include "engine/function/enclosure.hpp"
#include "engine/function/field.hpp"
#include "engine/function/noise_function.hpp"

namespace lute {
namespace {

using field::cross_section;
using field::cube;
using field::Ellipsoids;
using field::limit;
using field::plane_or_revolved;
using field::positive_mod;
using field::sq;
using Point = field::Point<double>;
using std::atan2;
using std::cos;
using std::exp;
using std::fabs;
using std::fmod;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

template <class T>
T boy_surface(const T* a) {
  const field::Point<T> p(a);
  const T q = 1 - p.z, w = p.X + p.Y, root2 = sqrt(2.0);
  const T sum = 64 * cube(q) * p.Z * p.z - 48 * q * q * p.Z * (3 * p.X + 3 * p.Y + 2 * p.Z) +
                     12 * q * p.z * (27 * w * w - 24 * p.Z * w + 36 * root2 * p.y * p.z * (p.Y - 3 * p.X) + 4 * p.Z * p.Z) +
                     (9 * p.X + 9 * p.Y - 2 * p.Z) *
                         (-81 * w * w - 72 * p.Z * w + 108 * root2 * p.x * p.z * (p.X - 3 * p.Y) + 4 * p.Z * p.Z);
  return limit(a[3] * a[4] * sum);
}

double comma(const double* a) {
  Point p(a);
  if (p.x == 0 && p.z == 0) p.x = 0.0001;
  const double s = a[3], t = atan2(p.z, p.x), rho = sqrt(sq(p.x + s / 4) + p.Z);
  const double m = min(p.z, (s / 2) * cos(t / 2) - sqrt(sq(rho - 3 * s / 4) + p.Y));
  return -max(m, s / 2 - sqrt(sq(p.x - s / 2) + p.Y + p.Z));
}

template <class T>
T dupin_cyclid(const T* v) {
  const field::Point<T> p(v);
  const T f = v[3], a = v[4], b = v[5], c = v[6], d = v[7], q = sq(v[8]);
  const T k1 = b * b - d * d - sq(c + a), k2 = b * b - d * d - sq(c - a), h = c * p.x + d * p.y;
  return limit(-f * (k1 * k2 * p.R * p.R + 2 * q * ((b * b + a * a - c * c - d * d) * (2 * h - q) - 4 * d * b * b * p.y) * p.R +
                     4 * q * q * h * (h - q) + 4 * q * q * a * a * p.Y + q * q * q * q));
}

double enneper(const double* a) {
  const Point p(a);
  const double z = fabs(p.z) < 0.2 ? 0.2 : p.z;
  const double u = (p.Y - p.X) / (2 * z) + 2 * p.Z / 9, w = (p.Y - p.X) / (4 * z);
  return limit(-a[3] * (cube(u) - 6 * w * w));
}

double helical_torus(const double* a) {
  const double* q = a + 3;
  Point p(a);
  const double rho = sqrt(p.X + p.Z);
  if (p.x == 0 && p.z == 0) p.x = 1e-6;
  const double phi = atan2(p.x, p.z), tau = atan2(rho - q[0], p.y), r = sqrt(sq(rho - q[0]) + p.Y);
  const double h = positive_mod(phi * q[1] + tau * q[2], 2 * kPi);
  const double k = atan2((h - kPi) * q[8], r - q[5]);
  const double c = cos(k * q[7] + phi * q[9]) * q[3] + q[4];
  return -max(q[4] + q[5] - q[0] - rho, c - min(sqrt(sq(r - q[5]) + sq(h - kPi) * q[6]), r + q[5]));
}

double helix1(const double* a) {
  Point p(a);
  const double n = a[3], f = a[4], minor = a[5], major = a[6], ys = a[7];
  const double rho = sqrt(p.X + p.Z);
  if (p.x == 0 && p.z == 0) p.x = 1e-6;
  const double h = positive_mod(n * atan2(p.z, p.x) + p.y * f * n, 2 * kPi);
  return -minor + min(major + rho, cross_section(rho - major, (h - kPi) / ys / (f * n), a[8], a[9]));
}

template <class T>
T helix2(const T* a) {
  const field::Point<T> p(a);
  const T c = cos(a[4] * p.y), k = sin(a[4] * p.y), u = p.x - a[6] * c, w = p.z - a[6] * k;
  return cross_section<T>(u * c + w * k, -u * k + w * c, a[8], 0) - a[5];
}

// The hexagonal cell folded into one corner: distances a, b from its centre.
std::pair<double, double> hexagon_cell(const Point& p) {
  const double half = sqrt(3.0) / 2;
  double u = fabs(fmod(fabs(p.x), 2 * half) - half), w = fabs(fmod(fabs(p.y), 3.0) - 1.5);
  if (u * u + w * w > sq(half - u) + sq(1.5 - w)) {
    u = half - u;
    w = 1.5 - w;
  }
  return {u, w};
}

double hex_x(const double* a) {
  const auto [u, w] = hexagon_cell(Point(a));
  return atan2(w, u) < kPi / 6 ? u : u / 2 + w * sqrt(3.0) / 2;
}

double hex_y(const double* a) {
  const auto [u, w] = hexagon_cell(Point(a));
  return atan2(w, u) < kPi / 6 ? w : fabs(-u * sqrt(3.0) / 2 + w / 2);
}

template <class T>
T hyperbolic_torus(const T* a) {
  const field::Point<T> p(a);
  const T m = sq(a[4]), q = sq(a[5]);
  return limit(-a[3] * (p.X * p.X + 2 * p.X * p.Y - 2 * p.X * p.Z - 2 * (m + q) * p.X + p.Y * p.Y - 2 * p.Y * p.Z +
                        2 * (m - q) * p.Y + p.Z * p.Z + 2 * (m + q) * p.Z + sq(m - q)));
}

template <class T>
T parabolic_torus(const T* a) {
  const field::Point<T> p(a);
  const T m = sq(a[4]), q = sq(a[5]);
  return limit(-a[3] * (p.X * p.X + 2 * p.X * p.Y - 2 * p.X * p.z - (m + q) * p.X + p.Y * p.Y - 2 * p.Y * p.z +
                        (m - q) * p.Y + p.Z + (m + q) * p.z + sq(m - q)));
}

template <class T>
T klein_bottle(const T* a) {
  const field::Point<T> p(a);
  const T k = p.R - 2 * p.y - 1;
  return limit(-a[3] * ((p.R + 2 * p.y - 1) * (k * k - 8 * p.Z) + 16 * p.x * p.z * k));
}

double mesh1(const double* v) {
  const Point p(v);
  const double a = v[3], b = v[4], c = v[5], d = v[6], e = v[7];
  const auto thread = [&](double along, double period) { return sq(c * fabs(positive_mod(along, 2 * period) - period)); };
  const double r1 = sqrt(sq((p.y - d * cos(kPi * p.z / b)) * e) + thread(p.x, a));
  const double r2 = sqrt(sq((p.y + d * cos(kPi * p.z / b)) * e) + thread(p.x - a, a));
  const double r3 = sqrt(sq((p.y + d * cos(kPi * p.x / a)) * e) + thread(p.z, b));
  const double r4 = sqrt(sq((p.y - d * cos(kPi * p.x / a)) * e) + thread(p.z - b, b));
  return min(min(r1, r2), min(r3, r4));
}

double polytubes(const double* v) {
  const Point p(v);
  const int n = static_cast<int>(std::clamp(std::floor(v[3]), 0.0, 1e6));
  const double q = v[4] + v[5] * p.y + v[6] * p.Y + v[7] * p.Y * p.y + v[8] * p.Y * p.Y;
  double nearest = 10000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / v[3];
    nearest = min(nearest, sqrt(sq(p.x - q * sin(angle)) + sq(p.z - q * cos(angle))));
  }
  return nearest;
}

double quantum(const double* a) {
  Point p(a);
  if (p.x == 0 && p.z == 0) p.x = 1e-6;
  const double c = cos(atan2(sqrt(p.x * p.x + p.Z), p.y)), r = 2 * sqrt(p.R);
  const double k = r * r * exp(-0.33333333 * r) * (3 * c * c - 1);
  return -0.1 * (k * k - 12);
}

template <class T>
T rounded_box(const T* a) {
  const field::Point<T> p(a);
  const auto beyond = [&](const T& v, const T& half) { return sq(max(T(0.0), fabs(v) - (half - a[3]))); };
  return sqrt(beyond(p.x, a[4]) + beyond(p.y, a[5]) + beyond(p.z, a[6])) - a[3] - 1e-6;
}

double spiral(const double* a) {
  Point p(a);
  if (p.x == 0 && p.z == 0) p.x = 1e-6;
  const double d = a[3], rho = sqrt(p.X + p.Z) + d * atan2(p.z, p.x) / (2 * kPi);
  const double k = cross_section(fmod(rho, d) - d / 2, p.y, a[8], 0.0);
  return -min(a[5] - sqrt(p.R), a[4] - min(k, sqrt(p.R)));
}

template <class T>
T superellipsoid(const T* a) {
  const field::Point<T> p(a);
  const T e = a[3], n = a[4];
  const T xy = pow(fabs(p.x), 2 / e) + pow(fabs(p.y), 2 / e);
  return 1 - pow(pow(xy, e / n) + pow(fabs(p.z), 2 / n), n / 2);
}

// A formula for numbers and for ranges: FORMULA is a generic lambda.
template <class Formula>
constexpr InternalFunction both(std::string_view name, int parameters, Formula formula) {
  return {name, parameters + 3, static_cast<double (*)(const double*)>(formula), static_cast<Enclosure (*)(const Enclosure*)>(formula)};
}

#define FIELD(NAME, PARAMETERS, VALUE)                                                     \
  both(NAME, PARAMETERS, []<class T>(const T* a) -> T {                                   \
    const field::Point<T> p(a);                                                            \
    return VALUE;                                                                          \
  })
#define CURVE(NAME, PARAMETERS, SWITCH, VALUE)                                             \
  both(NAME, PARAMETERS, []<class T>(const T* a) -> T {                                   \
    const field::Point<T> p = plane_or_revolved(a, a[SWITCH], a[SWITCH + 1], a[SWITCH + 2]); \
    return VALUE;                                                                          \
  })
#define FORMULA(NAME, PARAMETERS, FUNCTION) both(NAME, PARAMETERS, []<class T>(const T* a) -> T { return FUNCTION(a); })

// In the language's numbering. a[3] is the first parameter after x, y, z.
const auto kTable = std::to_array<InternalFunction>({
    CURVE("algbr_cyl1", 5, 5, -limit(a[3] * -(p.X * fabs(p.x) - p.X + p.Y), a[4])),
    CURVE("algbr_cyl2", 5, 5, limit(a[3] * -(2 * p.X * p.X - 3 * p.X * p.y + p.Y - 2 * p.Y * p.y + p.Y * p.Y), a[4])),
    CURVE("algbr_cyl3", 5, 5, limit(a[3] * -(p.X * p.X + p.X * p.Y - 2 * p.X * p.y - p.x * p.Y + p.Y), a[4])),
    CURVE("algbr_cyl4", 5, 5, limit(a[3] * -(p.X * p.X + p.Y * p.Y + 2 * p.X * p.Y + 3 * p.X * p.y - p.Y * p.y), a[4])),
    FIELD("bicorn", 2, limit(a[3] * (p.Y * (sq(a[4]) - p.X - p.Z) - sq(p.X + p.Z + 2 * a[4] * p.y - sq(a[4]))))),
    FIELD("bifolia", 2, limit(-a[3] * (p.R * p.R - a[4] * (p.X + p.Z) * p.y))),
    FIELD("blob", 5, -(a[4] * sq(1 - min(T(1.0), (sq(p.x + a[3] / 2) + p.Y + p.Z) * sq(a[5]))) +
                       a[6] * sq(1 - min(T(1.0), (sq(p.x - a[3] / 2) + p.Y + p.Z) * sq(a[7]))))),
    FIELD("blob2", 4, a[6] - a[5] * (exp(-a[4] * p.R) + exp(-a[4] * (sq(p.x - a[3]) + p.Y + p.Z)))),
    FORMULA("boy_surface", 2, boy_surface),
    InternalFunction{"comma", 4, comma},
    FIELD("cross_ellipsoids", 4, a[6] - a[5] * max(Ellipsoids<T>(p, a[3], a[4]).e1,
                                                   max(Ellipsoids<T>(p, a[3], a[4]).e2, Ellipsoids<T>(p, a[3], a[4]).e3))),
    FIELD("crossed_trough", 1, limit(a[3] * (p.X * p.Z - p.y))),
    FIELD("cubic_saddle", 1, limit(-a[3] * (cube(p.x) - cube(p.y) - p.z))),
    FIELD("cushion", 1, limit(a[3] * (p.Z * p.X - p.Z * p.Z - 2 * p.z * p.X + 2 * p.Z * p.z + p.X - p.Z - sq(p.X - p.z) -
                                      p.Y * p.Y - 2 * p.X * p.Y - p.Y * p.Z + 2 * p.Y * p.z + p.Y))),
    FIELD("devils_curve", 1, limit(-a[3] * (p.X * p.X + 2 * p.X * p.Z - 0.36 * p.X - p.Y * p.Y + 0.25 * p.Y + p.Z * p.Z))),
    CURVE("devils_curve_2d", 6, 6, limit(-a[3] * (p.X * (p.X - sq(a[4])) - p.Y * (p.Y - sq(a[5]))))),
    FORMULA("dupin_cyclid", 6, dupin_cyclid),
    FIELD("ellipsoid", 3, sqrt(sq(a[3]) * p.X + sq(a[4]) * p.Y + sq(a[5]) * p.Z)),
    InternalFunction{"enneper", 4, enneper},
    FIELD("flange_cover", 4, a[6] - a[5] * (Ellipsoids<T>(p, a[3], a[4]).e1 + Ellipsoids<T>(p, a[3], a[4]).e2 +
                                            Ellipsoids<T>(p, a[3], a[4]).e3)),
    FIELD("folium_surface", 3, limit(a[3] * ((p.Y + p.Z) * (1 + (a[5] - 4 * a[4]) * p.x) + p.X * (1 + a[5])))),
    CURVE("folium_surface_2d", 6, 6, limit(-a[3] * (p.Y * (1 + (a[5] - 4 * a[4]) * p.x) + p.X * (1 + a[5])))),
    FIELD("glob", 1, limit(a[3] * (p.X * p.X * p.x / 2 + p.X * p.X / 2 - p.Y - p.Z))),
    FIELD("heart", 1, limit(-a[3] * (cube(2 * p.X + p.Y + p.Z - 1) - 0.1 * p.X * p.Z * p.z - p.Y * p.Z * p.z))),
    InternalFunction{"helical_torus", 13, helical_torus},
    InternalFunction{"helix1", 10, helix1},
    FORMULA("helix2", 7, helix2),
    InternalFunction{"hex_x", 4, hex_x},
    InternalFunction{"hex_y", 4, hex_y},
    InternalFunction{"hetero_mf", 9, hetero_multifractal},
    FIELD("hunt_surface", 1, limit(-a[3] * (4 * cube(p.R - 13) + 27 * sq(3 * p.X + p.Y - 4 * p.Z - 12)))),
    FORMULA("hyperbolic_torus", 3, hyperbolic_torus),
    FIELD("isect_ellipsoids", 4, a[6] - a[5] * min(Ellipsoids<T>(p, a[3], a[4]).e1,
                                                   min(Ellipsoids<T>(p, a[3], a[4]).e2, Ellipsoids<T>(p, a[3], a[4]).e3))),
    FIELD("kampyle_of_eudoxus", 3, limit(-a[3] * (p.Y + p.Z - sq(a[5]) * p.X * p.X + sq(a[5]) * sq(a[4]) * p.X))),
    CURVE("kampyle_of_eudoxus_2d", 6, 6, limit(-a[3] * (p.Y - sq(a[5]) * p.X * p.X + cube(a[5]) * a[4] * p.X))),
    FORMULA("klein_bottle", 1, klein_bottle),
    FIELD("kummer_surface_v1", 1, limit(-a[3] * (p.X * p.X + p.Y * p.Y + p.Z * p.Z - p.X - p.Y - p.Z - p.X * p.Y - p.X * p.Z -
                                                 p.Y * p.Z + 1))),
    FIELD("kummer_surface_v2", 4, limit(-a[3] * (p.X * p.X + p.Y * p.Y + p.Z * p.Z + a[4] * p.R +
                                                 a[5] * (p.X * p.Y + p.X * p.Z + p.Y * p.Z) + a[6] * p.x * p.y * p.z - 1))),
    FIELD("lemniscate_of_gerono", 1, limit(-a[3] * (p.X * p.X - p.X + p.Y + p.Z))),
    CURVE("lemniscate_of_gerono_2d", 6, 6, limit(-a[3] * (p.Y - sq(a[5]) * sq(a[4]) * p.X + sq(a[5]) * p.X * p.X))),
    InternalFunction{"mesh1", 8, mesh1},
    FIELD("mitre", 1, limit(-a[3] * (4 * p.X * p.R - p.Y * (1 - p.Y - p.Z)))),
    FIELD("nodal_cubic", 1, limit(-a[3] * (cube(p.y) + cube(p.z) - 6 * p.y * p.z))),
    FIELD("odd", 1, limit(a[3] * (p.Z * p.X - p.Z * p.Z - 2 * p.z * p.X + 2 * p.Z * p.z + p.X - p.Z - sq(p.X - p.z) -
                                  p.Y * p.Y - 2 * p.X * p.Y - p.Y * p.Z + 2 * p.Y * p.z + p.Y))),
    FIELD("ovals_of_cassini", 4, limit(-a[3] * (sq(p.R + sq(a[4])) - a[6] * sq(a[4]) * (p.X + p.Z) - sq(a[5])))),
    FIELD("paraboloid", 1, limit(-a[3] * (p.X - p.y + p.Z))),
    FORMULA("parabolic_torus", 3, parabolic_torus),
    FIELD("ph", 0, atan2(sqrt(p.X + p.Z), p.y)),
    FIELD("pillow", 1, limit(a[3] * (p.X * p.X + p.Y * p.Y + p.Z * p.Z - p.R))),
    FIELD("piriform", 1, -limit(-a[3] * (p.X * p.X - p.X * p.x + p.Y + p.Z))),
    CURVE("piriform_2d", 7, 7, limit(-a[3] * (p.Y - a[4] * sq(a[6]) * p.X * p.x - a[5] * sq(a[6]) * p.X * p.X))),
    FIELD("poly4", 5, sqrt(p.X + p.Z) - max(T(-5.0), a[3] + a[4] * p.y + a[5] * p.Y + a[6] * p.Y * p.y + a[7] * p.Y * p.Y)),
    InternalFunction{"polytubes", 9, polytubes},
    InternalFunction{"quantum", 4, quantum},
    FIELD("quartic_paraboloid", 1, limit(-a[3] * (p.X * p.X + p.Z * p.Z - p.y))),
    FIELD("quartic_saddle", 1, limit(-a[3] * (p.X * p.X - p.Z * p.Z - p.y))),
    FIELD("quartic_cylinder", 3, limit(-a[3] * ((p.X + p.Z) * p.Y + sq(a[5]) * (p.X + p.Z) - sq(a[5]) * sq(a[4])))),
    FIELD("r", 0, sqrt(p.R)),
    InternalFunction{"ridge", 9, ridge},
    InternalFunction{"ridged_mf", 9, ridged_multifractal},
    FORMULA("rounded_box", 4, rounded_box),
    FIELD("sphere", 1, sqrt(p.R) - a[3]),
    FIELD("spikes", 5, -a[5] * (a[7] * exp(-a[6] * p.R) - Ellipsoids<T>(p, a[3], a[4]).e1 - Ellipsoids<T>(p, a[3], a[4]).e2 -
                                Ellipsoids<T>(p, a[3], a[4]).e3)),
    FIELD("spikes_2d", 4, p.y - a[3] * cos(a[4] * p.x) * cos(a[5] * p.z) * exp(-a[6] * (p.X + p.Z))),
    InternalFunction{"spiral", 9, spiral},
    FIELD("steiners_roman", 1, limit(-a[3] * (p.X * p.Y + p.X * p.Z + p.Y * p.Z + p.x * p.y * p.z))),
    FIELD("strophoid", 4, limit(-a[3] * ((a[5] - p.x) * (p.Y + p.Z) - sq(a[6]) * a[4] * p.X - sq(a[6]) * p.X * p.x))),
    CURVE("strophoid_2d", 7, 7, limit(-a[3] * ((a[5] - p.x) * p.Y - sq(a[6]) * a[4] * p.X - sq(a[6]) * p.X * p.x))),
    FORMULA("superellipsoid", 2, superellipsoid),
    FIELD("th", 0, atan2(p.x, p.z)),
    FIELD("torus", 2, sqrt(sq(sqrt(p.X + p.Z) - a[3]) + p.Y) - a[4]),
    FIELD("torus2", 3, limit(-a[3] * (p.R * p.R - 2 * (sq(a[4]) + sq(a[5])) * (p.X + p.Z) + 2 * (sq(a[4]) - sq(a[5])) * p.Y +
                                      sq(sq(a[4]) - sq(a[5]))))),
    FIELD("torus_gumdrop", 1, limit(-a[3] * (4 * (p.X * p.X + sq(p.Y + p.Z)) + 17 * p.X * (p.Y + p.Z) - 20 * p.R + 17))),
    FIELD("umbrella", 1, limit(-a[3] * (p.X - p.y * p.Z))),
    FIELD("witch_of_agnesi", 2, limit(-a[3] * (a[4] * (p.y - 1) + (p.X + p.Z) * p.y))),
    CURVE("witch_of_agnesi_2d", 6, 6, limit(-a[3] * (sq(a[4]) * p.y + p.X * p.y - a[5]))),
});
#undef FIELD
#undef CURVE
#undef FORMULA

class Internal final : public Function {
 public:
  explicit Internal(const InternalFunction& entry) : Function(entry.parameters, 1), entry_(entry) {}
  void evaluate(const double* arguments, double* results) const override { results[0] = entry_.evaluate(arguments); }
  bool enclose(const Enclosure* arguments, Enclosure* results) const override {
    if (entry_.enclose == nullptr) return false;
    results[0] = entry_.enclose(arguments);
    return true;
  }

 private:
  const InternalFunction& entry_;
};

}  // namespace

std::span<const InternalFunction> internal_functions() { return kTable; }

FunctionPtr internal_function(int index, int noise_generator) {
  if (index < 0) return nullptr;
  if (const auto i = static_cast<std::size_t>(index); i < kTable.size()) return std::make_shared<Internal>(kTable[i]);
  return noise_function(index, noise_generator);
}

}  // namespace lute
