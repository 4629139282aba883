// Shapes of functions.
#include <cmath>
#include <complex>
#include <tuple>
#include <utility>

#include "engine/function/function.hpp"
#include "shape_case_parts.hpp"

namespace lute::test {
namespace {

class Formula final : public Function {
 public:
  Formula(int parameters, double (*f)(const double*)) : Function(parameters, 1), f_(f) {}
  void evaluate(const double* arguments, double* results) const override { *results = f_(arguments); }

 private:
  double (*f_)(const double*);
};
FunctionPtr formula(double (*f)(const double*)) { return std::make_shared<Formula>(3, f); }

ShapeCase julia(std::string name, JuliaFractal::Algebra algebra, JuliaFractal::Function function) {
  JuliaFractal f;
  f.constant = {-0.083, 0, -0.6, -0.025};
  f.algebra = algebra;
  f.function = function;
  f.max_iteration = 4;
  f.precision = 200;
  ShapeCase c{std::move(name), maker(f)};
  c.rays = 200;
  c.accuracy = 1e-6;
  c.scatter = 2e-7;
  c.own_normals = true;  // those of the last iterate; the surface is where the one before it leaves the ball
  return c;
}

using Complex = std::complex<double>;
using ComplexMap = Complex (*)(const Complex&);

// Whether the orbit of a hypercomplex number under f(z) + c stays, from the mathematics alone: the number is a pair of complex numbers,
// (x - w) + (y + z) i and (x + w) + (y - z) i, on each of which f acts, and the mean of whose squared lengths is its own.
bool stays(const JuliaFractal& f, ComplexMap map, const dvec4& start) {
  const auto first = [](const dvec4& q) { return Complex(q.x - q.w, q.y + q.z); };
  const auto second = [](const dvec4& q) { return Complex(q.x + q.w, q.y - q.z); };
  Complex a = first(start), b = second(start);
  for (int i = 0; i < f.max_iteration; ++i) {
    if (0.5 * (std::norm(a) + std::norm(b)) > 16) return false;
    a = map(a) + first(f.constant);
    b = map(b) + second(f.constant);
  }
  return true;
}

// Functions begin their inside test with y in the place of z, but the march along a ray does not (specification chapter 21 §7.3): a hit
// lies where one of the two changes, at most one step of the march away.
ShapeCase julia_of_function(std::string name, JuliaFractal::Function function, ComplexMap map) {
  JuliaFractal f;
  f.constant = {-0.2, 0.3, 0.1, -0.1};
  f.algebra = JuliaFractal::Algebra::kHypercomplex;
  f.function = function;
  f.exponent = {2.5, 0.2};
  f.max_iteration = 2;  // so that the set is no dust
  f.precision = 100;
  ShapeCase c{std::move(name), maker(f)};
  c.size = 2;
  c.rays = 40;
  c.accuracy = 1e-6;
  c.scatter = 2e-7;
  c.own_normals = true;
  c.parity = false;
  // Where a ray enters the ball, rounding decides whether it is inside of a set that fills it. If not, there is a hit within the
  // first step of the march, of which the later steps begin elsewhere.
  constexpr double kBall = 4;
  c.rounding_decides = [step = 1 / f.precision](const dvec3& p) { return glm::length(p) > kBall - 1.1 * step; };
  c.distance = [f, map](const dvec3& p) {
    const auto here = [&](const dvec3& q) {
      return std::pair(stays(f, map, dvec4(q, 0)), stays(f, map, dvec4(q.x, q.y, q.y, 0)));
    };
    const auto middle = here(p);
    const double reach = 2 / f.precision;
    for (const double share : {1.0, 0.5, 0.25, 1e-6})
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            if (here(p + share * reach * dvec3(x, y, z)) != middle) return 0.0;
    return 1.0;
  };
  return c;
}

void add_julia_functions(std::vector<ShapeCase>& cases) {
  using F = JuliaFractal::Function;
  // acos and acosh with the branches of chapter 21 §7.3.
  const std::tuple<const char*, F, ComplexMap> functions[] = {
      {"reciprocal", F::kReciprocal, [](const Complex& z) { return 1.0 / z; }},
      {"exp", F::kExp, [](const Complex& z) { return std::exp(z); }},
      {"ln", F::kLn, [](const Complex& z) { return std::log(z); }},
      {"sin", F::kSin, [](const Complex& z) { return std::sin(z); }},
      {"asin", F::kAsin, [](const Complex& z) { return std::asin(z); }},
      {"sinh", F::kSinh, [](const Complex& z) { return std::sinh(z); }},
      {"asinh", F::kAsinh, [](const Complex& z) { return std::asinh(z); }},
      {"cos", F::kCos, [](const Complex& z) { return std::cos(z); }},
      {"acos", F::kAcos, [](const Complex& z) { return Complex(0, -1) * std::log(z + std::sqrt(z * z - 1.0)); }},
      {"cosh", F::kCosh, [](const Complex& z) { return std::cosh(z); }},
      {"acosh", F::kAcosh, [](const Complex& z) { return std::log(z + std::sqrt(z * z - 1.0)); }},
      {"tan", F::kTan, [](const Complex& z) { return std::tan(z); }},
      {"atan", F::kAtan, [](const Complex& z) { return std::atan(z); }},
      {"tanh", F::kTanh, [](const Complex& z) { return std::tanh(z); }},
      {"atanh", F::kAtanh, [](const Complex& z) { return std::atanh(z); }},
      {"pwr", F::kPwr, [](const Complex& z) { return std::pow(z, Complex(2.5, 0.2)); }},
  };
  for (const auto& [name, function, map] : functions) {
    cases.push_back(julia_of_function(std::string("julia_hypercomplex_") + name, function, map));
  }
}

double wavy_ball(const double* p) {
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 0.5 + 0.1 * std::sin(5 * p[0]) * std::sin(4 * p[1]);
}

ShapeCase isosurface(std::string name, bool round) {
  Isosurface iso;
  iso.function = formula(wavy_ball);
  iso.max_gradient = 3;
  iso.accuracy = 1e-6;
  iso.max_trace = 10;
  iso.container.is_sphere = round;
  ShapeCase c{std::move(name), maker(iso)};
  c.distance = to_first_order([](const dvec3& p) { return wavy_ball(&p.x); });
  c.accuracy = c.scatter = 1e-5;
  return c;
}

}  // namespace

void add_function_shapes(std::vector<ShapeCase>& cases) {
  cases.push_back(julia("julia_quaternion_sqr", JuliaFractal::Algebra::kQuaternion, JuliaFractal::Function::kSqr));
  cases.push_back(julia("julia_quaternion_cube", JuliaFractal::Algebra::kQuaternion, JuliaFractal::Function::kCube));
  cases.push_back(julia("julia_hypercomplex_sqr", JuliaFractal::Algebra::kHypercomplex, JuliaFractal::Function::kSqr));
  cases.push_back(julia("julia_hypercomplex_cube", JuliaFractal::Algebra::kHypercomplex, JuliaFractal::Function::kCube));
  add_julia_functions(cases);
  cases.push_back(isosurface("isosurface", false));
  cases.push_back(isosurface("isosurface_in_sphere", true));
  Parametric saddle;
  saddle.functions = {formula([](const double* p) { return p[0]; }), formula([](const double* p) { return 0.6 * p[0] * p[1]; }),
                      formula([](const double* p) { return p[1]; })};
  saddle.lo = {-0.9, -0.9};
  saddle.hi = {0.9, 0.9};
  saddle.accuracy = 1e-4;
  saddle.max_gradient = 1.2;
  ShapeCase parametric{"parametric", maker(saddle)};
  parametric.distance = to_first_order([](const dvec3& p) { return p.y - 0.6 * p.x * p.z; });
  parametric.parity = false;
  // The size of the last rectangle; along a ray that grazes, its box is longer.
  parametric.accuracy = 0.02;
  parametric.scatter = 1e-3;
  cases.push_back(parametric);
}

}  // namespace lute::test
