// quadric, poly, cubic, quartic, polynomial, superellipsoid, ovus, julia_fractal.
#include <algorithm>
#include <optional>

#include "parser/statement/curved_shape.hpp"

namespace lute {

namespace {

void check_order(Reader& reader, int order) {
  if (order < 2 || order > Poly::kMaxOrder) reader.error("Order of poly is out of range.");
}

std::optional<JuliaFractal::Function> julia_function(Word word) {
  using F = JuliaFractal::Function;
  switch (word) {
    case Word::kSqr: return F::kSqr;
    case Word::kCube: return F::kCube;
    case Word::kReciprocal: return F::kReciprocal;
    case Word::kExp: return F::kExp;
    case Word::kLn: return F::kLn;
    case Word::kSin: return F::kSin;
    case Word::kAsin: return F::kAsin;
    case Word::kSinh: return F::kSinh;
    case Word::kAsinh: return F::kAsinh;
    case Word::kCos: return F::kCos;
    case Word::kAcos: return F::kAcos;
    case Word::kCosh: return F::kCosh;
    case Word::kAcosh: return F::kAcosh;
    case Word::kTan: return F::kTan;
    case Word::kAtan: return F::kAtan;
    case Word::kTanh: return F::kTanh;
    case Word::kAtanh: return F::kAtanh;
    case Word::kPwr: return F::kPwr;
    default: return std::nullopt;
  }
}

void parse_slice(Reader& reader, JuliaFractal& fractal) {
  const dvec4 slice = reader.vector4();
  reader.comma();
  fractal.slice_distance = reader.number();
  const double squared = glm::dot(slice, slice);
  if (squared < kEpsilon) reader.error("Slice vector is zero.");
  if (slice.w > -kEpsilon && slice.w < kEpsilon) reader.error("Slice t component is zero.");
  fractal.slice = glm::normalize(slice);
}

}  // namespace

Quadric parse_quadric(Reader& reader) {
  Quadric quadric;
  quadric.squares = reader.vector();
  reader.comma();
  quadric.mixed = reader.vector();
  reader.comma();
  quadric.linear = reader.vector();
  reader.comma();
  quadric.constant = reader.number();
  return quadric;
}

Poly parse_poly(Reader& reader) {
  const int order = reader.integer();
  check_order(reader, order);
  reader.comma();
  return parse_poly_of_order(reader, order);
}

Poly parse_poly_of_order(Reader& reader, int order) {
  Poly poly;
  poly.order = order;
  poly.coefficients.resize(Poly::term_count(order));
  reader.expect(TokenKind::kLess);
  for (std::size_t i = 0; i < poly.coefficients.size(); ++i) {
    if (i > 0) reader.comma();
    poly.coefficients[i] = reader.number();
  }
  reader.expect(TokenKind::kGreater);
  return poly;
}

Poly parse_polynomial(Reader& reader) {
  Poly poly;
  poly.order = reader.integer();
  check_order(reader, poly.order);
  reader.comma();
  poly.coefficients.resize(Poly::term_count(poly.order));
  while (reader.accept(Word::kXyz)) {
    reader.expect(TokenKind::kLeftParen);
    int powers[3];
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) reader.comma();
      powers[axis] = reader.integer();
    }
    reader.expect(TokenKind::kRightParen);
    reader.expect(TokenKind::kColon);
    const double value = reader.number();
    reader.comma();
    const bool negative = powers[0] < 0 || powers[1] < 0 || powers[2] < 0;
    const bool too_high = std::max({powers[0], powers[1], powers[2]}) > poly.order || powers[0] + powers[1] + powers[2] > poly.order;
    if (negative || too_high) reader.error("Coefficient of polynom is out of range.");
    poly.coefficients[Poly::term_index(poly.order, powers[0], powers[1], powers[2])] = value;
  }
  return poly;
}

Superellipsoid parse_superellipsoid(Reader& reader) {
  const dvec2 exponents = reader.vector2();
  return {exponents.x, exponents.y};
}

Ovus parse_ovus(Reader& reader) {
  Ovus ovus;
  ovus.bottom_radius = reader.number();
  reader.comma();
  ovus.top_radius = reader.number();
  if (ovus.bottom_radius < 0 || ovus.top_radius < 0) reader.error("Both Ovus radii must be positive");
  if (ovus.top_radius >= 2 * ovus.bottom_radius)
    reader.possible_error("Ovus second radius should be less than twice first radius: it is a sphere.");
  return ovus;
}

JuliaFractal parse_julia_fractal(Reader& reader) {
  using Algebra = JuliaFractal::Algebra;
  using F = JuliaFractal::Function;
  JuliaFractal fractal;
  fractal.constant = reader.vector4();
  while (true) {
    if (const auto function = julia_function(reader.word())) {
      reader.take();
      fractal.function = *function;
      if (*function != F::kPwr) continue;
      reader.expect(TokenKind::kLeftParen);
      fractal.exponent.x = reader.number();
      reader.comma();
      fractal.exponent.y = reader.number();
      reader.expect(TokenKind::kRightParen);
    } else if (reader.accept(Word::kMaxIteration)) {
      fractal.max_iteration = std::max(1, reader.integer());
      if (fractal.max_iteration > JuliaFractal::kMostIterations)
        reader.error("max_iteration is too large: the limit is " + std::to_string(JuliaFractal::kMostIterations) + ".");
    } else if (reader.accept(Word::kPrecision)) {
      fractal.precision = std::max(1.0, reader.number());
    } else if (reader.accept(Word::kSlice)) {
      parse_slice(reader, fractal);
    } else if (reader.accept(Word::kQuaternion)) {
      fractal.algebra = Algebra::kQuaternion;
    } else if (reader.accept(Word::kHypercomplex)) {
      fractal.algebra = Algebra::kHypercomplex;
    } else {
      break;
    }
  }
  if (fractal.algebra == Algebra::kQuaternion && fractal.function != F::kSqr && fractal.function != F::kCube)
    reader.error("Illegal function: quaternion only supports sqr and cube");
  return fractal;
}

}  // namespace lute
