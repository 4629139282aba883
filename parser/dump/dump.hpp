// A scene description as JSON, complete: for --dump-scene, golden tests and programs that ask what the parser understood.
// Keys are sorted, numbers have as many digits as tell them apart, so the text of a scene never changes by itself.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/scene/scene.hpp"

namespace lute {

nlohmann::json dump_scene(const Scene& scene);

}  // namespace lute
