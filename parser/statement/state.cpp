#include "parser/statement/state.hpp"

#include "engine/scene/contents.hpp"
#include "parser/session.hpp"

namespace lute {
SceneStatements::SceneStatements() {
  defaults_.pigment = std::make_shared<const Pigment>();
  defaults_.finish = std::make_shared<const Finish>();
}

Defaults& SceneStatements::change_defaults() {
  default_texture_.reset();
  default_extras_ = {};
  return defaults_;
}

const TexturePtr& SceneStatements::default_texture() {
  if (!default_texture_) {
    Texture texture;
    texture.content = std::vector<TextureLayer>{defaults_.layer()};
    default_texture_ = std::make_shared<const Texture>(std::move(texture));
  }
  return default_texture_;
}

const Shared<ObjectExtras>& SceneStatements::default_extras() {
  if (default_extras_.is_default()) {
    default_extras_.edit().default_texture = default_texture();
    default_extras_.edit().radiosity_importance = defaults_.radiosity_importance;
  }
  return default_extras_;
}

SceneStatements& statements_of(Reader& reader) { return static_cast<SceneStatements&>(reader.statements()); }

std::unique_ptr<StatementState> make_statement_state() { return std::make_unique<SceneStatements>(); }

void warn_not_rendered(Reader& reader, std::string_view feature) {
  if (statements_of(reader).not_rendered.insert(std::string(feature)).second)
    reader.warning(std::string(feature) + (feature == "photons" ? " are" : " is") + " not rendered yet");
}

namespace {

void require_depth(Reader& reader, std::uint32_t depth, const char* what) {
  const std::size_t most = reader.session().options.limits.depth;
  if (depth > most) reader.error(std::string(what) + " are nested too deeply: the limit is " + std::to_string(most) + ".", "limit-depth");
}

template <class T>
std::shared_ptr<const T> shared_at_depth(Reader& reader, T value, const char* what) {
  value.depth = depth_of(value);
  require_depth(reader, value.depth, what);
  return std::make_shared<const T>(std::move(value));
}

}  // namespace

PigmentPtr shared(Reader& reader, Pigment pigment) { return shared_at_depth(reader, std::move(pigment), "Pigments"); }
NormalPtr shared(Reader& reader, Normal normal) { return shared_at_depth(reader, std::move(normal), "Normals"); }
TexturePtr shared(Reader& reader, Texture texture) { return shared_at_depth(reader, std::move(texture), "Textures"); }

ObjectPtr shared(Reader& reader, Object object) {
  const Contents contents = contents_of(object);
  require_depth(reader, contents.depth, "Objects");
  reader.session().resources.require(contents.leaves * kBuiltPartBytes);
  return std::make_shared<const Object>(std::move(object));
}

NestingGuard::NestingGuard(Reader& reader) : statements_(statements_of(reader)) {
  const std::size_t most = reader.session().options.limits.blocks;  // a level takes some kilobytes of stack
  if (++statements_.nesting > most) {
    --statements_.nesting;
    reader.error("Braces are nested too deeply: the limit is " + std::to_string(most) + ".", "limit-blocks");
  }
}

NestingGuard::~NestingGuard() { --statements_.nesting; }

}  // namespace lute
