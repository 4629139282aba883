#include "compare/process.hpp"

#include <gtest/gtest.h>

#include "compare/content_hash.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

ProcessResult shell(const std::string& command, double time_limit = 0,
                    const std::filesystem::path& output = "/dev/null") {
  ProcessRequest request;
  request.arguments = {"sh", "-c", command};
  request.time_limit = time_limit;
  request.standard_output = output;
  return run_process(request);
}

TEST(Process, ReportsTheExitCode) {
  EXPECT_TRUE(shell("true").succeeded());
  EXPECT_EQ(shell("exit 3").exit_code, 3);
}

TEST(Process, ReportsTheSignal) { EXPECT_EQ(shell("kill -SEGV $$").signal, 11); }

TEST(Process, MissingProgramDidNotStart) {
  ProcessRequest request;
  request.arguments = {"/no/such/program"};
  EXPECT_FALSE(run_process(request).started);
}

TEST(Process, TimeLimitEndsTheWholeGroup) {
  const ScratchFolder folder;
  const auto mark = folder.path() / "mark";
  const ProcessResult result = shell("(sleep 1; touch " + mark.string() + ") & sleep 30", 0.2);
  EXPECT_TRUE(result.timed_out);
  EXPECT_LT(result.wall, 10);
  shell("sleep 1.2");
  EXPECT_FALSE(std::filesystem::exists(mark)) << "a child of the ended program went on";
}

TEST(Process, MeasuresProcessorTimeApartFromWallTime) {
  const ProcessResult result = shell("sleep 0.3");
  EXPECT_GE(result.wall, 0.3);
  EXPECT_LT(result.cpu, 0.1);
}

TEST(ScratchFolder, WritesOfASceneDoNotReachTheOriginal) {
  const ScratchFolder original;
  shell("echo old > " + (original.path() / "data.inc").string());
  {
    const ScratchFolder copy(original.path());
    shell("echo new > " + (copy.path() / "data.inc").string());
    EXPECT_EQ(read_file(copy.path() / "data.inc"), "new\n");
  }
  EXPECT_EQ(read_file(original.path() / "data.inc"), "old\n");
}

TEST(SceneHash, ChangesWithTextFilesSwitchesAndVersionOnly) {
  const ScratchFolder folder;
  const auto scene = folder.path() / "a.pov";
  shell("echo 'sphere{0,1}' > " + scene.string());
  const std::string before = scene_hash(scene, {"+W80"}, "1");
  EXPECT_EQ(before, scene_hash(scene, {"+W80"}, "1"));
  EXPECT_NE(before, scene_hash(scene, {"+W81"}, "1"));
  EXPECT_NE(before, scene_hash(scene, {"+W80"}, "2"));
  shell("echo other > " + (folder.path() / "b.pov").string());
  EXPECT_EQ(before, scene_hash(scene, {"+W80"}, "1")) << "another scene beside it is no part of this one";
  shell("echo text > " + (folder.path() / "b.inc").string());
  EXPECT_NE(before, scene_hash(scene, {"+W80"}, "1"));
}

}  // namespace
}  // namespace lute::compare
