// The fuzzers' corpus, read again: everything that once went wrong stays right.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "engine/build/geometry_answers.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/options/option_reader.hpp"
#include "parser/parse.hpp"
#include "parser/machine_memory.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus(const std::string& kind) {
  std::vector<std::string> texts;
  for (const auto& entry : fs::directory_iterator(LUTE_SOURCE_DIR "/fuzz/corpus/" + kind)) {
    std::ifstream in(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

// In an empty folder, where scenes may write.
class Corpus : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

 private:
  fs::path before_ = fs::current_path();
  fs::path folder_ = fs::temp_directory_path() / ("lute_corpus_" + std::to_string(::getpid()));
};

TEST_F(Corpus, ScenesAreReadOrRefused) {
  const std::vector<std::string> texts = corpus("scene");
  ASSERT_GT(texts.size(), 30u);
  for (const std::string& text : texts) {
    GeometryAnswers geometry;
    CompiledTextureFunctions functions;
    ParseOptions options;
    options.input_file = "/nonexistent/corpus.pov";
    options.input_text = text;
    options.geometry = &geometry;
    options.texture_functions = &functions;
    options.limits.loop_turns = 1000;
    options.limits.tokens = 20'000;
    options.limits.memory_bytes = resident_bytes() + (256u << 20);
    const ParseResult result = parse_scene(options);
    EXPECT_TRUE(result.ok || !result.diagnostics.empty());
  }
}

TEST_F(Corpus, OptionsAreReadOrRefused) {
  const std::vector<std::string> texts = corpus("ini");
  ASSERT_GT(texts.size(), 1u);
  for (const std::string& text : texts) {
    OptionEnvironment environment;
    environment.variable = [](const std::string&) { return std::nullopt; };
    environment.read_file = [&](const std::string& name) {
      return name == "fuzz.ini" ? std::optional<std::string>(text) : std::nullopt;
    };
    const std::string arguments[] = {"fuzz.ini[first]"};
    try {
      EXPECT_GT(read_options(arguments, environment).width, 0);
    } catch (const OptionError& error) {
      EXPECT_STRNE(error.what(), "");
    }
  }
}

}  // namespace
}  // namespace lute
