// Editing textures that are values: layering, moving, changing the top layer (specification chapter 11 §9.1).
// Shared textures are never changed: each function makes a new one.
#pragma once

#include "parser/reader.hpp"

namespace lute {

bool is_plain(const Texture& texture);  // layers, not a pattern of textures

PigmentPtr moved(const PigmentPtr& pigment, const Transform& transform);
NormalPtr moved(const NormalPtr& normal, const Transform& transform);  // null stays null
TexturePtr moved(const TexturePtr& texture, const Transform& transform);
MediaPtr moved(const MediaPtr& media, const Transform& transform);  // its densities

// Called before a texture with all its layers is made anew: textures of many layers can double at each step.
void charge_layers(Reader& reader, const Texture& texture);

// The placement goes into the texture's own chains, so that what is written next is not moved by it.
void fold_placement(TextureOnObject& texture);

// `top` over `below`; null `below`: `top` alone. Patterned textures neither have nor are layers.
TexturePtr layered(Reader& reader, const TexturePtr& below, const TexturePtr& top);

// Adds a layer to what an object or a material has.
void add_texture(Reader& reader, TextureOnObject& on_object, const TexturePtr& texture);

}  // namespace lute
