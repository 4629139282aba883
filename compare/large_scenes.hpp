// Scenes that are all text: for measuring how fast and in how much memory the programs read. They are written anew each time.
#pragma once

#include <cstdint>
#include <filesystem>

namespace lute::compare {

// A #while loop of so many turns with three assignments in each.
void write_loop(const std::filesystem::path& path, std::int64_t turns);

// A mesh2 of at least so many faces: a wavy square, six digits a number, one vector a line, as exporters write.
void write_mesh(const std::filesystem::path& path, std::int64_t faces);

}  // namespace lute::compare
