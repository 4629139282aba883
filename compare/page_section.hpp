// The part of a page in docs/ that a command writes: what stands between the lines
// '<!-- lute-compare NAME: begin -->' and '<!-- lute-compare NAME: end -->'.
#pragma once

#include <filesystem>
#include <string>

namespace lute::compare {

// That part of `page`. Throws std::runtime_error if it has no such lines.
std::string section_of(const std::string& page, const std::string& name);

// `page` with that part replaced. Throws std::runtime_error if it has no such lines.
std::string with_section(const std::string& page, const std::string& name, const std::string& section);

// The same in a file. Throws std::runtime_error if it cannot be read, too.
void replace_section(const std::filesystem::path& file, const std::string& name, const std::string& section);

}  // namespace lute::compare
