// Built-in functions of numbers: float functions, vector functions, random numbers. Source: specification chapter 10 §8.1-§8.3.
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/texture/noise.hpp"
#include "parser/expression/recorder.hpp"

namespace lute {

std::string_view numeric_signature(Word word) {
  switch (word) {
    case Word::kAbs: case Word::kCeil: case Word::kFloor: case Word::kExp: case Word::kSin: case Word::kCos: case Word::kTan:
    case Word::kAtan: case Word::kSinh: case Word::kCosh: case Word::kTanh: case Word::kAsinh: case Word::kAcosh:
    case Word::kAtanh: case Word::kAcos: case Word::kAsin: case Word::kSqrt: case Word::kLn: case Word::kLog: case Word::kInt:
    case Word::kDegrees: case Word::kRadians: case Word::kSeed: case Word::kRand: return "f";
    case Word::kAtan2: case Word::kPow: case Word::kMod: case Word::kDiv: return "aa";
    case Word::kMax: case Word::kMin: case Word::kBitwiseAnd: case Word::kBitwiseOr: case Word::kBitwiseXor: return "a+";
    case Word::kSelect: return "aaaa?";
    case Word::kVlength: case Word::kVnormalize: return "V";
    case Word::kVdot: case Word::kVcross: case Word::kVrotate: return "VV";
    case Word::kVaxisRotate: return "VVa";
    case Word::kVturbulence: return "aaaV";
    default: return "";
  }
}

namespace {

using Arguments = std::span<const Number>;
using Floats = std::span<const double>;

// A number outside [-1, 1] is clamped with a warning.
double clamped(Session& session, double value, const char* name) {
  if (value >= -1 && value <= 1) return value;
  session.warn(std::string("Domain error in ") + name + ".", "domain");
  return std::clamp(value, -1.0, 1.0);
}

[[noreturn]] void fail_negative(Session& session, const char* text, double value) {
  session.fail(text + std::to_string(value), "domain");
}

double seed(Session& session, double value) {
  session.random_states.push_back(static_cast<std::uint32_t>(to_int32(value)));
  return static_cast<double>(session.random_states.size() - 1);
}

double rand(Session& session, double stream) {
  const std::int32_t index = to_int32(stream);
  if (index < 0 || static_cast<std::size_t>(index) >= session.random_states.size()) {
    session.fail("Illegal random number generator.", "random");
  }
  std::uint32_t& state = session.random_states[static_cast<std::size_t>(index)];
  state = 1812433253u * state + 12345u;
  return state / 4294967295.0;
}

double choose(Floats a) {
  if (a.size() == 3) return a[0] < 0 ? a[1] : a[2];
  if (a[0] < 0) return a[1];
  return a[0] == 0 ? a[2] : a[3];
}

double float_function_of_several(Session& session, Word word, Floats a) {
  switch (word) {
    case Word::kAtan2:
      if (std::fabs(a[0]) <= kEpsilon && std::fabs(a[1]) <= kEpsilon) session.fail("Domain error in atan2!", "domain");
      return std::atan2(a[0], a[1]);
    case Word::kPow:
      if (a[0] == 0 && a[1] == 0) session.fail("Domain error.", "domain");
      return std::pow(a[0], a[1]);
    case Word::kMod: return std::fmod(a[0], a[1]);
    case Word::kDiv: return to_int32(a[0] / a[1]);
    case Word::kMax: {
      double result = a[0];
      for (const double value : a) result = std::max(result, value);
      return result;
    }
    case Word::kMin: {
      double result = a[0];
      for (const double value : a) result = std::min(result, value);
      return result;
    }
    case Word::kBitwiseAnd:
    case Word::kBitwiseOr:
    case Word::kBitwiseXor: {
      std::int32_t result = to_int32(a[0]);
      for (const double value : a.subspan(1)) {
        const std::int32_t bits = to_int32(value);
        result = word == Word::kBitwiseAnd ? result & bits : word == Word::kBitwiseOr ? result | bits : result ^ bits;
      }
      return result;
    }
    case Word::kSelect: return choose(a);
    default: return 0;
  }
}

}  // namespace

double apply_float_function(Session& session, Word word, Floats a) {
  const double v = a[0];
  switch (word) {
    case Word::kAbs: return std::fabs(v);
    case Word::kCeil: return std::ceil(v);
    case Word::kFloor: return std::floor(v);
    case Word::kExp: return std::exp(v);
    case Word::kSin: return std::sin(v);
    case Word::kCos: return std::cos(v);
    case Word::kTan: return std::tan(v);
    case Word::kAtan: return std::atan(v);
    case Word::kSinh: return std::sinh(v);
    case Word::kCosh: return std::cosh(v);
    case Word::kTanh: return std::tanh(v);
    case Word::kAsinh: return std::asinh(v);
    case Word::kAcosh: return std::acosh(v);
    case Word::kAtanh: return std::atanh(v);
    case Word::kAcos: return std::acos(clamped(session, v, "acos"));
    case Word::kAsin: return std::asin(clamped(session, v, "asin"));
    case Word::kSqrt:
      if (v < 0) fail_negative(session, "sqrt of negative number ", v);
      return std::sqrt(v);
    case Word::kLn:
      if (v <= 0) fail_negative(session, "ln of negative number ", v);
      return std::log(v);
    case Word::kLog:
      if (v <= 0) fail_negative(session, "log of negative number ", v);
      return std::log10(v);
    case Word::kInt: return to_int32(v);
    case Word::kDegrees: return v / (kPi / 180.0);
    case Word::kRadians: return v * (kPi / 180.0);
    case Word::kSeed: return seed(session, v);
    case Word::kRand: return rand(session, v);
    default: return float_function_of_several(session, word, a);
  }
}

namespace {

dvec3 rotated(dvec3 v, const dvec3& degrees) {
  const dvec3 c(std::cos(radians(degrees.x)), std::cos(radians(degrees.y)), std::cos(radians(degrees.z)));
  const dvec3 s(std::sin(radians(degrees.x)), std::sin(radians(degrees.y)), std::sin(radians(degrees.z)));
  v = {v.x, v.y * c.x - v.z * s.x, v.y * s.x + v.z * c.x};
  v = {v.x * c.y + v.z * s.y, v.y, -v.x * s.y + v.z * c.y};
  return {v.x * c.z - v.y * s.z, v.x * s.z + v.y * c.z, v.z};
}

dvec3 axis_rotated(const dvec3& v, const dvec3& axis, double degrees) {
  const dvec3 n = axis / glm::length(axis);
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return v * c + glm::cross(n, v) * s + n * (glm::dot(n, v) * (1 - c));
}

dvec3 normalized(Session& session, const dvec3& v) {
  const double length = glm::length(v);
  if (length == 0) {
    if (session.language.version >= 350) session.possible_error("Normalizing zero-length vector.", "zero-vector");
    return dvec3(0);
  }
  return v / length;
}

dvec3 turbulence(Arguments a) {
  const int octaves = std::clamp(to_int32(a[2].c[0]), 1, 10);
  // In single precision, as the reference keeps them (measured with omega 0.7).
  const auto lambda = static_cast<double>(static_cast<float>(a[0].c[0])), omega = static_cast<double>(static_cast<float>(a[1].c[0]));
  dvec3 point = a[3].vector();
  dvec3 result = vector_noise(point);
  double weight = 1;
  for (int i = 2; i <= octaves; ++i) {
    point *= lambda;
    weight *= omega;
    result += weight * vector_noise(point);
  }
  return result;
}

}  // namespace

// Arguments are checked and promoted here, so that compiled code and the parser agree.
Number apply_function(Session& session, Word word, Arguments arguments) {
  const std::string_view signature = numeric_signature(word);
  if (signature.find('V') == std::string_view::npos) {
    std::array<double, 4> few{};
    std::vector<double> many;
    if (arguments.size() > few.size()) many.resize(arguments.size());
    double* const floats = many.empty() ? few.data() : many.data();
    for (std::size_t i = 0; i < arguments.size(); ++i) floats[i] = promoted(session, arguments[i], 1).c[0];
    return Number(apply_float_function(session, word, {floats, arguments.size()}));
  }
  std::array<Number, 4> promoted_arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    promoted_arguments[i] = promoted(session, arguments[i], signature[i] == 'V' ? 3 : 1);
  }
  arguments = Arguments(promoted_arguments).first(arguments.size());
  switch (word) {
    case Word::kVlength: return Number(glm::length(arguments[0].vector()));
    case Word::kVdot: return Number(glm::dot(arguments[0].vector(), arguments[1].vector()));
    case Word::kVcross: return Number(glm::cross(arguments[0].vector(), arguments[1].vector()));
    case Word::kVnormalize: return Number(normalized(session, arguments[0].vector()));
    case Word::kVrotate: return Number(rotated(arguments[0].vector(), arguments[1].vector()));
    case Word::kVaxisRotate: return Number(axis_rotated(arguments[0].vector(), arguments[1].vector(), arguments[2].c[0]));
    case Word::kVturbulence: return Number(turbulence(arguments));
    default: return Number();
  }
}

}  // namespace lute
