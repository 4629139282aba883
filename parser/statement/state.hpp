// What the statements of a scene keep while it is read: the defaults in force, what was given, what was warned about.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "engine/image/image_file.hpp"
#include "parser/reader.hpp"
#include "parser/statement/statement.hpp"

namespace lute {

// Values that `#default` sets and that new textures and cameras start from (specification chapter 11 §9.4).
struct Defaults {
  PigmentPtr pigment;  // never null
  NormalPtr normal;    // null: none
  FinishPtr finish;    // never null
  std::optional<float> radiosity_importance;
  Camera camera;

  TextureLayer layer() const { return {pigment, normal, finish}; }
};

class SceneStatements : public StatementState {
 public:
  SceneStatements();

  const Defaults& defaults() const { return defaults_; }
  Defaults& change_defaults();
  // One for all objects that are read between two `#default`s.
  const TexturePtr& default_texture();
  const Shared<ObjectExtras>& default_extras();  // of a top-level object without any of its own

  ImageFiles images;                    // files that the scene has read
  std::map<std::string, std::shared_ptr<const std::string>> fonts;  // the contents of font files, by path
  bool camera_given = false;
  bool untyped_normals = false;         // some normal has no pattern (yet): objects of the scene must not have it
  std::size_t nesting = 0;              // of blocks being read
  std::set<std::string> not_rendered;   // features named in a warning already

 private:
  Defaults defaults_;
  TexturePtr default_texture_;
  Shared<ObjectExtras> default_extras_;
};

SceneStatements& statements_of(Reader& reader);

// Warns, once for each feature: "media is not rendered yet", at the keyword just taken.
void warn_not_rendered(Reader& reader, std::string_view feature);

// Gives the finished value its depth and makes it ready to be shared; an error if it is too deep.
PigmentPtr shared(Reader& reader, Pigment pigment);
NormalPtr shared(Reader& reader, Normal normal);
TexturePtr shared(Reader& reader, Texture texture);
// An object with more parts than fit into memory is an error too.
ObjectPtr shared(Reader& reader, Object object);

// What a part of an object takes when the scene is built, at least, in bytes.
constexpr double kBuiltPartBytes = 128;

// Guards the stack: blocks that contain blocks of their kind count their depth while they are read.
class NestingGuard {
 public:
  explicit NestingGuard(Reader& reader);
  ~NestingGuard();
  NestingGuard(const NestingGuard&) = delete;
  NestingGuard& operator=(const NestingGuard&) = delete;

 private:
  SceneStatements& statements_;
};

}  // namespace lute
