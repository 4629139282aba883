#include "parser/statement/simple_shape.hpp"
#include "parser/statement/texture.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

constexpr std::size_t kMaxComponents = 1'000'000;

void parse_radius_and_strength(Reader& reader, BlobComponent& component) {
  component.radius = reader.number();
  reader.comma();
  reader.accept(Word::kStrength);
  component.strength = reader.number();
}

// A sphere that stays one is moved itself, as in the reference: where an ellipsoid comes from shows in its box (max_extent).
void move(BlobComponent& component, const Transform& transform) {
  constexpr unsigned kSimilar = Transform::kTranslate | Transform::kRotate | Transform::kUniformScale;
  const bool similar = (transform.kinds & ~kSimilar) == 0 && component.transform.identity();
  if (component.kind != BlobComponent::Kind::kSphere || !similar) {
    component.transform = component.transform.then(transform);
    return;
  }
  component.center = transform.point(component.center);
  if ((transform.kinds & Transform::kUniformScale) != 0) component.radius *= glm::length(transform.linear[0]);
}

void parse_component_modifiers(Reader& reader, BlobComponent& component) {
  TextureOnObject texture;
  while (true) {
    if (const auto transform = accept_transformation(reader)) {
      move(component, *transform);
      texture.placement = texture.placement.then(*transform);
    } else if (reader.accept(Word::kTexture)) {
      add_texture(reader, texture, parse_texture(reader));
    } else if (!accept_layer_item(reader, texture)) {
      break;
    }
  }
  component.texture = texture.texture;
  if (texture.texture != nullptr) component.texture_placement = texture.placement;
}

BlobComponent parse_sphere_component(Reader& reader) {
  BlobComponent component;
  reader.open(Word::kSphere);
  component.center = reader.vector();
  reader.comma();
  parse_radius_and_strength(reader, component);
  parse_component_modifiers(reader, component);
  reader.close(Word::kSphere);
  return component;
}

BlobComponent parse_cylinder_component(Reader& reader) {
  BlobComponent component;
  component.kind = BlobComponent::Kind::kCylinder;
  reader.open(Word::kCylinder);
  component.center = reader.vector();
  reader.comma();
  component.apex = reader.vector();
  reader.comma();
  parse_radius_and_strength(reader, component);
  if (glm::length(component.apex - component.center) < kEpsilon) reader.error("Degenerate cylindrical component in blob.");
  parse_component_modifiers(reader, component);
  reader.close(Word::kCylinder);
  return component;
}

// component strength, radius, <center>: the oldest form
BlobComponent parse_bare_component(Reader& reader) {
  BlobComponent component;
  component.strength = reader.number();
  reader.comma();
  component.radius = reader.number();
  reader.comma();
  component.center = reader.vector();
  return component;
}

}  // namespace

Blob parse_blob(Reader& reader) {
  Blob blob;
  while (true) {
    if (reader.accept(Word::kThreshold)) blob.threshold = reader.number();
    else if (reader.accept(Word::kSphere)) blob.components.push_back(parse_sphere_component(reader));
    else if (reader.accept(Word::kCylinder)) blob.components.push_back(parse_cylinder_component(reader));
    else if (reader.accept(Word::kComponent)) blob.components.push_back(parse_bare_component(reader));
    else break;
    if (blob.components.size() >= kMaxComponents) reader.error("There are too many components in a blob.");
  }
  if (blob.components.empty()) reader.error("Need at least one component in a blob.");
  return blob;
}

}  // namespace lute
