#include <cmath>
#include <limits>

#include "engine/function/program.hpp"
#include "engine/math/vec.hpp"

namespace lute {
namespace {

// `int` and `div` go through a 32-bit integer; what does not fit becomes its smallest value (chapter 10 §8.1).
double truncate_to_int32(double v) {
  if (!(v > -2147483649.0 && v < 2147483648.0)) return -2147483648.0;
  return std::trunc(v);
}

}  // namespace

double apply(UnaryOp op, double a) {
  switch (op) {
    case UnaryOp::kNegate: return -a;
    case UnaryOp::kSin: return std::sin(a);
    case UnaryOp::kCos: return std::cos(a);
    case UnaryOp::kTan: return std::tan(a);
    case UnaryOp::kAsin: return std::asin(a);
    case UnaryOp::kAcos: return std::acos(a);
    case UnaryOp::kAtan: return std::atan(a);
    case UnaryOp::kSinh: return std::sinh(a);
    case UnaryOp::kCosh: return std::cosh(a);
    case UnaryOp::kTanh: return std::tanh(a);
    case UnaryOp::kAsinh: return std::asinh(a);
    case UnaryOp::kAcosh: return std::acosh(a);
    case UnaryOp::kAtanh: return std::atanh(a);
    case UnaryOp::kAbs: return std::fabs(a);
    case UnaryOp::kRadians: return a * (kPi / 180.0);
    case UnaryOp::kDegrees: return a * (180.0 / kPi);
    case UnaryOp::kFloor: return std::floor(a);
    case UnaryOp::kCeil: return std::ceil(a);
    case UnaryOp::kInt: return truncate_to_int32(a);
    case UnaryOp::kSqrt: return std::sqrt(a);
    case UnaryOp::kExp: return std::exp(a);
    case UnaryOp::kLn: return std::log(a);
    case UnaryOp::kLog: return std::log10(a);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double apply(BinaryOp op, double a, double b) {
  switch (op) {
    case BinaryOp::kAdd: return a + b;
    case BinaryOp::kSubtract: return a - b;
    case BinaryOp::kMultiply: return a * b;
    case BinaryOp::kDivide: return a / b;
    // NaN counts as "greater" (chapter 21 §11.4).
    case BinaryOp::kLess: return a < b ? 1 : 0;
    case BinaryOp::kLessEqual: return a <= b ? 1 : 0;
    case BinaryOp::kEqual: return a == b ? 1 : 0;
    case BinaryOp::kNotEqual: return a == b ? 0 : 1;
    case BinaryOp::kGreaterEqual: return a < b ? 0 : 1;
    case BinaryOp::kGreater: return a <= b ? 0 : 1;
    case BinaryOp::kAnd: return a != 0 && b != 0 ? 1 : 0;
    case BinaryOp::kOr: return a != 0 || b != 0 ? 1 : 0;
    case BinaryOp::kAtan2: return std::atan2(a, b);
    case BinaryOp::kMod: return std::fmod(a, b);
    case BinaryOp::kPow: return std::pow(a, b);
    case BinaryOp::kDiv: return truncate_to_int32(a / b);
    case BinaryOp::kMin: return b < a ? b : a;
    case BinaryOp::kMax: return a < b ? b : a;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace lute
