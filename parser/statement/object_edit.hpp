// Changing objects that are values (specification chapter 11 §7.1, §8).
#pragma once

#include <optional>

#include "parser/reader.hpp"

namespace lute {

// Moves the shape with its bounds and clips, lights, and the textures and media that the object has so far.
void transform_object(Object& object, const Transform& transform);
ObjectPtr transformed(const ObjectPtr& object, const Transform& transform);

bool is_light(const Object& object);
bool carries_texture(const Object& object);  // or one of its parts does

// What the operation of a CSG is once `inverse` is taken into account: that of a union is then an intersection, of the others a
// merge. Nothing for other objects.
std::optional<CsgOperation> effective_operation(const Object& object);

// Something that the renderer has no shape for: parsed, then left out wherever objects are listed.
Object absent_object();
bool is_absent(const Object& object);

}  // namespace lute
