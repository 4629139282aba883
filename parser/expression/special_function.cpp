// Functions that take strings, names, arrays or objects. Source: specification chapter 10 §8.1, §8.3.
#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "engine/scene/contents.hpp"
#include "parser/directives/directive.hpp"
#include "parser/expression/recorder.hpp"
#include "parser/value/array.hpp"

namespace lute {

namespace {

double compare_units(const std::u16string& a, const std::u16string& b) {
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (a[i] != b[i]) return static_cast<double>(a[i]) - static_cast<double>(b[i]);
  }
  if (a.size() == b.size()) return 0;
  return a.size() > b.size() ? a[common] : -static_cast<double>(b[common]);
}

GeometryQuery& geometry(Session& session) {
  if (session.options.geometry == nullptr) session.fail("Objects cannot be asked here: no engine is connected.", "no-geometry");
  return *session.options.geometry;
}

ObjectPtr object_argument(Session& session) {
  const std::optional<ObjectPtr> object = session.reader.accept_identifier<ObjectPtr>();
  if (!object) session.fail_at("Object identifier expected.", "object-expected", session.stream.peek());
  session.reader.comma();
  return *object;
}

double inside(Session& session) {
  const ObjectPtr object = object_argument(session);
  const dvec3 point = vector_argument(session);
  if (is_patch(*object)) session.fail("Solid object identifier expected.", "object-expected");
  return geometry(session).inside(object, point) ? 1 : 0;
}

Number trace(Session& session) {
  const ObjectPtr object = object_argument(session);
  const dvec3 origin = vector_argument(session);
  session.reader.comma();
  const dvec3 direction = vector_argument(session);
  session.reader.comma();
  Slot normal;
  if (!session.reader.at(TokenKind::kRightParen)) {
    const Item item = session.reader.take();
    const Number* number = item.slot ? item.slot->get_if<Number>() : nullptr;
    if (number == nullptr || number->count != 3) session.fail_expected("vector identifier", item);
    normal = item.slot;
  }
  const auto hit = geometry(session).trace(object, origin, glm::normalize(direction));
  if (normal) *normal = Number(hit ? hit->normal : dvec3(0));
  return Number(hit ? hit->point : dvec3(0));
}

Number extent(Session& session, bool maximum) {
  if (maximum) {
    if (const auto pigment = session.reader.accept_identifier<PigmentPtr>()) {
      const std::optional<dvec2> size = geometry(session).image_size(*pigment);
      if (!size) session.fail("The parameter to max_extent must be an image map pigment identifier", "image-expected");
      return Number(dvec3(*size, 0));
    }
  }
  const ObjectPtr object = object_argument(session);
  const Aabb box = geometry(session).extent(object);
  return Number(maximum ? box.hi : box.lo);
}

Number array_function(Session& session, Word word) {
  const Item item = session.reader.take();
  const ArrayPtr* const value = item.slot ? item.slot->get_if<ArrayPtr>() : nullptr;
  if (value == nullptr) session.fail_expected("array identifier", item);
  const ArrayPtr array = *value;
  if (word == Word::kDimensions) {
    stop_recording(session);
    return Number(static_cast<double>(array->sizes.size()));
  }
  session.reader.comma();
  const std::int32_t dimension = to_int32(float_argument(session, Level::kAdditive));
  if (item.subscripts > 0) {
    stop_recording(session);
  } else {
    record(session, {CodeOp::kDimensionSize, 0, 0, item.token.index});
  }
  const bool exists = dimension >= 1 && static_cast<std::size_t>(dimension) <= array->sizes.size();
  return Number(exists ? array->sizes[static_cast<std::size_t>(dimension - 1)] : 0);
}

double string_function(Session& session, Word word) {
  const std::u16string text = parse_string(session);
  switch (word) {
    case Word::kAsc: return text.empty() ? 0 : text[0];
    case Word::kStrlen: return static_cast<double>(text.size());
    case Word::kVal: return std::strtod(to_bytes(session, text).c_str(), nullptr);
    case Word::kFileExists: return find_scene_file(session, to_bytes(session, text), {}) ? 1 : 0;
    default: {
      session.reader.comma();
      return compare_units(text, parse_string(session));
    }
  }
}

}  // namespace

bool parse_special_function(Session& session, Word word, Number& result) {
  if (word == Word::kDefined) {
    stop_recording(session);
    open_paren(session);
    result = Number(is_defined(session) ? 1.0 : 0.0);
    close_paren(session);
    return true;
  }
  open_call(session);
  switch (word) {
    case Word::kDimensions:
    case Word::kDimensionSize: result = array_function(session, word); break;
    case Word::kInside: stop_recording(session); result = Number(inside(session)); break;
    case Word::kTrace: stop_recording(session); result = trace(session); break;
    case Word::kMinExtent: stop_recording(session); result = extent(session, false); break;
    case Word::kMaxExtent: stop_recording(session); result = extent(session, true); break;
    default: stop_recording(session); result = Number(string_function(session, word)); break;
  }
  close_call(session);
  return true;
}

}  // namespace lute
