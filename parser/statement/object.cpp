#include "parser/statement/object.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/scene/contents.hpp"
#include "parser/statement/light.hpp"
#include "parser/statement/object_edit.hpp"
#include "parser/statement/object_modifier.hpp"
#include "parser/statement/primitive.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

std::optional<CsgOperation> csg_operation(Word word) {
  switch (word) {
    case Word::kUnion:
    case Word::kComposite: return CsgOperation::kUnion;
    case Word::kMerge: return CsgOperation::kMerge;
    case Word::kIntersection: return CsgOperation::kIntersection;
    case Word::kDifference: return CsgOperation::kDifference;
    default: return std::nullopt;
  }
}

const Primitive* find_primitive(Word word) {
  const auto table = primitives();
  const auto found = std::ranges::find(table, word, &Primitive::word);
  return found == table.end() ? nullptr : &*found;
}

ObjectPtr finished(Reader& reader, Object object, Word keyword) {
  parse_object_modifiers(reader, object);
  reader.close(keyword);
  return shared(reader, std::move(object));
}

// `keyword { IDENTIFIER modifiers }`, whatever the type of the object: the brace was read.
std::optional<ObjectPtr> accept_named_object(Reader& reader, Word keyword) {
  const auto named = reader.accept_identifier<ObjectPtr>();
  if (!named) return std::nullopt;
  return finished(reader, **named, keyword);
}

// A combination of nothing counts: a union of nothing has no inside, an intersection of nothing no outside.
std::vector<ObjectPtr> parse_members(Reader& reader, CsgOperation operation) {
  std::vector<ObjectPtr> members;
  std::size_t count = 0;
  while (const auto member = accept_object(reader)) {
    ++count;
    const bool solid_only = operation == CsgOperation::kIntersection || operation == CsgOperation::kDifference;
    if (solid_only && is_patch(**member))
      reader.warning("Patch objects not allowed in intersection.");
    members.push_back(*member);
  }
  // What belongs in no combination is told as the error that it is, alone.
  const bool goes_on = reader.at(TokenKind::kRightBrace) || reader.word() != Word::kNone;
  if (count < 2 && goes_on) reader.warning("Should have at least 2 objects in csg.");
  return members;
}

// Light sources take no part in whether the union casts a shadow.
bool casts_no_shadow(const std::vector<ObjectPtr>& members) {
  return !members.empty() &&
         std::ranges::all_of(members, [](const ObjectPtr& member) { return member->no_shadow || is_light(*member); });
}

ObjectPtr parse_csg(Reader& reader, Word keyword, CsgOperation operation) {
  Object object;
  object.where = reader.location();
  reader.open(keyword);
  if (auto named = accept_named_object(reader, keyword)) return *named;
  if (keyword == Word::kComposite) reader.warning("Use union instead of composite.");
  Csg csg;
  csg.operation = operation;
  csg.children = parse_members(reader, operation);
  csg.contents = contents_of(csg.children);
  object.no_shadow = operation == CsgOperation::kUnion && casts_no_shadow(csg.children);
  object.geometry = Shared(std::move(csg));
  return finished(reader, std::move(object), keyword);
}

ObjectPtr parse_primitive(Reader& reader, const Primitive& primitive) {
  Object object;
  object.where = reader.location();
  reader.open(primitive.word);
  if (auto named = accept_named_object(reader, primitive.word)) return *named;
  object.geometry = primitive.parse(reader);
  return finished(reader, std::move(object), primitive.word);
}

ObjectPtr parse_object_block(Reader& reader) {
  reader.open(Word::kObject);
  const auto inner = accept_object(reader);
  if (!inner) reader.error_expected("object");
  return finished(reader, **inner, Word::kObject);
}

ObjectPtr parse_light(Reader& reader) {
  const SourceLocation where = reader.location();
  reader.open(Word::kLightSource);
  if (auto named = accept_named_object(reader, Word::kLightSource)) return *named;
  Object object;
  object.where = where;
  LightSource light = parse_light_items(reader);
  light.where = where;
  reader.close(Word::kLightSource);
  object.geometry = Shared(std::move(light));
  return shared(reader, std::move(object));
}

// photons { ... } of a light_group hold for the group as for an object.
ObjectPtr parse_light_group(Reader& reader) {
  Object object;
  object.where = reader.location();
  reader.open(Word::kLightGroup);
  Csg group;
  group.operation = CsgOperation::kLightGroup;
  while (const auto member = accept_object(reader))
    if (!is_absent(**member)) group.children.push_back(*member);
  group.contents = contents_of(group.children);
  object.geometry = Shared(std::move(group));
  parse_light_group_items(reader, object);
  reader.close(Word::kLightGroup);
  return shared(reader, std::move(object));
}

}  // namespace

std::optional<ObjectPtr> accept_object(Reader& reader) {
  if (const auto named = reader.accept_identifier<ObjectPtr>()) return named;
  const Word word = reader.word();
  if (word == Word::kNone) return std::nullopt;
  const Primitive* primitive = find_primitive(word);
  const auto operation = csg_operation(word);
  const bool other = word == Word::kObject || word == Word::kLightSource || word == Word::kLightGroup;
  if (primitive == nullptr && !operation && !other) return std::nullopt;
  NestingGuard guard(reader);
  reader.take();
  if (primitive != nullptr) return parse_primitive(reader, *primitive);
  if (operation) return parse_csg(reader, word, *operation);
  if (word == Word::kObject) return parse_object_block(reader);
  if (word == Word::kLightSource) return parse_light(reader);
  return parse_light_group(reader);
}

ObjectPtr parse_mesh_object(Reader& reader) {
  NestingGuard guard(reader);
  return parse_primitive(reader, *find_primitive(Word::kMesh));
}

const std::vector<Word>& object_words() {
  static const std::vector<Word> words = [] {
    std::vector<Word> all = {Word::kUnion,  Word::kComposite,   Word::kMerge,     Word::kIntersection, Word::kDifference,
                             Word::kObject, Word::kLightSource, Word::kLightGroup};
    for (const Primitive& primitive : primitives()) all.push_back(primitive.word);
    return all;
  }();
  return words;
}

}  // namespace lute
