#include "parser/statement/transformation.hpp"

#include <cmath>

namespace lute {
namespace {

dvec3 scale_factors(Reader& reader) {
  dvec3 factors = reader.vector();
  for (int axis = 0; axis < 3; ++axis) {
    if (factors[axis] != 0) continue;
    factors[axis] = 1;
    reader.warning(std::string("Illegal Value: Scale ") + "XYZ"[axis] + " by 0.0. Changed to 1.0.");
  }
  return factors;
}

// matrix < 12 numbers >: the images of x, y, z, then the translation.
Transform parse_matrix(Reader& reader) {
  dvec3 rows[4];
  reader.expect(TokenKind::kLess);
  for (dvec3& row : rows)
    for (int column = 0; column < 3; ++column) {
      row[column] = reader.number();
      reader.comma();
    }
  reader.expect(TokenKind::kGreater);
  for (int column = 0; column < 3; ++column) {
    bool empty = true;
    for (int row = 0; row < 3; ++row) empty = empty && std::abs(rows[row][column]) < kEpsilon;
    if (!empty) continue;
    rows[column][column] = 1;
    reader.warning("Illegal matrix column: Scale by 0.0. Changed to 1.0.");
  }
  return Transform::matrix(dmat3(rows[0], rows[1], rows[2]), rows[3]);
}

}  // namespace

std::optional<Transform> accept_transformation(Reader& reader) {
  if (reader.accept(Word::kTranslate)) return Transform::translate(reader.vector());
  if (reader.accept(Word::kRotate)) return Transform::rotate(reader.vector());
  if (reader.accept(Word::kScale)) return Transform::scale(scale_factors(reader));
  if (reader.accept(Word::kMatrix)) return parse_matrix(reader);
  if (reader.accept(Word::kTransform)) return parse_transform(reader);
  return std::nullopt;
}

Transform parse_transform(Reader& reader) {
  if (const auto named = reader.accept_identifier<TransformPtr>()) return (*named)->as_matrix();
  reader.open(Word::kTransform);
  Transform composed;
  bool inverse = false;
  while (true) {
    if (reader.accept(Word::kInverse)) inverse = true;
    else if (const auto named = reader.accept_identifier<TransformPtr>()) composed = composed.then(**named);
    else if (auto written = accept_transformation(reader)) composed = composed.then(*written);
    else break;
  }
  reader.close(Word::kTransform);
  return (inverse ? composed.inverse() : composed).as_matrix();
}

}  // namespace lute
