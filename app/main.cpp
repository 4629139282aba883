// lute: renders POV-Ray scene files.

#include <algorithm>
#include <string>
#include <vector>

#include "app/interrupt.hpp"
#include "app/session.hpp"
#include "parser/options/option_reader.hpp"

int main(int argc, char** argv) {
  lute::Interrupt::install();
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    return static_cast<int>(lute::run_session(lute::read_options(arguments, lute::OptionEnvironment::of_process())));
  } catch (const lute::OptionError& error) {
    // Of the options that cannot be read this one still says who reads the answer.
    lute::RenderOptions options;
    options.json_diagnostics = std::ranges::count(arguments, "--diagnostics=json") > 0;
    lute::Console console(options);
    const lute::ExitCode code = lute::report(error, console);
    console.finish(false);
    return static_cast<int>(code);
  }
}
