// The statements of a scene file, #default, and what happens at its end (specification chapter 11 §2, §9.4).
#include <algorithm>

#include "engine/scene/contents.hpp"
#include "parser/session.hpp"
#include "parser/statement/atmosphere.hpp"
#include "parser/statement/camera.hpp"
#include "parser/statement/finish.hpp"
#include "parser/statement/global_settings.hpp"
#include "parser/statement/interior.hpp"
#include "parser/statement/normal.hpp"
#include "parser/statement/object.hpp"
#include "parser/statement/object_edit.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/statement.hpp"
#include "parser/statement/texture.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/untyped_normal.hpp"

namespace lute {
namespace {

void add_camera(Reader& reader) {
  SceneStatements& statements = statements_of(reader);
  Camera& camera = reader.scene().camera;
  if (reader.version() < 350) {
    camera = parse_camera(reader, statements.camera_given ? camera : statements.defaults().camera);
  } else {
    if (statements.camera_given) reader.warning("More than one camera in scene. Ignoring previous camera(s).");
    camera = parse_camera(reader, statements.defaults().camera);
  }
  statements.camera_given = true;
}

void add_sky_sphere(Reader& reader) {
  Scene& scene = reader.scene();
  if (scene.sky_sphere) reader.warning("Only one sky-sphere allowed (last one will be used).");
  scene.sky_sphere = parse_sky_sphere(reader);
}

bool accept_surroundings(Reader& reader) {
  Scene& scene = reader.scene();
  if (reader.accept(Word::kCamera)) {
    add_camera(reader);
  } else if (reader.accept(Word::kBackground)) {
    scene.background_where = reader.location();
    scene.background = parse_background(reader);
  } else if (reader.accept(Word::kSkySphere)) {
    add_sky_sphere(reader);
  } else if (reader.accept(Word::kFog)) {
    scene.fogs.push_back(parse_fog(reader));
  } else if (reader.accept(Word::kRainbow)) {
    scene.rainbows.push_back(parse_rainbow(reader));
  } else if (reader.accept(Word::kMedia)) {
    scene.atmosphere.push_back(parse_media(reader));
  } else {
    return false;
  }
  return true;
}

bool accept_setting(Reader& reader) {
  if (reader.accept(Word::kGlobalSettings)) {
    parse_global_settings(reader);
  } else if (reader.accept(Word::kDefault)) {
    parse_default(reader);
  } else if (reader.accept(Word::kMaxTraceLevel)) {
    reader.warning("max_trace_level belongs in global_settings.");
    parse_max_trace_level(reader);
  } else if (reader.accept(Word::kMaxIntersections)) {
    reader.number();
  } else {
    return false;
  }
  return true;
}

void take_defaults(Object& object, SceneStatements& statements) {
  if (object.extras.is_default()) {
    object.extras = statements.default_extras();
    return;
  }
  ObjectExtras& extras = object.extras.edit();
  extras.default_texture = statements.default_texture();
  if (!extras.radiosity_importance) extras.radiosity_importance = statements.defaults().radiosity_importance;
}

bool accept_scene_object(Reader& reader) {
  const auto object = accept_object(reader);
  if (!object) return false;
  if (is_absent(**object)) return true;
  Object placed = **object;
  if (const double leaves = contents_of(placed).leaves; leaves > 1) reader.session().resources.reserve(leaves * kBuiltPartBytes);
  take_defaults(placed, statements_of(reader));
  if (statements_of(reader).untyped_normals && has_untyped_normal(placed, *placed.extras->default_texture))
    reader.error("No normal type given.");
  reader.scene().objects.push_back(std::make_shared<const Object>(std::move(placed)));
  return true;
}

void parse_default_texture(Reader& reader) {
  const TexturePtr texture = parse_texture(reader);
  if (!is_plain(*texture)) reader.error("Default texture cannot be material map or tiles.");
  const auto& layers = std::get<std::vector<TextureLayer>>(texture->content);
  if (layers.size() != 1) reader.error("Default texture cannot be layered.");
  Defaults& defaults = statements_of(reader).change_defaults();
  defaults.pigment = layers.front().pigment;
  defaults.normal = layers.front().normal;
  defaults.finish = layers.front().finish;
}

void parse_default_radiosity(Reader& reader) {
  reader.open(Word::kRadiosity);
  while (reader.accept(Word::kImportance)) {
    const double importance = reader.number();
    if (!(importance > 0 && importance <= 1)) reader.error("Radiosity importance must be greater than 0.0 and at most 1.0.");
    statements_of(reader).change_defaults().radiosity_importance = static_cast<float>(importance);
  }
  reader.close(Word::kRadiosity);
}

bool accept_default(Reader& reader) {
  SceneStatements& statements = statements_of(reader);
  if (reader.accept(Word::kTexture)) {
    parse_default_texture(reader);
  } else if (reader.accept(Word::kPigment)) {
    PigmentPtr pigment = parse_pigment(reader, statements.defaults().pigment);
    statements.change_defaults().pigment = std::move(pigment);
  } else if (reader.accept(Word::kNormal)) {
    NormalPtr normal = parse_normal(reader, statements.defaults().normal);
    statements.change_defaults().normal = std::move(normal);
  } else if (reader.accept(Word::kFinish)) {
    FinishPtr finish = parse_finish(reader, statements.defaults().finish);
    statements.change_defaults().finish = std::move(finish);
  } else if (reader.accept(Word::kRadiosity)) {
    parse_default_radiosity(reader);
  } else if (reader.accept(Word::kCamera)) {
    Camera camera = parse_camera(reader, statements.defaults().camera);
    statements.change_defaults().camera = std::move(camera);
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool parse_statement(Reader& reader) {
  return accept_scene_object(reader) || accept_surroundings(reader) || accept_setting(reader);
}

bool begins_top_level_statement(Word word) {
  switch (word) {
    case Word::kCamera: case Word::kBackground: case Word::kSkySphere: case Word::kFog: case Word::kRainbow: case Word::kMedia:
    case Word::kGlobalSettings: case Word::kDefault: case Word::kMaxTraceLevel: case Word::kMaxIntersections: case Word::kDeclare:
    case Word::kInclude: case Word::kVersion: return true;
    default: return std::ranges::find(object_words(), word) != object_words().end();
  }
}

void parse_default(Reader& reader) {
  reader.open(Word::kDefault);
  while (accept_default(reader)) {
  }
  reader.close(Word::kDefault);
}

void finish_scene(Reader& reader) {
  constexpr int kOldestRendered = 350, kWithGamma = 370;
  Scene& scene = reader.scene();
  scene.effective_version = reader.effective_version();
  scene.version = std::max(reader.version(), kOldestRendered);
  if (!reader.assumed_gamma_given()) {
    scene.settings.gamma_mode = scene.effective_version < kWithGamma ? GammaMode::kNone : GammaMode::kPower;
    scene.settings.assumed_gamma = 1;
    if (scene.effective_version < kWithGamma) {
      reader.warning("assumed_gamma is not specified: for compatibility with scenes before version 3.7 no gamma is applied.");
    } else {
      reader.possible_error("assumed_gamma is not specified: write global_settings { assumed_gamma 1.0 }");
    }
  }
  if (reader.version() < kOldestRendered) {
    reader.warning("The scene ended with a language version below 3.5: faults of those versions that it may rely on are not rendered.");
  }
  if (!reader.session().noise_generator_given) scene.settings.noise_generator = reader.version() < kOldestRendered ? 1 : 2;
  if (scene.objects.empty()) reader.warning("No objects in scene.");
}

}  // namespace lute
