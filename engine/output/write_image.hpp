// Writes a finished picture, whole or not at all. Source: specification chapter 30 §7.
#pragma once

#include <string>

#include "engine/output/output_settings.hpp"
#include "engine/render/film.hpp"

namespace lute {

// `path` "-" is standard output. Throws std::runtime_error with the path and the reason; a file that was there is then
// untouched.
void write_image(const std::string& path, const Film& film, const WorkingSpace& working,
                 const OutputSettings& settings);

}  // namespace lute
