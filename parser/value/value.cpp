#include "parser/value/value.hpp"

#include "parser/value/array.hpp"

namespace lute {

Color Number::color() const {
  return {Rgb(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])), static_cast<float>(c[3]),
          static_cast<float>(c[4])};
}

Value copy(const Value& value) {
  const ArrayPtr* array = value.get_if<ArrayPtr>();
  if (array == nullptr) return value;
  auto result = std::make_shared<Array>(**array);
  result->elements.for_each_value([](Value& element) { element = copy(element); });
  return result;
}

std::uint64_t size_of_copy(const Value& value) {
  const ArrayPtr* array = value.get_if<ArrayPtr>();
  if (array == nullptr) return 0;
  std::uint64_t bytes = sizeof(Array) + (*array)->elements.bytes();
  (*array)->elements.for_each_value([&](const Value& element) { bytes += size_of_copy(element); });
  return bytes;
}

namespace {

constexpr std::size_t kNumberTypes = 5;

struct TypeName {
  std::string_view operator()(const std::monostate&) const { return "undeclared identifier"; }
  std::string_view operator()(const Number& n) const {
    constexpr std::string_view names[] = {"float identifier", "uv vector identifier", "vector identifier", "4d-vector identifier",
                                          "colour identifier"};
    return names[n.count - 1];
  }
  std::string_view operator()(const String&) const { return "string identifier"; }
  std::string_view operator()(const ArrayPtr&) const { return "array identifier"; }
  std::string_view operator()(const SplinePtr&) const { return "spline identifier"; }
  std::string_view operator()(const FunctionPtr& f) const {
    return f && f->is_vector() ? "vector function identifier" : "function identifier";
  }
  std::string_view operator()(const MacroPtr&) const { return "macro identifier"; }
  std::string_view operator()(const UserFilePtr&) const { return "file identifier"; }
  std::string_view operator()(const ObjectPtr&) const { return "object identifier"; }
  std::string_view operator()(const TexturePtr&) const { return "texture identifier"; }
  std::string_view operator()(const PigmentPtr&) const { return "pigment identifier"; }
  std::string_view operator()(const NormalPtr&) const { return "normal identifier"; }
  std::string_view operator()(const FinishPtr&) const { return "finish identifier"; }
  std::string_view operator()(const InteriorPtr&) const { return "interior identifier"; }
  std::string_view operator()(const MediaPtr&) const { return "media identifier"; }
  std::string_view operator()(const Density&) const { return "density identifier"; }
  std::string_view operator()(const MaterialPtr&) const { return "material identifier"; }
  std::string_view operator()(const CameraPtr&) const { return "camera identifier"; }
  std::string_view operator()(const FogPtr&) const { return "fog identifier"; }
  std::string_view operator()(const RainbowPtr&) const { return "rainbow identifier"; }
  std::string_view operator()(const SkySpherePtr&) const { return "sky_sphere identifier"; }
  std::string_view operator()(const TransformPtr&) const { return "transform identifier"; }
  std::string_view operator()(const ColorMapPtr&) const { return "colour map identifier"; }
  std::string_view operator()(const PigmentMapPtr&) const { return "pigment_map identifier"; }
  std::string_view operator()(const NormalMapPtr&) const { return "normal_map identifier"; }
  std::string_view operator()(const TextureMapPtr&) const { return "texture_map identifier"; }
  std::string_view operator()(const SlopeMapPtr&) const { return "slope_map identifier"; }
  std::string_view operator()(const DensityMap&) const { return "density_map identifier"; }
};

}  // namespace

std::size_t type_code(const Value& value) {
  const Number* number = value.get_if<Number>();
  if (number != nullptr) return static_cast<std::size_t>(number->count);
  return value.empty() ? 0 : kNumberTypes + value.index();
}

std::string_view type_name(const Value& value) {
  return std::visit(TypeName{}, static_cast<const ValueVariant&>(value));
}

}  // namespace lute
