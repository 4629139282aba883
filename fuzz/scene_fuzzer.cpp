// libFuzzer target: scene text through lexer, directives, expressions and statements. What it finds is kept in fuzz/corpus and
// read again by the ordinary tests (tests/parser/corpus_test.cpp).
#include <cstddef>
#include <cstdint>

#include "fuzz/read_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_scene(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
