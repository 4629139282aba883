// Large files are read in little more memory than what they describe takes, and large nonsense is refused soon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "compare/large_scenes.hpp"
#include "compare/process.hpp"
#include "lute_run.hpp"

namespace lute {
namespace {

using testing::HasSubstr;

class LargeInput : public LuteFolder {
 protected:
  compare::ProcessResult check(const std::string& scene) const {
    compare::ProcessRequest request;
    request.arguments = {LUTE_BINARY_DIR "/lute", "--check", path(scene)};
    request.standard_error = path("said");
    request.time_limit = 300;
    return compare::run_process(request);
  }
};

TEST_F(LargeInput, AMeshTakesAtMostThreeTimesTheMemoryOfItsData) {
  constexpr std::int64_t kFaces = 1'000'000;  // 46 MB of text; docs/reading.md has the figures of 5 million
  compare::write_mesh(path("mesh.pov"), kFaces);
  const std::int64_t idle = check("small.pov").peak_memory;
  const compare::ProcessResult mesh = check("mesh.pov");
  EXPECT_EQ(mesh.exit_code, 0) << content("said");
  // A face has the numbers of its corners, its normal and about half a vertex: 12, 12 and 12/2 bytes.
  const std::int64_t data = kFaces * 30;
  EXPECT_LE(mesh.peak_memory - idle, 3 * data);
}

// Not the time on the wall: other tests run beside this one.
TEST_F(LargeInput, NonsenseOfAHundredMegabytesIsRefusedWithinASecond) {
  write("letters.pov", std::string(100'000'000, 'a'));
  const compare::ProcessResult letters = check("letters.pov");
  EXPECT_EQ(letters.exit_code, 1);
  EXPECT_LE(letters.user, 1.0);
  EXPECT_LE(letters.peak_memory, 200'000'000);  // the file, once
  EXPECT_THAT(content("said"), HasSubstr("letters.pov:1:1: error: String too long."));
  EXPECT_LT(content("said").size(), 1000u);
}

// A file is lexed no further than reading comes: each ends at an error near its beginning. (`}` are errors one by one.)
TEST_F(LargeInput, FilesOfOneWordAreRefusedWithinASecond) {
  for (const std::string word : {"{", "(", "}", "a ", "#if(1)", "union{", "sphere ", "[", "<", "\"a\"", "#declare a=("}) {
    {
      std::ofstream file(path("word.pov"));
      for (std::size_t size = 0; size < 100'000'000; size += word.size()) file << word;
    }
    const compare::ProcessResult result = check("word.pov");
    EXPECT_EQ(result.exit_code, 1) << word;
    EXPECT_LE(result.cpu, 1.0) << word;
    EXPECT_LE(result.peak_memory, 200'000'000) << word;
    EXPECT_THAT(content("said"), HasSubstr(": error: ")) << word;
  }
}

// Tokens that were read are forgotten: 16 bytes for every two of the text would be 800 MB.
TEST_F(LargeInput, StatementsThatWereReadTakeNoMemory) {
  constexpr int kLines = 3'000'000, kBetweenCalls = 10'000;
  {
    std::ofstream file(path("values.pov"));
    file << "#version 3.7;\n#macro Kept() #declare Sum = Sum + 1; #end\n#declare Sum = 0;\n";
    for (int i = 0; i < kLines; ++i) file << (i % kBetweenCalls == 0 ? "Kept()\n" : "#declare A=1;#declare B=A+(2*3);\n");
    file << "#if (Sum != " << kLines / kBetweenCalls << ") #error \"macro\" #end\nsphere { 0, 1 }\n";
  }
  const compare::ProcessResult result = check("values.pov");
  EXPECT_EQ(result.exit_code, 0) << content("said");
  EXPECT_LE(result.peak_memory, 200'000'000);
}

}  // namespace
}  // namespace lute
