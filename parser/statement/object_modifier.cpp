#include "parser/statement/object_modifier.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/scene/contents.hpp"
#include "parser/expression/expression.hpp"
#include "parser/session.hpp"
#include "parser/statement/interior.hpp"
#include "parser/statement/object.hpp"
#include "parser/statement/object_edit.hpp"
#include "parser/statement/photons.hpp"
#include "parser/statement/texture.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

// What one block keeps while its modifiers are read.
struct Modifiers {
  Object& object;
  bool clips_linked = false, bounds_linked = false;
};

// Changes that reach the parts of an object make all of them anew, also those that it shares with others.
void charge_parts(Reader& reader, double count) {
  constexpr double kMost = 1e18;  // bytes, far from what any machine has
  constexpr double kPart = sizeof(Object) + sizeof(ObjectExtras);
  reader.session().resources.charge(static_cast<std::uint64_t>(std::min(count * kPart, kMost)));
}
void charge_parts(Reader& reader, const Object& object) {
  if (object.csg() != nullptr) charge_parts(reader, object.csg()->contents.leaves);
}
// By a transformation: parts with media, clips and bounds.
void charge_moved(Reader& reader, const Object& object) {
  if (object.csg() != nullptr && object.csg()->contents.media_densities) charge_parts(reader, object);
  if (!object.extras.is_default() && object.extras->limits.leaves > 0) charge_parts(reader, object.extras->limits.leaves);
}

bool accept_object_transformation(Reader& reader, Object& object) {
  const auto transform = accept_transformation(reader);
  if (!transform) return false;
  charge_moved(reader, object);
  transform_object(object, *transform);
  return true;
}

void parse_object_material(Reader& reader, Object& object) {
  Material material{object.texture, object.extras->interior_texture, object.extras->interior};
  parse_material(reader, material, object.uv_mapping);
  object.texture = std::move(material.texture);
  if (material.interior_texture.texture == nullptr && material.interior == object.extras->interior) return;
  ObjectExtras& extras = object.extras.edit();
  extras.interior_texture = std::move(material.interior_texture);
  extras.interior = std::move(material.interior);
}

bool accept_appearance(Reader& reader, Object& object) {
  if (reader.accept(Word::kTexture)) {
    add_texture(reader, object.texture, parse_texture(reader));
  } else if (reader.accept(Word::kInteriorTexture)) {
    add_texture(reader, object.extras.edit().interior_texture, parse_interior_texture(reader));
  } else if (reader.accept(Word::kInterior)) {
    const InteriorPtr before = object.extras->interior;
    object.extras.edit().interior = parse_interior(reader, before);
  } else if (reader.accept(Word::kMaterial)) {
    parse_object_material(reader, object);
  } else if (reader.accept(Word::kUvMapping)) {
    if (object.texture.texture != nullptr) reader.error("uv_mapping must be specified before texture.");
    object.uv_mapping = true;
  } else {
    return accept_layer_item(reader, object.texture);
  }
  return true;
}

// The objects of clipped_by or bounded_by, at their place.
std::vector<ObjectPtr> parse_limits(Reader& reader) {
  std::vector<ObjectPtr> objects;
  bool any = false;
  while (const auto object = accept_object(reader)) {
    any = true;
    if (carries_texture(**object) || is_patch(**object))
      reader.error("Illegal texture or patch in clip, bound or object pattern.");
    objects.push_back(*object);
  }
  if (!any) reader.error_expected("object");
  while (const auto transform = accept_transformation(reader))
    for (ObjectPtr& object : objects) object = transformed(object, *transform);
  return objects;
}

void append(std::vector<ObjectPtr>& to, std::vector<ObjectPtr> from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

Contents contents_of_limits(const ObjectExtras& extras) {
  Contents limits = contents_of(extras.clipped_by);
  const Contents bounds = contents_of(extras.bounded_by);
  limits.depth = std::max(limits.depth, bounds.depth);
  limits.leaves += bounds.leaves;
  return limits;
}

void parse_clipped_by(Reader& reader, Modifiers& m) {
  ObjectExtras& extras = m.object.extras.edit();
  reader.open(Word::kClippedBy);
  if (reader.accept(Word::kBoundedBy)) {
    if (!extras.clipped_by.empty()) reader.error("Cannot link bounds with previous clips.");
    extras.clipped_by = extras.bounded_by;
    m.clips_linked = true;
  } else {
    if (m.clips_linked) reader.error("Cannot add clips after linking bounds and clips.");
    append(extras.clipped_by, parse_limits(reader));
  }
  extras.limits = contents_of_limits(extras);
  reader.close(Word::kClippedBy);
}

void parse_bounded_by(Reader& reader, Modifiers& m) {
  ObjectExtras& extras = m.object.extras.edit();
  reader.open(Word::kBoundedBy);
  if (reader.accept(Word::kClippedBy)) {
    if (!extras.bounded_by.empty()) reader.error("Cannot link clips with previous bounds.");
    extras.bounded_by = extras.clipped_by;
    m.bounds_linked = true;
  } else {
    if (m.bounds_linked) reader.error("Cannot add bounds after linking bounds and clips.");
    append(extras.bounded_by, parse_limits(reader));
  }
  extras.limits = contents_of_limits(extras);
  reader.close(Word::kBoundedBy);
}

// A CSG takes its current parts along.
void set_double_illuminate(Object& object, bool on) {
  object.double_illuminate = on;
  if (object.csg() == nullptr) return;
  for (ObjectPtr& child : object.edit_csg()->children) {
    Object changed = *child;
    set_double_illuminate(changed, on);
    child = std::make_shared<const Object>(std::move(changed));
  }
}

void parse_radiosity(Reader& reader, Object& object) {
  reader.open(Word::kRadiosity);
  while (reader.accept(Word::kImportance)) {
    const double importance = reader.number();
    if (!(importance > 0 && importance <= 1)) reader.error("Radiosity importance must be greater than 0.0 and at most 1.0.");
    object.extras.edit().radiosity_importance = static_cast<float>(importance);
  }
  reader.close(Word::kRadiosity);
}

bool accept_flag(Reader& reader, Object& object) {
  if (reader.accept(Word::kNoShadow)) {
    object.no_shadow = true;
  } else if (reader.accept(Word::kNoImage)) {
    object.no_image = reader.optional_flag();
  } else if (reader.accept(Word::kNoReflection)) {
    object.no_reflection = reader.optional_flag();
  } else if (reader.accept(Word::kNoRadiosity)) {
    object.no_radiosity = reader.optional_flag();
  } else if (reader.accept(Word::kDoubleIlluminate)) {
    charge_parts(reader, object);
    set_double_illuminate(object, reader.optional_flag());
  } else if (reader.accept(Word::kHollow)) {
    object.hollow = reader.optional_flag();
  } else if (reader.accept(Word::kInverse)) {
    if (is_patch(object)) reader.warning("Cannot invert a patch object.");
    object.inverse = !object.inverse;
  } else {
    return false;
  }
  return true;
}

// Whether `has` says so of the object's shape, if it is one.
template <class Has>
bool shape_has(const Object& object, const Has& has) {
  return object.shape() != nullptr && object.shape()->visit(has);
}

void parse_sturm(Reader& reader, Modifiers& m) {
  const bool known = shape_has(m.object, [](const auto& s) { return requires { s.sturm; }; });
  if (!known) reader.error("Keyword 'sturm' cannot be used with this object.");
  const bool on = reader.optional_flag();
  m.object.edit_shape()->edit([&](auto& s) {
    if constexpr (requires { s.sturm; }) s.sturm = on;
  });
}

void parse_hierarchy(Reader& reader, Modifiers& m) {
  const bool known = shape_has(m.object, [](const auto& s) {
    return requires { s.hierarchy; } || s.kKeyword == "height_field";
  });
  if (!known) reader.error("Keyword 'hierarchy' cannot be used with this object.");
  const bool on = reader.optional_flag();
  m.object.edit_shape()->edit([&](auto& s) {
    if constexpr (requires { s.hierarchy; }) s.hierarchy = on;
  });
}

void parse_split_union(Reader& reader, Object& object) {
  if (object.shape_if<Text>() != nullptr) {  // one shape here, a union of characters to the language
    reader.integer();
    return;
  }
  const auto operation = effective_operation(object);
  if (operation != CsgOperation::kUnion && operation != CsgOperation::kMerge)
    reader.error("split_union found in non-union object.");
  const bool on = reader.integer() != 0;
  object.edit_csg()->split_union = on;
}

void parse_cutaway_textures(Reader& reader, Object& object) {
  const auto operation = effective_operation(object);
  if (operation != CsgOperation::kIntersection && operation != CsgOperation::kDifference)
    reader.error("cutaway_textures can only be used with intersection and difference.");
  object.edit_csg()->cutaway_textures = true;
}

bool accept_special(Reader& reader, Modifiers& m) {
  if (reader.accept(Word::kClippedBy)) {
    parse_clipped_by(reader, m);
  } else if (reader.accept(Word::kBoundedBy)) {
    parse_bounded_by(reader, m);
  } else if (reader.accept(Word::kSturm)) {
    parse_sturm(reader, m);
  } else if (reader.accept(Word::kHierarchy)) {
    parse_hierarchy(reader, m);
  } else if (reader.accept(Word::kSplitUnion)) {
    parse_split_union(reader, m.object);
  } else if (reader.accept(Word::kCutawayTextures)) {
    parse_cutaway_textures(reader, m.object);
  } else if (reader.accept(Word::kPhotons)) {
    parse_object_photons(reader, m.object);
  } else if (reader.accept(Word::kRadiosity)) {
    parse_radiosity(reader, m.object);
  } else if (is_written_color(reader.peek())) {
    reader.color();
    reader.warning("Quick color belongs in texture. Color ignored.");
  } else if (reader.accept(Word::kDtag)) {
    reader.string();
  } else if (reader.accept(Word::kLightSource)) {
    reader.error("Light source must be defined using new syntax.");
  } else {
    return false;
  }
  return true;
}

}  // namespace

void parse_object_modifiers(Reader& reader, Object& object) {
  Modifiers m{object};
  while (accept_object_transformation(reader, object) || accept_appearance(reader, object) || accept_flag(reader, object) ||
         accept_special(reader, m)) {
  }
  if (object.extras->interior_texture.texture != nullptr && object.texture.texture == nullptr)
    reader.error("Interior texture requires an exterior texture.");
}

}  // namespace lute
