#include "parser/statement/image.hpp"

#include <algorithm>
#include <cmath>

#include "engine/function/function.hpp"
#include "engine/texture/function_image.hpp"
#include "parser/statement/pattern_arguments.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

std::optional<std::string> find_image(Reader& reader, const std::string& name, const std::string& type) {
  if (type == "png") return reader.find_file(name, {".png", ".PNG"});
  if (type == "tga") return reader.find_file(name, {".tga", ".TGA"});
  if (type == "gif" || type == "pot") return reader.find_file(name, {".gif", ".GIF"});
  if (type == "jpeg") return reader.find_file(name, {".jpg", ".JPG", ".jpeg", ".JPEG"});
  if (type == "tiff") return reader.find_file(name, {".tif", ".TIF", ".tiff", ".TIFF"});
  if (type == "bmp") return reader.find_file(name, {".bmp", ".BMP"});
  if (type == "ppm") return reader.find_file(name, {".ppm", ".PPM"});
  if (type == "pgm") return reader.find_file(name, {".pgm", ".PGM"});
  if (type == "iff") return reader.find_file(name, {".iff", ".IFF"});
  if (type == "exr") return reader.find_file(name, {".exr", ".EXR"});
  if (type == "hdr") return reader.find_file(name, {".hdr", ".HDR"});
  return reader.find_file(name);
}

// The keyword of a file type, if one comes next. `sys` is what the system prefers; the reference knows of no such type here either.
std::string accept_type(Reader& reader, ImageUse use) {
  const Word word = reader.word();
  switch (word) {
    case Word::kGif: case Word::kTga: case Word::kPng: case Word::kJpeg: case Word::kTiff: case Word::kBmp:
    case Word::kPgm: case Word::kPpm: case Word::kExr: case Word::kHdr: break;
    case Word::kSys: reader.take(); reader.error("This platform has not defined a SYS file type");
    case Word::kIff:
    case Word::kPot: {
      reader.take();
      if ((word == Word::kPot) != (use == ImageUse::kHeights)) reader.error("File type not supported here.");
      return std::string(spelling(word));
    }
    default: return {};
  }
  reader.take();
  return std::string(spelling(word));
}

std::optional<GammaCurve> working_space(Reader& reader) {
  if (reader.assumed_gamma_given()) {
    const GlobalSettings& settings = reader.scene().settings;
    return settings.gamma_mode == GammaMode::kSrgb ? GammaCurve::srgb() : GammaCurve::power(settings.assumed_gamma);
  }
  if (reader.effective_version() < 370) return std::nullopt;
  return GammaCurve::linear();
}

GammaCurve parse_gamma(Reader& reader) {
  if (reader.accept(Word::kSrgb)) return GammaCurve::srgb();
  const double power = reader.number();
  if (power <= 0) reader.error("gamma value must be positive.");
  return GammaCurve::power(power);
}

void parse_file_options(Reader& reader, ImageFileOptions& options) {
  while (true) {
    if (reader.accept(Word::kGamma)) options.file_gamma = parse_gamma(reader);
    else if (reader.accept(Word::kPremultiplied)) options.premultiplied = reader.optional_flag();
    else break;
  }
}

ImagePtr parse_function_image(Reader& reader) {
  constexpr double kMaxSide = 32768;
  const auto side = [&] {
    const double value = std::floor(reader.number() + 0.5);
    if (!(value >= 1 && value <= kMaxSide)) reader.error("Invalid size of a function image.");
    return static_cast<int>(value);
  };
  const int width = side();
  reader.comma();
  const int height = side();
  const FunctionPtr function = reader.any_function();
  const int results = function->result_count();
  if (function->parameter_count() != 3 || (results != 1 && results != 5))
    reader.error("Unsupported function type in function image.");
  const ImagePtr image = sample_function(*function, width, height);
  ImageFileOptions unused;
  parse_file_options(reader, unused);
  return image;
}

// Register forms of filter and transmit need a palette.
void parse_transparency(Reader& reader, const Image& image, Word word, std::optional<float>& all,
                        std::vector<std::pair<int, float>>& of_index) {
  if (reader.accept(Word::kAll)) {
    all = static_cast<float>(reader.number());
    return;
  }
  const int index = reader.integer();
  reader.comma();
  const auto value = static_cast<float>(reader.number());
  if (!image.is_palette())
    reader.error("Keyword '" + std::string(spelling(word)) + "' cannot be used with non color-mapped image.");
  if (index < 0 || index >= static_cast<int>(image.palette().size())) {
    std::string name(spelling(word));
    std::ranges::transform(name, name.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    reader.error(name + " color register value out of range.");
  }
  of_index.emplace_back(index, value);
}

bool accept_index_word(Reader& reader, ImageMapping& mapping) {
  if (reader.accept(Word::kUseColor)) mapping.use_index = false;
  else if (reader.accept(Word::kUseIndex)) mapping.use_index = true;
  else return false;
  return true;
}

}  // namespace

ImagePtr parse_image(Reader& reader, ImageUse use) {
  while (reader.at_number()) {  // an orientation, of old, without effect
    reader.vector();
    reader.comma();
  }
  if (reader.accept(Word::kFunction)) return parse_function_image(reader);
  ImageFileOptions options;
  options.type = accept_type(reader, use);
  const std::string name = reader.file_name();
  const auto path = find_image(reader, name, options.type);
  parse_file_options(reader, options);
  if (!path) reader.error("Cannot open image file " + name + ".", "missing-file");
  if (options.type.empty()) options.type = image_type_of(*path);
  if (options.type.empty()) reader.error("Could not determine valid image file type from extension.");
  options.for_colors = use == ImageUse::kColors;
  options.working = working_space(reader);
  options.legacy = reader.assumed_gamma_given() && reader.effective_version() < 370;
  std::string error;
  ImagePtr image = statements_of(reader).images.load(*path, options, error);
  if (image == nullptr) reader.error("Cannot read image " + name + ": " + error, "bad-file");
  return image;
}

bool accept_mapping_item(Reader& reader, ImageMapping& mapping, bool checked) {
  if (reader.accept(Word::kOnce)) {
    mapping.once = true;
  } else if (reader.accept(Word::kInterpolate)) {
    mapping.interpolate = reader.integer();
    if (checked && (mapping.interpolate < 2 || mapping.interpolate > 4)) reader.error("Invalid interpolate value.");
  } else if (reader.accept(Word::kMapType)) {
    mapping.map_type = reader.integer();
    const int type = mapping.map_type;
    if (checked && type != 0 && type != 1 && type != 2 && type != 5) reader.error("Invalid map_type value.");
  } else if (reader.accept(Word::kRepeat)) {
    mapping.repeat = reader.vector2();
    if (mapping.repeat.x <= 0 || mapping.repeat.y <= 0) reader.error("Zero or Negative Image Repeat Vector.");
  } else if (reader.accept(Word::kOffset)) {
    mapping.offset = reader.vector2();
  } else {
    return false;
  }
  return true;
}

void parse_arguments(Reader& reader, ImageMap& pattern, ParsedPattern&) {
  reader.open(Word::kImageMap);
  pattern.mapping.image = parse_image(reader, ImageUse::kColors);
  const Image& image = *pattern.mapping.image;
  ImageTransparency& transparency = pattern.transparency;
  while (true) {
    if (reader.accept(Word::kFilter)) {
      parse_transparency(reader, image, Word::kFilter, transparency.filter_all, transparency.filter_of);
    } else if (reader.accept(Word::kTransmit)) {
      parse_transparency(reader, image, Word::kTransmit, transparency.transmit_all, transparency.transmit_of);
    } else if (!accept_index_word(reader, pattern.mapping) && !accept_mapping_item(reader, pattern.mapping, true)) {
      break;
    }
  }
  reader.close(Word::kImageMap);
}

void parse_arguments(Reader& reader, ImagePattern& pattern, ParsedPattern&) {
  reader.open(Word::kImagePattern);
  pattern.mapping.image = parse_image(reader, ImageUse::kValues);
  while (true) {
    if (reader.accept(Word::kUseAlpha)) pattern.use_alpha = true;
    else if (!accept_index_word(reader, pattern.mapping) && !accept_mapping_item(reader, pattern.mapping, false)) break;
  }
  reader.close(Word::kImagePattern);
}

void parse_arguments(Reader& reader, BumpMap& pattern, ParsedPattern& parsed) {
  reader.open(Word::kBumpMap);
  pattern.mapping.image = parse_image(reader, ImageUse::kValues);
  while (true) {
    if (reader.accept(Word::kBumpSize)) parsed.bump_size = static_cast<float>(reader.number());
    else if (!accept_index_word(reader, pattern.mapping) && !accept_mapping_item(reader, pattern.mapping, false)) break;
  }
  reader.close(Word::kBumpMap);
}

}  // namespace lute
