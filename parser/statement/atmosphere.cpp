#include "parser/statement/atmosphere.hpp"

#include <cmath>
#include <string>

#include "parser/statement/blend_map.hpp"
#include "parser/statement/pattern.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/transformation.hpp"
#include "parser/statement/warp.hpp"

namespace lute {
namespace {

Turbulence& fog_turbulence(Fog& fog) {
  if (!fog.turbulence) fog.turbulence.emplace();
  return *fog.turbulence;
}

bool at_turbulence(Reader& reader) {
  return reader.at(Word::kTurbulence) || reader.at(Word::kOctaves) || reader.at(Word::kOmega) || reader.at(Word::kLambda);
}

void parse_fog_type(Reader& reader, Fog& fog) {
  fog.type = reader.integer();
  if (fog.type == 1 || fog.type == 2) return;
  reader.warning("Illegal fog_type: it must be 1 or 2.");
  fog.type = 1;
}

// Transformations turn the present up vector at once.
bool accept_fog_transformation(Reader& reader, Fog& fog) {
  if (reader.accept(Word::kTranslate)) {
    reader.vector();
    reader.warning("A translate in a fog has no effect.");
    return true;
  }
  if (reader.accept(Word::kScale)) {  // as it is, zero or not
    fog.up *= reader.vector();
    return true;
  }
  const auto transform = accept_transformation(reader);
  if (!transform) return false;
  fog.up = transform->direction(fog.up);
  return true;
}

bool accept_fog_item(Reader& reader, Fog& fog) {
  if (at_color_word(reader)) fog.color = reader.color();
  else if (reader.accept(Word::kDistance)) fog.distance = reader.number();
  else if (reader.accept(Word::kFogType)) parse_fog_type(reader, fog);
  else if (reader.accept(Word::kFogAlt)) fog.altitude = reader.number();
  else if (reader.accept(Word::kFogOffset)) fog.offset = reader.number();
  else if (reader.accept(Word::kUp)) fog.up = reader.vector();
  else if (reader.accept(Word::kTurbDepth)) fog.turbulence_depth = reader.number();
  else if (at_turbulence(reader)) accept_turbulence_item(reader, fog_turbulence(fog));
  else if (!accept_fog_transformation(reader, fog)) {
    if (reader.at(TokenKind::kLess) || !reader.at_number()) return false;
    fog.distance = reader.number();  // the oldest form
  }
  return true;
}

double parse_half_circle_angle(Reader& reader, const char* name) {
  const double angle = reader.number();
  if (angle < 0 || angle > 360) {
    reader.error("Illegal " + std::string(name) + " angle in rainbow (Use value from 0 to 360 degrees).");
  }
  return angle;
}

void check_rainbow(Reader& reader, const Rainbow& rainbow) {
  if (rainbow.arc_angle && rainbow.falloff_angle && *rainbow.arc_angle < *rainbow.falloff_angle)
    reader.error("Arc angle is smaller than falloff angle in rainbow.");
  if (glm::length(rainbow.direction) < kEpsilon) reader.error("Rainbow's direction vector is zero.");
  if (glm::length(rainbow.up) < kEpsilon) reader.error("Rainbow's up vector is zero.");
  const double cosine = std::abs(glm::dot(glm::normalize(rainbow.up), glm::normalize(rainbow.direction)));
  if (std::abs(1 - cosine) < kEpsilon) reader.error("Rainbow's up and direction vector are co-linear.");
}

bool accept_rainbow_item(Reader& reader, Rainbow& rainbow) {
  if (reader.accept(Word::kAngle)) rainbow.angle = reader.number();
  else if (reader.accept(Word::kWidth)) rainbow.width = reader.number();
  else if (reader.accept(Word::kDistance)) rainbow.distance = reader.number();
  else if (reader.accept(Word::kJitter)) rainbow.jitter = reader.number();
  else if (reader.accept(Word::kDirection)) rainbow.direction = reader.vector();
  else if (reader.accept(Word::kUp)) rainbow.up = reader.vector();
  else if (reader.accept(Word::kColorMap)) rainbow.colors = *parse_color_map(reader);
  else if (reader.accept(Word::kArcAngle)) rainbow.arc_angle = parse_half_circle_angle(reader, "arc");
  else if (reader.accept(Word::kFalloffAngle)) rainbow.falloff_angle = parse_half_circle_angle(reader, "falloff");
  else return false;
  return true;
}

}  // namespace

Color parse_background(Reader& reader) {
  reader.open(Word::kBackground);
  const Color color = reader.color();
  reader.close(Word::kBackground);
  return color;
}

SkySphere parse_sky_sphere(Reader& reader) {
  const SourceLocation where = reader.location();
  reader.open(Word::kSkySphere);
  SkySphere sky;
  if (const auto named = reader.accept_identifier<SkySpherePtr>()) sky = **named;
  sky.where = where;
  while (true) {
    if (reader.accept(Word::kPigment)) sky.pigments.push_back(parse_pigment(reader, std::make_shared<const Pigment>()));
    else if (reader.accept(Word::kEmission)) sky.emission = reader.rgb();
    else if (const auto transform = accept_transformation(reader)) sky.transform = sky.transform.then(*transform);
    else break;
  }
  reader.close(Word::kSkySphere);
  if (sky.pigments.empty()) reader.error("Empty sky_sphere statement.");
  return sky;
}

Fog parse_fog(Reader& reader) {
  const SourceLocation where = reader.location();
  reader.open(Word::kFog);
  Fog fog;
  if (const auto named = reader.accept_identifier<FogPtr>()) fog = **named;
  fog.where = where;
  while (accept_fog_item(reader, fog)) {
  }
  reader.close(Word::kFog);
  const double length = glm::length(fog.up);
  if (length > 0) fog.up /= length;
  return fog;
}

Rainbow parse_rainbow(Reader& reader) {
  const SourceLocation where = reader.location();
  reader.open(Word::kRainbow);
  Rainbow rainbow;
  if (const auto named = reader.accept_identifier<RainbowPtr>()) rainbow = **named;
  rainbow.where = where;
  while (accept_rainbow_item(reader, rainbow)) {
  }
  reader.close(Word::kRainbow);
  check_rainbow(reader, rainbow);
  return rainbow;
}

}  // namespace lute
