// Runs the built program as a user would.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lute {

struct LuteRun {
  int exit_code = -1;
  std::string out, error;
  double seconds = 0;
};

// `interrupt_after`: seconds until SIGINT; 0: none. `program`: another name for the program.
LuteRun run_lute(const std::vector<std::string>& arguments, const std::string& input = "", double interrupt_after = 0,
                 const std::string& program = "");

// A folder of its own for each test, with a small scene in it.
class LuteFolder : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string content(const std::string& name) const;
  std::vector<std::string> files() const;  // sorted

  std::filesystem::path folder_;
};

extern const char* const kSmallScene;

}  // namespace lute
