#include "lute_run.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "tests/file_text.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const fs::path& scratch) {
  const auto redirect = [&](const char* name, int flags, int target) {
    dup2(open((scratch / name).c_str(), flags, 0600), target);
  };
  redirect("in", O_RDONLY, STDIN_FILENO);
  redirect("out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect("error", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  _exit(127);
}

}  // namespace

const char* const kSmallScene =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1 }\n"
    "camera { location <0, 1, -5> look_at 0 }\n"
    "light_source { <5, 8, -10> rgb 1 }\n"
    "sphere { 0, 1 pigment { rgb <1, 0.4, 0.1> } finish { reflection 0.2 } }\n"
    "plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } }\n";

LuteRun run_lute(const std::vector<std::string>& arguments, const std::string& input, double interrupt_after,
                 const std::string& program) {
  const fs::path scratch = fs::path(testing::TempDir()) / ("lute_run_" + std::to_string(getpid()));
  fs::create_directories(scratch);
  std::ofstream(scratch / "in", std::ios::binary) << input;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) become(program.empty() ? LUTE_BINARY_DIR "/lute" : program, arguments, scratch);
  if (interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(interrupt_after));
    kill(child, SIGINT);
  }
  int status = 0;
  waitpid(child, &status, 0);
  LuteRun run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = test::file_text(scratch / "out");
  run.error = test::file_text(scratch / "error");
  fs::remove_all(scratch);
  return run;
}

void LuteFolder::SetUp() {
  folder_ = fs::path(testing::TempDir()) / ("lute_app_" + std::to_string(getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  write("small.pov", kSmallScene);
}

void LuteFolder::TearDown() { fs::remove_all(folder_); }

void LuteFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string LuteFolder::content(const std::string& name) const { return test::file_text(folder_ / name); }

std::vector<std::string> LuteFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace lute
