// lute: renders POV-Ray scene files.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/interrupt.hpp"
#include "app/session.hpp"
#include "parser/options/option_reader.hpp"

namespace {

lute::ExitCode run(const std::vector<std::string>& arguments) {
  try {
    return lute::run_session(lute::read_options(arguments, lute::OptionEnvironment::of_process()));
  } catch (const lute::OptionError& error) {
    // Of the options that cannot be read this one still says who reads the answer.
    lute::RenderOptions options;
    options.json_diagnostics = std::ranges::count(arguments, "--diagnostics=json") > 0;
    lute::Console console(options);
    const lute::ExitCode code = lute::report(error, console);
    console.finish(false);
    return code;
  }
}

}  // namespace

int main(int argc, char** argv) {
  lute::Interrupt::install();
  const lute::ExitCode code = run(std::vector<std::string>(argv + 1, argv + argc));
  // POV-Ray has one exit code for all mistakes, and whoever calls `povray` expects it.
  const bool as_povray = std::filesystem::path(argv[0]).filename() == "povray";
  return static_cast<int>(as_povray && code == lute::ExitCode::kUsage ? lute::ExitCode::kFailed : code);
}
