#include "parser/diagnostic/block_words.hpp"

#include <algorithm>
#include <iterator>

namespace lute {

namespace {

constexpr std::string_view kMoves = " translate rotate scale transform matrix";
constexpr std::string_view kColours = " color colour rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft red green blue filter transmit";
constexpr std::string_view kPatterns =
    " agate aoi average boxed bozo brick bumps cells checker crackle cubic cylindrical density_file dents facets function gradient"
    " granite hexagon image_pattern julia leopard magnet mandel marble object onion pavement pigment_pattern planar"
    " quilted radial ripples slope spherical spiral1 spiral2 spotted square tiling triangular waves wood wrinkles";
constexpr std::string_view kPatternItems =
    " turbulence octaves omega lambda frequency phase ramp_wave sine_wave triangle_wave scallop_wave cubic_wave poly_wave"
    " noise_generator warp agate_turb brick_size mortar control0 control1 exterior interior metric offset form solid"
    " interpolate map_type once uv_mapping";
constexpr std::string_view kObjectItems =
    " texture pigment normal finish interior interior_texture material photons radiosity no_shadow no_image no_reflection"
    " no_radiosity hollow inverse double_illuminate clipped_by bounded_by uv_mapping sturm open";

struct Block {
  std::string_view name;
  std::string_view words;        // of its own, with blanks between
  std::string_view shared[4] = {};
};

// Source: specification chapters 11 to 15 and 20.
constexpr Block kBlocks[] = {
    {"pigment", "color_map colour_map pigment_map image_map quick_color quick_colour", {kPatterns, kPatternItems, kColours, kMoves}},
    {"normal", "normal_map slope_map bump_map bump_size accuracy no_bump_scale", {kPatterns, kPatternItems, kMoves}},
    {"texture", "pigment normal finish texture_map material_map", {kPatterns, kPatternItems, kMoves}},
    {"finish",
     "ambient diffuse albedo emission brilliance phong phong_size specular roughness metallic reflection reflection_exponent crand irid"
     " conserve_energy subsurface"},
    {"interior", "ior caustics dispersion dispersion_samples fade_distance fade_power fade_color fade_colour media"},
    {"camera",
     "location look_at right up direction sky angle perspective orthographic fisheye ultra_wide_angle omnimax panoramic cylinder"
     " spherical mesh_camera aperture blur_samples focal_point confidence variance bokeh normal",
     {kMoves}},
    {"light_source",
     "spotlight cylinder parallel point_at radius falloff tightness area_light adaptive jitter circular orient area_illumination"
     " shadowless looks_like projected_through fade_distance fade_power media_attenuation media_interaction photons",
     {kColours, kMoves}},
    {"global_settings",
     "adc_bailout ambient_light assumed_gamma charset hf_gray_16 irid_wavelength max_intersections max_trace_level mm_per_unit"
     " noise_generator number_of_waves photons radiosity subsurface"},
    {"box", "", {kObjectItems, kMoves}},
    {"cone", "", {kObjectItems, kMoves}},
    {"cylinder", "", {kObjectItems, kMoves}},
    {"disc", "", {kObjectItems, kMoves}},
    {"plane", "", {kObjectItems, kMoves}},
    {"sphere", "", {kObjectItems, kMoves}},
    {"torus", "", {kObjectItems, kMoves}},
};

void add_words(std::vector<std::string_view>& words, std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

std::vector<std::string_view> block_words(std::string_view block) {
  std::vector<std::string_view> words;
  const auto found = std::ranges::find(kBlocks, block, &Block::name);
  if (found == std::end(kBlocks)) return words;
  add_words(words, found->words);
  for (const std::string_view shared : found->shared) add_words(words, shared);
  return words;
}

bool is_block_word(std::string_view block, std::string_view word) {
  const std::vector<std::string_view> words = block_words(block);
  return std::ranges::find(words, word) != words.end();
}

}  // namespace lute
