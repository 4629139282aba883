// Reads scene text in tests: the scene, or the message of the fatal error.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "parser/parse.hpp"

namespace lute::test {

inline ParseResult read_scene(std::string_view text) {
  ParseOptions options;
  options.input_file = "test.pov";
  options.input_text = std::string(text);
  options.library_paths = {"/usr/share/povray-3.7/include"};
  return parse_scene(options);
}

// The scene of a text that must be accepted.
inline Scene scene_of(std::string_view text) {
  ParseResult result = read_scene(text);
  EXPECT_TRUE(result.ok) << (result.diagnostics.empty() ? std::string() : result.diagnostics.back().message);
  return std::move(result.scene);
}

// The message of the fatal error; empty if the text is accepted.
inline std::string rejection_of(std::string_view text) {
  const ParseResult result = read_scene(text);
  const auto first = std::ranges::find(result.diagnostics, Severity::kError, &Diagnostic::severity);
  return first == result.diagnostics.end() ? std::string() : first->message;
}

inline bool warns(std::string_view text, std::string_view message) {
  const ParseResult result = read_scene(text);
  return std::ranges::any_of(result.diagnostics, [&](const Diagnostic& d) { return d.message.find(message) != std::string::npos; });
}

inline const std::string kVersion = "#version 3.7; global_settings { assumed_gamma 1 }\n";

inline const Object& only_object(const Scene& scene) {
  EXPECT_EQ(scene.objects.size(), 1u);
  return *scene.objects.at(0);
}
inline const TextureLayer& layer(const Object& object, std::size_t index) {
  return std::get<std::vector<TextureLayer>>(object.texture.texture->content).at(index);
}
inline std::size_t layer_count(const Object& object) {
  return std::get<std::vector<TextureLayer>>(object.texture.texture->content).size();
}
inline Color plain_color(const Pigment& pigment) { return std::get<Color>(pigment.map); }

}  // namespace lute::test
