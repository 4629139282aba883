// libFuzzer target: scene text through lexer, directives, expressions and statements. What it finds is kept in fuzz/corpus and
// read again by the ordinary tests (tests/parser/corpus_test.cpp).
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/parse.hpp"
#include "parser/resource_meter.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lute::GeometryAnswers geometry;
  lute::CompiledTextureFunctions functions;
  lute::ParseOptions options;
  options.input_file = "/nonexistent/fuzz.pov";
  options.input_text = std::string(reinterpret_cast<const char*>(data), size);
  options.geometry = &geometry;
  options.texture_functions = &functions;
  options.limits.loop_turns = 1000;
  options.limits.tokens = 20'000;
  options.limits.memory_bytes = lute::resident_bytes() + (256u << 20);
  lute::parse_scene(options);
  return 0;
}
