// What the parser says about the scenes of errors.golden and warnings.golden, and what of its texts is in them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "tests/file_text.hpp"
#include "tests/golden.hpp"
#include "tests/parser/diagnostic/golden_scene_list.hpp"
#include "tests/parser/read_text.hpp"

namespace lute::test {

// The errors, or all other messages, about a scene, with the folder's name taken out. A scene with a #version of its own, or that
// begins with a comment, stands alone.
inline std::string said_about(const std::string& scene, bool errors) {
  const std::string folder = kDiagnosticFolder + "errors";
  GeometryAnswers geometry;
  CompiledTextureFunctions functions;
  ParseOptions options;
  options.geometry = &geometry;
  options.texture_functions = &functions;
  options.library_paths = {folder};
  options.allow_write = {"/nowhere", "/dev/null"};
  // Small, so that going over them takes no time.
  options.limits.loop_turns = 2'000'000;
  options.limits.tokens = 20'000'000;
  options.limits.memory_bytes = 1ull << 30;
  options.limits.file_bytes = 1000;
  std::string said;
  std::vector<Diagnostic> diagnostics;
  if (scene.starts_with("#version") || scene.starts_with("//")) {
    options.input_file = "test.pov";
    options.input_text = scene;
    diagnostics = parse_scene(options).diagnostics;
  } else {
    diagnostics = read_text(scene, options).diagnostics;
  }
  for (const Diagnostic& d : diagnostics) {
    if ((d.severity == Severity::kError) == errors) said += to_text(d);
  }
  for (std::size_t at; (at = said.find(folder + "/")) != std::string::npos;) said.erase(at, folder.size() + 1);
  return said;
}

// Each scene of the file is told as it was recorded. The last statement of a test.
inline void expect_golden_scenes(const std::string& path, bool errors) {
  const GoldenScenes golden = read_golden_scenes(path);
  if (golden_is_renewed()) {
    std::string text = golden.head;
    for (const auto& [scene, says] : golden.cases) {
      text.append(kSceneMark).append(scene).append(kSaysMark).append(said_about(scene, errors));
    }
    return renew_golden(path, text);
  }
  for (const auto& [scene, says] : golden.cases) {
    EXPECT_NE(says, "") << scene;
    EXPECT_EQ(said_about(scene, errors), says) << scene;
  }
}

// What follows the call in the parser's sources, in its one group: the texts that it hands to functions that report.
inline std::set<std::string> messages_in_sources(const std::regex& call) {
  std::set<std::string> messages;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(LUTE_SOURCE_DIR "/parser")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = file_text(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found) messages.insert((*found)[1]);
  }
  return messages;
}

}  // namespace lute::test
