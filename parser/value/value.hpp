// What a declared name, an array element or a macro argument can hold (specification chapter 10 §3.2).
// Scene items are shared, immutable: a copy of a Value is a copy in the language's sense, except for arrays (see copy()).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "engine/function/function.hpp"
#include "engine/scene/scene.hpp"
#include "parser/lexer/token.hpp"
#include "parser/value/spline.hpp"

namespace lute {

// A numeric value of 1 to 5 components: float, 2-vector, vector, 4-vector, colour.
struct Number {
  std::array<double, 5> c{};
  int count = 1;

  Number() = default;
  explicit Number(double value) { c[0] = value; }
  explicit Number(const dvec3& v) : c{v.x, v.y, v.z}, count(3) {}
  explicit Number(const Color& color)
      : c{color.rgb.r, color.rgb.g, color.rgb.b, color.filter, color.transmit}, count(5) {}

  bool is_float() const { return count == 1; }
  dvec3 vector() const { return {c[0], c[1], c[2]}; }
  Color color() const;  // in single precision
};

using String = std::shared_ptr<const std::u16string>;

struct Array;     // parser/value/array.hpp
struct Macro;     // parser/directives/macro.hpp
struct UserFile;  // parser/directives/user_file.hpp
using ArrayPtr = std::shared_ptr<Array>;
using MacroPtr = std::shared_ptr<const Macro>;
using UserFilePtr = std::shared_ptr<UserFile>;

struct Material {
  TextureOnObject texture, interior_texture;
  InteriorPtr interior;
};

// Types that share a representation with another are wrapped, so that each is an alternative of its own.
struct Density { PigmentPtr pigment; };
struct DensityMap { std::shared_ptr<const PigmentMap> map; };

using MediaPtr = std::shared_ptr<const Media>;
using MaterialPtr = std::shared_ptr<const Material>;
using CameraPtr = std::shared_ptr<const Camera>;
using FogPtr = std::shared_ptr<const Fog>;
using RainbowPtr = std::shared_ptr<const Rainbow>;
using SkySpherePtr = std::shared_ptr<const SkySphere>;
using TransformPtr = std::shared_ptr<const Transform>;
using ColorMapPtr = std::shared_ptr<const ColorMap>;
using PigmentMapPtr = std::shared_ptr<const PigmentMap>;
using NormalMapPtr = std::shared_ptr<const NormalMap>;
using TextureMapPtr = std::shared_ptr<const TextureMap>;
using SlopeMapPtr = std::shared_ptr<const SlopeMap>;

using ValueVariant =
    std::variant<std::monostate, Number, String, ArrayPtr, SplinePtr, FunctionPtr, MacroPtr, UserFilePtr, ObjectPtr, TexturePtr,
                 PigmentPtr, NormalPtr, FinishPtr, InteriorPtr, MediaPtr, Density, MaterialPtr, CameraPtr, FogPtr, RainbowPtr,
                 SkySpherePtr, TransformPtr, ColorMapPtr, PigmentMapPtr, NormalMapPtr, TextureMapPtr, SlopeMapPtr, DensityMap>;

struct Value : ValueVariant {
  using ValueVariant::ValueVariant;

  bool empty() const { return index() == 0; }
  template <class T>
  bool holds() const { return std::holds_alternative<T>(static_cast<const ValueVariant&>(*this)); }
  template <class T>
  const T* get_if() const { return std::get_if<T>(static_cast<const ValueVariant*>(this)); }
};

// A copy whose later changes do not reach the original: arrays are copied with their elements.
Value copy(const Value& value);

// The memory that a copy takes, in bytes; 0 where it shares what it holds.
std::uint64_t size_of_copy(const Value& value);

// Equal exactly for values of one language type: a float and a vector differ.
std::size_t type_code(const Value& value);

// As messages print it: "float identifier", "texture identifier", ...
std::string_view type_name(const Value& value);

// Where a value lives: a name's entry, or an element of an array. Macro parameters passed by reference share it.
using Slot = std::shared_ptr<Value>;

}  // namespace lute
