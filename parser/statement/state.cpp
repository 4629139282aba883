#include "parser/statement/state.hpp"

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

NestingGuard::NestingGuard(Reader& reader) : statements_(statements_of(reader)) {
  const std::size_t most = reader.session().options.limits.blocks;  // a level takes some kilobytes of stack
  if (++statements_.nesting > most) {
    --statements_.nesting;
    reader.error("Braces are nested too deeply: the limit is " + std::to_string(most) + ".", "limit-blocks");
  }
}

NestingGuard::~NestingGuard() { --statements_.nesting; }

}  // namespace lute
