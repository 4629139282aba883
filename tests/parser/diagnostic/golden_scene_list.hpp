// Golden files of what is said about scenes: errors.golden and warnings.golden, each a list of scenes with their messages.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/file_text.hpp"

namespace lute::test {

inline const std::string kDiagnosticFolder = LUTE_SOURCE_DIR "/tests/parser/diagnostic/";

struct GoldenScenes {
  std::string head;
  std::vector<std::pair<std::string, std::string>> cases;  // scene, what is said
  std::string all_said() const {
    std::string all;
    for (const auto& [scene, says] : cases) all += says;
    return all;
  }
};

constexpr std::string_view kSceneMark = "==== scene\n", kSaysMark = "---- says\n";

inline GoldenScenes read_golden_scenes(const std::string& path) {
  const std::string text = file_text(path);
  GoldenScenes golden;
  std::size_t at = text.find(kSceneMark);
  golden.head = text.substr(0, at);
  while (at != std::string::npos) {
    const std::size_t says = text.find(kSaysMark, at);
    const std::size_t next = text.find(kSceneMark, says);
    golden.cases.emplace_back(text.substr(at + kSceneMark.size(), says - at - kSceneMark.size()),
                              text.substr(says + kSaysMark.size(), next - says - kSaysMark.size()));
    at = next;
  }
  return golden;
}

}  // namespace lute::test
