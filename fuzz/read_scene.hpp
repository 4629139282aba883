// A scene as the fuzzers read it: with everything a scene can ask for, and with limits that end each reading soon.
#pragma once

#include <string>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/machine_memory.hpp"
#include "parser/parse.hpp"

inline lute::ParseResult read_scene(std::string text) {
  lute::GeometryAnswers geometry;
  lute::CompiledTextureFunctions functions;
  lute::ParseOptions options;
  options.input_file = "/nonexistent/fuzz.pov";
  options.input_text = std::move(text);
  options.geometry = &geometry;
  options.texture_functions = &functions;
  options.limits.loop_turns = 1000;
  options.limits.tokens = 20'000;
  options.limits.memory_bytes = lute::resident_bytes() + (256u << 20);
  return lute::parse_scene(options);
}
