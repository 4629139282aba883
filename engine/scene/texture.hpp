// Textures as the scene file says them: pigments, normals, finishes, layers and maps. Plain values; engine/texture compiles them.
// Values are shared and never changed once shared: whoever edits one copies it first.
// Source: specification chapters 11 §9-10 and 50.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/image/color.hpp"
#include "engine/memory/shared_transform.hpp"
#include "engine/scene/finish.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/texture/pattern/table.hpp"
#include "engine/texture/warp.hpp"

namespace lute {

struct Pigment;
struct Normal;
struct Texture;
using PigmentPtr = std::shared_ptr<const Pigment>;
using NormalPtr = std::shared_ptr<const Normal>;
using TexturePtr = std::shared_ptr<const Texture>;

// Entries in the order written; positions are not sorted and not clamped (chapter 50 §10.1). For `average` the position is the
// weight; for list patterns it is 0, 1, 2, ...
template <class T>
struct BlendMap {
  struct Entry {
    float position = 0;
    T value{};
  };
  std::vector<Entry> entries;
};
using ColorMap = BlendMap<Color>;
using PigmentMap = BlendMap<PigmentPtr>;
using NormalMap = BlendMap<NormalPtr>;
using TextureMap = BlendMap<TexturePtr>;
struct HeightAndSlope {
  double height = 0, slope = 0;
};
using SlopeMap = BlendMap<HeightAndSlope>;

struct NoPattern {};   // `pigment {}` without type: black. `normal` without type: none
struct Average {};     // weighted mean of the map's entries
struct UvMapping {};   // the map's only entry, evaluated at (u, v, 0)

// What pigment, normal, density and patterned texture have in common.
struct PatternBody {
  std::variant<NoPattern, Average, UvMapping, AnyPattern> pattern;
  WarpChain warps;
  float frequency = 1;
  float phase = 0;
  Wave wave = Wave::kRamp;
  float wave_exponent = 1;
  int noise_generator = 0;  // 0: the scene's
};

struct Pigment {
  PatternBody body;
  // A plain colour; or a map over the pattern's values (a list pattern is a map with positions 0, 1, 2, ...). monostate: the
  // pattern's default colours, see default_color_map().
  std::variant<std::monostate, Color, ColorMap, PigmentMap> map;
  // The map that a plain colour covers: it comes back with the next pattern.
  std::variant<std::monostate, ColorMap, PigmentMap> covered_map;
  std::optional<Color> quick_color;
  std::uint32_t depth = 1;  // of pigments, functions and objects inside each other, this one included
  SourceLocation where;
};

struct Normal {
  PatternBody body;
  float amount = 0.5f;
  float accuracy = 0.02f;
  bool no_bump_scale = false;
  std::variant<std::monostate, NormalMap, SlopeMap> map;
  std::uint32_t depth = 1;  // as of a pigment
  SourceLocation where;
};

// One layer of a plain texture.
struct TextureLayer {
  PigmentPtr pigment;  // never null
  NormalPtr normal;    // null: none
  FinishPtr finish;    // never null
};

// `texture { <pattern> texture_map {...} }`, tiles, list patterns of textures.
struct PatternedTexture {
  PatternBody body;
  TextureMap map;
};

struct Texture {
  // Layers from the bottom (first written) to the top; or a patterned texture, which is always alone.
  std::variant<std::vector<TextureLayer>, PatternedTexture> content;
  bool no_bump_scale = false;
  std::uint32_t depth = 1;  // as of a pigment
  SourceLocation where;
};

// A texture on an object, with the transformations that the object went through since it was given (a texture is carried along
// by later transformations of its object). Applied to the point before the texture's own chains, by its inverse.
struct TextureOnObject {
  TexturePtr texture;  // null: none
  SharedTransform placement;
};

// The colours of a pattern whose pigment has no map (chapter 50 §10.3): black to white for most.
const ColorMap& default_color_map(const PatternBody& body);

}  // namespace lute
