// Golden tests of every kind of error: the message, the place, what was found and what to write instead.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "tests/golden.hpp"
#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

const std::string kFolder = LUTE_SOURCE_DIR "/tests/parser/diagnostic/errors";
const std::string kGolden = LUTE_SOURCE_DIR "/tests/parser/diagnostic/errors.golden";
constexpr std::string_view kSceneMark = "==== scene\n", kSaysMark = "---- says\n";

struct Golden {
  std::string head;
  std::vector<std::pair<std::string, std::string>> cases;  // scene, what is said
};

Golden read_golden() {
  const std::string text = file_text(kGolden);
  Golden golden;
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

// The errors of a scene, with the folder's name taken out. A scene with a #version of its own stands alone.
std::string said_about(const std::string& scene) {
  GeometryAnswers geometry;
  CompiledTextureFunctions functions;
  ParseOptions options;
  options.geometry = &geometry;
  options.texture_functions = &functions;
  options.library_paths = {kFolder};
  options.allow_write = {"/nowhere", "/dev/null"};
  // Small, so that going over them takes no time.
  options.limits.loop_turns = 2'000'000;
  options.limits.tokens = 20'000'000;
  options.limits.memory_bytes = 1ull << 30;
  options.limits.file_bytes = 1000;
  std::string said;
  std::vector<Diagnostic> diagnostics;
  if (scene.starts_with("#version")) {
    options.input_file = "test.pov";
    options.input_text = scene;
    diagnostics = parse_scene(options).diagnostics;
  } else {
    diagnostics = read_text(scene, options).diagnostics;
  }
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::kError) said += to_text(d);
  }
  for (std::size_t at; (at = said.find(kFolder + "/")) != std::string::npos;) said.erase(at, kFolder.size() + 1);
  return said;
}

TEST(ErrorMessages, AreAsRecorded) {
  Golden golden = read_golden();
  ASSERT_GT(golden.cases.size(), 200u);
  if (golden_is_renewed()) {
    std::string text = golden.head;
    for (const auto& [scene, says] : golden.cases) text.append(kSceneMark).append(scene).append(kSaysMark).append(said_about(scene));
    return renew_golden(kGolden, text);
  }
  for (const auto& [scene, says] : golden.cases) {
    EXPECT_NE(says, "") << scene;
    EXPECT_EQ(said_about(scene), says) << scene;
  }
}

// Messages that no scene can bring forth in this test, each with its reason.
const std::set<std::string> kNotInScenes = {
    "Objects cannot be asked here: no engine is connected.",                    // only without the engine
    "Pigment and pattern functions need the engine, which is not connected.",   // the same
    "Cannot open input file '",                                                 // tests/app
    "version",                                                                  // a code: the message is put together
    "domain", "missing-semicolon", "bad-file",                                  // codes as well
    "Reading behind an error takes too long.",                                  // not told
    "This cannot be used as a function.",                                       // guards a table
};

// The texts that the parser's sources hand to the functions that report errors.
std::set<std::string> messages_in_sources() {
  const std::regex call(
      R"re((?:\bfail|fail_at|fail_after|\berror|error_expected|fail_expected|LexFailure|as_many|no_more)[({,]\s*(?:[\w.]+,\s*)?"((?:[^"\\]|\\.)*)")re");
  std::set<std::string> messages;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(LUTE_SOURCE_DIR "/parser")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = file_text(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found) messages.insert((*found)[1]);
  }
  return messages;
}

TEST(ErrorMessages, EveryKindIsRecorded) {
  std::string all;
  for (const auto& [scene, says] : read_golden().cases) all += says;
  const std::set<std::string> messages = messages_in_sources();
  ASSERT_GT(messages.size(), 150u);
  for (const std::string& message : messages) {
    if (kNotInScenes.contains(message)) continue;
    const bool expected = all.find("Expected '" + message + "'") != std::string::npos;
    EXPECT_TRUE(expected || (message.size() > 3 && all.find(message) != std::string::npos)) << message;
  }
}

}  // namespace
}  // namespace lute::test
