#include "parser/machine_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace lute::test {
namespace {

namespace fs = std::filesystem;

class MachineMemory : public testing::Test {
 protected:
  void SetUp() override {
    mount_ = fs::path(testing::TempDir()) /
             ("lute_groups_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + std::to_string(getpid()));
    fs::remove_all(mount_);
  }
  void TearDown() override { fs::remove_all(mount_); }
  void limit(const std::string& file, const std::string& text) const {
    fs::create_directories((mount_ / file).parent_path());
    std::ofstream(mount_ / file) << text << '\n';
  }
  fs::path mount_;
};

TEST_F(MachineMemory, TheLeastOfTheGroupsAroundTheProcessCounts) {
  limit("user.slice/memory.max", "3000000000");
  limit("user.slice/job/memory.max", "max");
  limit("user.slice/other/memory.max", "1000");
  EXPECT_EQ(control_group_memory("0::/user.slice/job\n", mount_), 3'000'000'000u);
  limit("user.slice/job/memory.max", "2000000000");
  EXPECT_EQ(control_group_memory("0::/user.slice/job\n", mount_), 2'000'000'000u);
  EXPECT_EQ(control_group_memory("0::/\n", mount_), kNoMemoryLimit);
}

TEST_F(MachineMemory, InAContainerTheRootIsTheGroup) {
  limit("memory.max", "500000000");
  EXPECT_EQ(control_group_memory("0::/not/seen/here\n", mount_), 500'000'000u);
}

TEST_F(MachineMemory, GroupsOfVersionOneAreAskedForMemoryOnly) {
  limit("memory/job/memory.limit_in_bytes", "700000000");
  limit("cpu/job/memory.limit_in_bytes", "5");
  EXPECT_EQ(control_group_memory("5:cpu,cpuacct:/job\n4:memory:/job\n0::/\n", mount_), 700'000'000u);
  EXPECT_EQ(control_group_memory("9:hugetlb,memory:/job", mount_), 700'000'000u);
  EXPECT_EQ(control_group_memory("5:cpu,cpuacct:/job\n", mount_), kNoMemoryLimit);
}

TEST_F(MachineMemory, WithoutGroupsThereIsNoLimitOfTheirs) {
  EXPECT_EQ(control_group_memory("", mount_), kNoMemoryLimit);
  EXPECT_EQ(control_group_memory("nonsense\n0::/gone\n", mount_), kNoMemoryLimit);
}

// 100 pages are mapped, 40 in use: the other 60 are lost to the process.
TEST(MemoryUnderLimit, MappedPagesThatAreNotInUseAreTakenOff) {
  EXPECT_EQ(memory_under_limit(1'000'000, 100, 40, 4096), 1'000'000u - 60 * 4096);
  EXPECT_EQ(memory_under_limit(1'000'000, 100, 100, 4096), 1'000'000u);
  EXPECT_EQ(memory_under_limit(4'000'000, 100, 40, 65536), 4'000'000u - 60 * 65536);
}

TEST(MemoryUnderLimit, IsNeverNothing) {
  EXPECT_EQ(memory_under_limit(60 * 4096, 100, 40, 4096), 1u);
  EXPECT_EQ(memory_under_limit(60 * 4096 + 2, 100, 40, 4096), 2u);
  EXPECT_EQ(memory_under_limit(1000, 100, 40, 4096), 1u);
  EXPECT_EQ(memory_under_limit(1000, 40, 100, 4096), 1000u);  // counted at different moments
}

TEST_F(MachineMemory, TheResourceLimitCounts) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's shadow needs more address space than the limit";
#endif
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit less = before;
  less.rlim_cur = resident_bytes() + (rlim_t{1} << 31);
  if (before.rlim_cur < less.rlim_cur) GTEST_SKIP() << "the test runs under a smaller limit";
  ASSERT_EQ(setrlimit(RLIMIT_AS, &less), 0);
  const std::uint64_t memory = machine_memory();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_LE(memory, less.rlim_cur);
  EXPECT_GT(memory, 0u);
}

}  // namespace
}  // namespace lute::test
