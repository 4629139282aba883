#include "parser/dump/dump.hpp"

#include <fstream>
#include <sstream>

#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

std::string file_text(const std::string& name) {
  std::ifstream file(name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// Every *.pov beside this test has its *.json. To renew one after an intended change: lute --dump-scene NAME.pov, in this folder.
class GoldenScene : public testing::TestWithParam<const char*> {};

TEST_P(GoldenScene, DumpIsAsRecorded) {
  const std::string base = std::string(LUTE_SOURCE_DIR) + "/tests/parser/dump/" + GetParam();
  const std::string dumped = dump_scene(scene_of(file_text(base + ".pov"))).dump(2) + "\n";
  EXPECT_EQ(dumped, file_text(base + ".json"));
}

INSTANTIATE_TEST_SUITE_P(Dump, GoldenScene, testing::Values("csg", "textures", "surroundings"));

TEST(Dump, SinglePrecisionKeepsItsOwnDigits) {
  const auto json = dump_scene(scene_of("#version 3.7; sphere { 0, 1 pigment { rgb 0.1 } }"));
  EXPECT_EQ(json["objects"][0]["texture"]["texture"]["layers"][0]["pigment"]["color"].dump(), "[0.1,0.1,0.1,0.0,0.0]");
}

}  // namespace
}  // namespace lute::test
