// The right-hand sides of #declare that are statements (specification chapter 11 §14.2).
#include "parser/statement/atmosphere.hpp"
#include "parser/statement/blend_map.hpp"
#include "parser/statement/camera.hpp"
#include "parser/statement/finish.hpp"
#include "parser/statement/interior.hpp"
#include "parser/statement/normal.hpp"
#include "parser/statement/object.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/statement.hpp"
#include "parser/statement/texture.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

// A parser that begins behind its keyword.
template <class Parse>
std::function<Value(Reader&)> after_keyword(Parse parse) {
  return [parse](Reader& reader) -> Value {
    reader.take();
    return Value(parse(reader));
  };
}

template <class T>
std::shared_ptr<const T> shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

ObjectPtr as_declared(ObjectPtr object) {
  if (object->csg() == nullptr) return object;
  auto marked = std::make_shared<Object>(*object);
  marked->declared = true;
  return marked;
}

void add_texture_parts(DeclareValues& values) {
  values[Word::kTexture] = [](Reader& reader) -> Value { return Value(parse_texture_layers(reader)); };
  values[Word::kPigment] = after_keyword([](Reader& r) { return parse_pigment(r, statements_of(r).defaults().pigment); });
  values[Word::kNormal] = after_keyword([](Reader& r) { return parse_normal(r, statements_of(r).defaults().normal); });
  values[Word::kFinish] = after_keyword([](Reader& r) { return parse_finish(r, statements_of(r).defaults().finish); });
  values[Word::kDensity] = after_keyword([](Reader& r) { return Density{parse_density(r)}; });
  values[Word::kPattern] = after_keyword([](Reader& r) { return parse_function_pattern(r); });
  values[Word::kInterior] = after_keyword([](Reader& r) { return parse_interior(r, nullptr); });
  values[Word::kMedia] = after_keyword([](Reader& r) { return parse_media(r); });
  values[Word::kMaterial] = after_keyword([](Reader& r) {
    Material material;
    parse_material(r, material, false);
    return shared(std::move(material));
  });
}

void add_maps(DeclareValues& values) {
  values[Word::kColorMap] = after_keyword([](Reader& r) { return parse_color_map(r); });
  values[Word::kPigmentMap] = after_keyword([](Reader& r) { return parse_pigment_map(r, false); });
  values[Word::kNormalMap] = after_keyword([](Reader& r) { return parse_normal_map(r, false); });
  values[Word::kTextureMap] = after_keyword([](Reader& r) { return parse_texture_map(r, false); });
  values[Word::kSlopeMap] = after_keyword([](Reader& r) { return parse_slope_map(r); });
  values[Word::kDensityMap] = after_keyword([](Reader& r) { return DensityMap{parse_density_map(r, false)}; });
}

void add_surroundings(DeclareValues& values) {
  values[Word::kCamera] = after_keyword([](Reader& r) { return shared(parse_camera(r, statements_of(r).defaults().camera)); });
  values[Word::kFog] = after_keyword([](Reader& r) { return shared(parse_fog(r)); });
  values[Word::kRainbow] = after_keyword([](Reader& r) { return shared(parse_rainbow(r)); });
  values[Word::kSkySphere] = after_keyword([](Reader& r) { return shared(parse_sky_sphere(r)); });
  values[Word::kTransform] = after_keyword([](Reader& r) { return shared(parse_transform(r)); });
}

}  // namespace

DeclareValues make_declare_values() {
  DeclareValues values;
  for (const Word word : object_words())
    values[word] = [](Reader& reader) -> Value { return Value(as_declared(*accept_object(reader))); };
  add_texture_parts(values);
  add_maps(values);
  add_surroundings(values);
  return values;
}

}  // namespace lute
