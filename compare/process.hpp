// Runs a program as a child with a time limit and a memory limit, and says what it used.
//
// The child gets a process group of its own, so that a program that starts others is ended with all of them. Standard
// input is empty; standard output and error go to files of the caller's choice.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lute::compare {

struct ProcessRequest {
  std::vector<std::string> arguments;  // arguments[0] is the program, looked up in PATH
  std::filesystem::path working_directory;
  std::filesystem::path standard_output = "/dev/null";
  std::filesystem::path standard_error = "/dev/null";
  double time_limit = 0;           // seconds of wall time, 0 = none
  std::uint64_t memory_limit = 0;  // bytes of address space, 0 = none
};

struct ProcessResult {
  bool started = false;          // false: the program could not be executed
  bool timed_out = false;        // ended by the time limit
  int exit_code = -1;            // when it ended by itself
  int signal = 0;                // when a signal ended it
  double wall = 0;               // seconds
  double cpu = 0;                // seconds, user and system, all threads
  double user = 0;               // seconds, user alone
  std::int64_t peak_memory = 0;  // bytes resident; not below what this program held when it started the other

  bool succeeded() const { return started && !timed_out && signal == 0 && exit_code == 0; }
};

ProcessResult run_process(const ProcessRequest& request);

}  // namespace lute::compare
