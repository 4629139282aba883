// What the families of shape cases share, and where each adds its own.
#pragma once

#include <cmath>

#include "engine/shape/table.hpp"
#include "shape_cases.hpp"
#include "trace.hpp"

namespace lute::test {

template <class Description>
std::function<std::unique_ptr<Shape>(const Transform&)> maker(Description description) {
  return [description](const Transform& to_world) { return make(description, to_world); };
}

// Distance from the zero of a function, to first order: its value over the length of its slope, found numerically.
template <class F>
std::function<double(const dvec3&)> to_first_order(F f, double step = 1e-6) {
  return [f, step](const dvec3& p) {
    const auto slope = [&](const dvec3& d) { return (f(p + step * d) - f(p - step * d)) / (2 * step); };
    return std::abs(f(p)) / glm::length(dvec3(slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})));
  };
}

void add_formula_solids(std::vector<ShapeCase>& cases);   // shape_cases.cpp
void add_swept_shapes(std::vector<ShapeCase>& cases);     // swept_shape_cases.cpp
void add_flat_shapes(std::vector<ShapeCase>& cases);      // flat_shape_cases.cpp
void add_function_shapes(std::vector<ShapeCase>& cases);  // function_shape_cases.cpp

}  // namespace lute::test
