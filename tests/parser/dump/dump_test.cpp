// What the parser and the lexer saw: scene/NAME.pov as scene/NAME.json, tokens/NAME.pov as tokens/NAME.txt. The scenes leave out what is
// the same in the plainest scene, plain.pov, which is recorded in full.
#include "parser/dump/dump.hpp"

#include <algorithm>
#include <filesystem>

#include "tests/golden.hpp"
#include "tests/parser/dump/golden_json.hpp"
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(LUTE_SOURCE_DIR) / "tests" / "parser" / "dump";

std::vector<std::string> sources_in(const char* folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder / folder))
    if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

const auto kName = [](const testing::TestParamInfo<std::string>& info) { return info.param; };

nlohmann::json dump_of(const fs::path& source) { return dump_scene(scene_of(file_text(source))); }

class SceneDump : public testing::TestWithParam<std::string> {};

TEST_P(SceneDump, IsAsRecorded) {
  const fs::path source = kFolder / "scene" / (GetParam() + ".pov");
  Members plain;
  if (GetParam() != "plain") collect_members(dump_of(kFolder / "scene" / "plain.pov"), plain);
  expect_golden(fs::path(source).replace_extension(".json"), compact_text(without(dump_of(source), plain)) + "\n");
}

INSTANTIATE_TEST_SUITE_P(Golden, SceneDump, testing::ValuesIn(sources_in("scene")), kName);

class TokenDump : public testing::TestWithParam<std::string> {};

TEST_P(TokenDump, IsAsRecorded) {
  const fs::path source = kFolder / "tokens" / (GetParam() + ".pov");
  expect_golden(fs::path(source).replace_extension(".txt"), dump_tokens(source.filename().string(), file_text(source)));
}

INSTANTIATE_TEST_SUITE_P(Golden, TokenDump, testing::ValuesIn(sources_in("tokens")), kName);

TEST(Dump, SinglePrecisionKeepsItsOwnDigits) {
  const auto json = dump_scene(scene_of("#version 3.7; sphere { 0, 1 pigment { rgb 0.1 } }"));
  EXPECT_EQ(json["objects"][0]["texture"]["texture"]["layers"][0]["pigment"]["color"].dump(), "[0.1,0.1,0.1,0.0,0.0]");
}

}  // namespace
}  // namespace lute::test
