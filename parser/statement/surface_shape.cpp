#include "parser/statement/surface_shape.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace lute {

namespace {

// `contained_by { box { corner, corner } | sphere { center, radius } }`; the keyword was taken.
Container parse_container(Reader& reader) {
  Container container;
  reader.open(Word::kContainedBy);
  if (reader.accept(Word::kBox)) {
    reader.open(Word::kBox);
    const dvec3 a = reader.vector();
    reader.comma();
    const dvec3 b = reader.vector();
    reader.close(Word::kBox);
    container.lo = glm::min(a, b);
    container.hi = glm::max(a, b);
  } else if (reader.accept(Word::kSphere)) {
    reader.open(Word::kSphere);
    container.is_sphere = true;
    container.center = reader.vector();
    reader.comma();
    container.radius = reader.number();
    reader.close(Word::kSphere);
  } else {
    reader.error_expected("box or sphere");
  }
  reader.close(Word::kContainedBy);
  return container;
}

void parse_patch_type(Reader& reader, int& type) {
  type = reader.integer();
  if (type > 1) {
    reader.warning("Patch type no longer supported. Using type 1.");
    type = 1;
  }
}

// The old form: type, [flatness for types 2 and 3], u_steps, v_steps as bare numbers, with no commas between them.
void parse_old_patch_head(Reader& reader, BicubicPatch& patch, int& type) {
  reader.warning("Should use keywords for bicubic parameters.");
  type = reader.integer();
  patch.flatness = 0.1;
  if (type == 2 || type == 3) {
    patch.flatness = reader.number();
    reader.warning("Patch type no longer supported. Using type 1.");
    type = 1;
  }
  patch.u_steps = reader.integer();
  patch.v_steps = reader.integer();
  reader.comma();
}

void parse_patch_head(Reader& reader, BicubicPatch& patch, int& type) {
  while (true) {
    if (reader.accept(Word::kType)) {
      parse_patch_type(reader, type);
    } else if (reader.accept(Word::kFlatness)) {
      patch.flatness = reader.number();
    } else if (reader.accept(Word::kUSteps)) {
      patch.u_steps = reader.integer();
    } else if (reader.accept(Word::kVSteps)) {
      patch.v_steps = reader.integer();
    } else if (reader.accept(Word::kAccuracy)) {
      reader.number();
    } else if (reader.accept(Word::kUvVectors)) {
      for (dvec2& uv : patch.corner_uv) {
        uv = reader.vector2();
        reader.comma();
      }
      return;
    } else {
      if (reader.at(TokenKind::kNumber)) parse_old_patch_head(reader, patch, type);  // the reference takes it up here too
      return;
    }
  }
}

}  // namespace

Polygon parse_polygon(Reader& reader) {
  Polygon polygon;
  const int count = reader.integer();
  if (count < 3) reader.error("Polygon needs at least three points.");
  for (int i = 0; i < count; ++i) {
    reader.comma();
    polygon.points.push_back(reader.vector());
  }
  if (!polygon_is_closed(polygon)) reader.warning("Polygon not closed. Closing it.");
  return polygon;
}

BicubicPatch parse_bicubic_patch(Reader& reader) {
  BicubicPatch patch;
  int type = -1;
  if (reader.at_number()) {
    parse_old_patch_head(reader, patch, type);
  } else {
    parse_patch_head(reader, patch, type);
  }
  if (type < 0) reader.error("Undefined bicubic patch type.");
  for (auto& row : patch.points) {
    for (dvec3& point : row) {
      reader.comma();
      point = reader.vector();
    }
  }
  reader.comma();
  return patch;
}

Isosurface parse_isosurface(Reader& reader) {
  Isosurface iso;
  reader.expect(Word::kFunction);
  iso.function = reader.float_function();
  while (true) {
    if (reader.accept(Word::kContainedBy)) {
      iso.container = parse_container(reader);
    } else if (reader.accept(Word::kThreshold)) {
      iso.threshold = reader.number();
    } else if (reader.accept(Word::kAccuracy)) {
      iso.accuracy = reader.number();
      if (iso.accuracy <= 0) {
        reader.warning("Isosurface 'accuracy' must be positive. Using 0.001 instead.");
        iso.accuracy = 0.001;
      }
    } else if (reader.accept(Word::kMaxGradient)) {
      iso.max_gradient = reader.number();
      if (iso.max_gradient <= 0) {
        reader.warning("Isosurface 'max_gradient' must be positive. Using 1.1 instead.");
        iso.max_gradient = 1.1;
      }
    } else if (reader.accept(Word::kMaxTrace)) {
      const int count = reader.integer();
      if (count > 10 || count < 1) reader.warning("Isosurface 'max_trace' must lie between 1 and 10.");
      iso.max_trace = std::clamp(count, 1, 10);
    } else if (reader.accept(Word::kAllIntersections)) {
      iso.max_trace = 10;
    } else if (reader.accept(Word::kEvaluate)) {
      iso.evaluate.emplace();
      for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) reader.comma();
        (*iso.evaluate)[i] = reader.number();
      }
    } else if (reader.accept(Word::kOpen)) {
      iso.open = true;
    } else {
      return iso;
    }
  }
}

Parametric parse_parametric(Reader& reader) {
  Parametric parametric;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) reader.comma();
    reader.expect(Word::kFunction);
    parametric.functions[i] = reader.float_function();
  }
  const dvec2 a = reader.vector2();
  reader.comma();
  const dvec2 b = reader.vector2();
  parametric.lo = glm::min(a, b);
  parametric.hi = glm::max(a, b);
  while (true) {
    if (reader.accept(Word::kAccuracy)) {
      parametric.accuracy = reader.number();
    } else if (reader.accept(Word::kMaxGradient)) {
      parametric.max_gradient = reader.number();
    } else if (reader.accept(Word::kContainedBy)) {
      parametric.container = parse_container(reader);
    } else if (reader.accept(Word::kPrecompute)) {
      const int depth = reader.integer();
      bool any = false;
      for (const Word axis : {Word::kX, Word::kY, Word::kZ}) {
        reader.comma();
        any |= reader.accept(axis);
      }
      if (any && (depth < 1 || depth > 20)) reader.error("Precompute: invalid depth");
    } else {
      return parametric;
    }
  }
}

}  // namespace lute
