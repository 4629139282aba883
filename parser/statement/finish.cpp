#include "parser/statement/finish.hpp"

#include <cmath>

namespace lute {
namespace {

float real(Reader& reader) { return static_cast<float>(reader.number()); }

float optional_real(Reader& reader, float when_missing) {
  const auto value = reader.optional_number();
  return value ? static_cast<float>(*value) : when_missing;
}

struct Albedo {
  bool diffuse = false, phong = false, specular = false;
};

void parse_diffuse(Reader& reader, Finish& finish, Albedo& albedo) {
  if (reader.accept(Word::kAlbedo)) albedo.diffuse = true;
  finish.diffuse = real(reader);
  reader.comma();
  finish.diffuse_back = optional_real(reader, 0);
  finish.raw_diffuse = finish.diffuse;
  finish.raw_diffuse_back = finish.diffuse_back;
}

void parse_reflection_block(Reader& reader, Finish& finish) {
  reader.open(Word::kReflection);
  finish.reflection_max = finish.reflection_min = reader.rgb();
  reader.comma();
  const bool range = reader.at_color();
  if (range) finish.reflection_max = reader.rgb();
  while (true) {
    if (reader.accept(Word::kFresnel)) {
      const double value = std::trunc(reader.optional_number().value_or(1));
      if (value != 0 && value != 1) reader.error("fresnel must be true or false");
      finish.reflection_fresnel = value == 1;
      if (!range && finish.reflection_fresnel) finish.reflection_min = Rgb(0.0f);
    } else if (reader.accept(Word::kFalloff)) {
      finish.reflection_falloff = real(reader);
    } else if (reader.accept(Word::kExponent)) {
      finish.reflection_exponent = 1 / real(reader);
    } else if (reader.accept(Word::kMetallic)) {
      finish.reflection_metallic = optional_real(reader, 1);
    } else {
      break;
    }
  }
  reader.close(Word::kReflection);
}

void parse_reflection(Reader& reader, Finish& finish) {
  if (reader.at(TokenKind::kLeftBrace)) {
    parse_reflection_block(reader, finish);
  } else {
    finish.reflection_falloff = 1;
    finish.reflection_fresnel = false;
    finish.reflection_max = finish.reflection_min = reader.rgb();
  }
}

void parse_irid(Reader& reader, Finish& finish) {
  reader.open(Word::kIrid);
  finish.irid = real(reader);
  while (true) {
    if (reader.accept(Word::kThickness)) finish.irid_thickness = real(reader);
    else if (reader.accept(Word::kTurbulence)) finish.irid_turbulence = static_cast<float>(reader.vector().x);
    else break;
  }
  reader.close(Word::kIrid);
}

void parse_subsurface(Reader& reader, Finish& finish) {
  reader.open(Word::kSubsurface);
  while (true) {
    if (reader.accept(Word::kTranslucency)) finish.subsurface_translucency = reader.rgb();
    else if (reader.accept(Word::kAnisotropy)) finish.subsurface_anisotropy = reader.rgb();
    else break;
  }
  reader.close(Word::kSubsurface);
  finish.subsurface = true;
}

bool accept_highlight(Reader& reader, Finish& finish, Albedo& albedo) {
  if (reader.accept(Word::kPhong)) {
    if (reader.accept(Word::kAlbedo)) albedo.phong = true;
    finish.phong = real(reader);
  } else if (reader.accept(Word::kPhongSize)) {
    finish.phong_size = real(reader);
  } else if (reader.accept(Word::kSpecular)) {
    if (reader.accept(Word::kAlbedo)) albedo.specular = true;
    finish.specular = real(reader);
  } else if (reader.accept(Word::kRoughness)) {
    const float roughness = real(reader);
    if (roughness == 0) reader.warning("Zero roughness used.");
    finish.specular_exponent = roughness == 0 ? 0 : 1 / roughness;
  } else if (reader.accept(Word::kMetallic)) {
    finish.metallic = optional_real(reader, 1);
  } else {
    return false;
  }
  return true;
}

// Forms of older versions: the object's interior gets these values when its statement ends.
bool accept_interior_value(Reader& reader, Finish& finish) {
  if (reader.accept(Word::kIor)) finish.ior = real(reader);
  else if (reader.accept(Word::kCaustics)) finish.caustics = real(reader);
  else if (reader.accept(Word::kRefraction)) finish.refraction = real(reader);
  else return false;
  reader.warning("Index of refraction, caustics and refraction belong in an interior statement.", 310);
  return true;
}

bool accept_item(Reader& reader, Finish& finish, Albedo& albedo) {
  if (reader.accept(Word::kAmbient)) finish.ambient = reader.rgb();
  else if (reader.accept(Word::kEmission)) finish.emission = reader.rgb();
  else if (reader.accept(Word::kDiffuse)) parse_diffuse(reader, finish, albedo);
  else if (reader.accept(Word::kBrilliance)) finish.brilliance = real(reader);
  else if (reader.accept(Word::kCrand)) finish.crand = real(reader);
  else if (reader.accept(Word::kConserveEnergy)) finish.conserve_energy = true;
  else if (reader.accept(Word::kReflection)) parse_reflection(reader, finish);
  else if (reader.accept(Word::kReflectionExponent)) finish.reflection_exponent = 1 / real(reader);
  else if (reader.accept(Word::kIrid)) parse_irid(reader, finish);
  else if (reader.accept(Word::kSubsurface)) parse_subsurface(reader, finish);
  else return accept_highlight(reader, finish, albedo) || accept_interior_value(reader, finish);
  return true;
}

// Scales what was given as `albedo`, so that it is the part of the light that leaves the surface (chapter 40 §6).
void apply_albedo(Finish& finish, const Albedo& albedo) {
  if (albedo.diffuse) {
    finish.diffuse *= (finish.brilliance + 1) * 0.5f;
    finish.diffuse_back *= (finish.brilliance + 1) * 0.5f;
  }
  if (albedo.phong) finish.phong *= (finish.phong_size + 1) * 0.5f;
  if (albedo.specular) {
    const double exponent = finish.specular_exponent;
    finish.specular = static_cast<float>(finish.specular * (exponent + 2) / (4 * (2 - std::pow(2.0, -exponent / 2))));
  }
}

}  // namespace

FinishPtr parse_finish(Reader& reader, const FinishPtr& base) {
  reader.open(Word::kFinish);
  const auto named = reader.accept_identifier<FinishPtr>();
  Finish finish = named ? **named : *base;
  Albedo albedo;
  bool edited = false;
  while (accept_item(reader, finish, albedo)) edited = true;
  reader.close(Word::kFinish);
  if (named && !edited) return *named;
  apply_albedo(finish, albedo);
  return std::make_shared<const Finish>(finish);
}

}  // namespace lute
