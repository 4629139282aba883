// Shapes of functions.
#include <cmath>

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
  c.accuracy = 1e-6;
  c.scatter = 2e-7;
  c.own_normals = true;  // those of the last iterate; the surface is where the one before it leaves the ball
  return c;
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
