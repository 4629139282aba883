// User functions: `function(x, y, z) { ... }`. A function is immutable once made and may be evaluated from any thread.
// Results: 1 for a float function; 2 to kMostResults for spline, transform (3) and pigment (5: r, g, b, filter, transmit) functions.
// Source: specification chapters 10 §11 and 21 §11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "engine/math/vec.hpp"
#include "engine/scene/texture.hpp"

namespace lute {

struct Enclosure;  // engine/function/enclosure.hpp

class Function {
 public:
  static constexpr std::size_t kMostResults = 5;

  virtual ~Function() = default;

  int parameter_count() const { return parameters_; }
  int result_count() const { return results_; }
  bool is_vector() const { return results_ > 1; }
  std::uint32_t depth() const { return depth_; }  // of functions, pigments and objects that ask each other, this one included
  double work() const { return work_; }  // how many functions one evaluation may call; a turn of a loop counts once

  // `arguments` has parameter_count() values, `results` room for result_count(). Domain problems are NaN. Throws only EndlessFunction.
  virtual void evaluate(const double* arguments, double* results) const = 0;

  // The same for many points, to the last bit, in less time. In rows, so that what is done to one argument is done to many numbers side by
  // side: argument k of point i is arguments[k * stride + i], its result k goes to results[k * stride + i], and count <= stride. Throws
  // what the first point throws for which evaluate() would.
  virtual void evaluate_many(std::size_t count, std::size_t stride, const double* arguments, double* results) const {
    one_by_one(count, stride, arguments, results);
  }

  // Bounds of the results and of their slopes, for arguments that run over ranges: as many as evaluate() has. False if this function has
  // no such formula (noise, patterns, pigments).
  virtual bool enclose(const Enclosure* arguments, Enclosure* results) const;

  double at(const dvec3& p) const {  // of a float function of (x, y, z)
    const double arguments[3] = {p.x, p.y, p.z};
    double result = 0;
    evaluate(arguments, &result);
    return result;
  }

 protected:
  Function(int parameters, int results, std::uint32_t depth = 1) : parameters_(parameters), results_(results), depth_(depth) {}
  void set_calls(std::uint32_t depth, double work) {
    depth_ = depth;
    work_ = work;
  }
  void one_by_one(std::size_t count, std::size_t stride, const double* arguments, double* results) const;

 private:
  int parameters_, results_;
  std::uint32_t depth_;
  double work_ = 0;
};
using FunctionPtr = std::shared_ptr<const Function>;

// Makes functions out of pigments and patterns; engine/texture implements it, the application hands it to the parser.
class TextureFunctions {
 public:
  virtual ~TextureFunctions() = default;
  virtual FunctionPtr pigment_function(const PigmentPtr& pigment, int noise_generator) = 0;       // 3 parameters, 5 results
  virtual FunctionPtr pattern_function(const PatternBody& pattern, int noise_generator) = 0;      // 3 parameters, 1 result
};

}  // namespace lute
