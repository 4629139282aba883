// The first error that a program finds in a scene, as "FILE:LINE: MESSAGE"; "accepted" if there is none.
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/file_text.hpp"

namespace lute::compare {

// What the program says of test.pov, which it reads in a folder with the files of `files`.
inline std::string said_about(const std::string& scene, const std::filesystem::path& files, std::vector<std::string> arguments) {
  const ScratchFolder folder(files);
  std::ofstream(folder.path() / "test.pov", std::ios::binary) << scene;
  ProcessRequest request;
  request.arguments = std::move(arguments);
  request.working_directory = folder.path();
  request.standard_error = folder.path() / "said";
  request.time_limit = 60;
  const ProcessResult result = run_process(request);
  std::string said = test::file_text(request.standard_error);
  if (result.exit_code != 0 && said.find("rror") == std::string::npos) said += "\ntest.pov:0: error: ended without an error";
  return said;
}

// POV-Ray breaks lines, also within words. An error that it finds without a place stands at line 0.
inline std::string reference_error(const std::string& scene, const std::filesystem::path& files) {
  const std::string said = said_about(scene, files, {"povray", "+Itest.pov", "+W1", "+H1", "-F", "-D"});
  static const std::regex placed(R"(File '([^']*)' line (\d+): Parse Error: ([^]*?)\n(?:Fatal error|====))");
  static const std::regex anywhere(R"(Parse Error: ([^]*?)\n(?:Fatal error|====))");
  std::smatch found;
  const auto joined = [](const std::string& text) {
    return std::regex_replace(std::regex_replace(text, std::regex("\n"), ""), std::regex(" +$"), "");
  };
  if (std::regex_search(said, found, placed)) {
    return std::filesystem::path(found[1].str()).filename().string() + ":" + found[2].str() + ": " + joined(found[3].str());
  }
  if (said.find("Fatal error") == std::string::npos) return "accepted";
  return std::regex_search(said, found, anywhere) ? "test.pov:0: " + joined(found[1].str()) : "another error";
}

// The same of many scenes, several at a time: POV-Ray sleeps most of the half second that it takes for each.
inline std::vector<std::string> reference_errors(const std::vector<std::string>& scenes, const std::filesystem::path& files) {
  constexpr int kAtOnce = 6;
  std::vector<std::string> errors(scenes.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < scenes.size();) errors[i] = reference_error(scenes[i], files);
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < kAtOnce; ++i) threads.emplace_back(work);
  threads.clear();  // waits for them
  return errors;
}

inline std::string error_told_by_lute(const std::string& said) {
  static const std::regex pattern(R"(([^:\n]*):(\d+)(?::\d+)?: error: ([^\n]*))");
  std::smatch found;
  if (!std::regex_search(said, found, pattern)) return "accepted";
  return found[1].str() + ":" + found[2].str() + ": " + found[3].str();
}

}  // namespace lute::compare
