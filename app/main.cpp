// lute: renders POV-Ray scene files.

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/interrupt.hpp"
#include "app/session.hpp"
#include "parser/options/option_reader.hpp"

namespace {

int report(const std::string& message, const std::string& hint, lute::ExitCode code) {
  std::fprintf(stderr, "lute: error: %s\n", message.c_str());
  if (!hint.empty()) std::fprintf(stderr, "  %s\n", hint.c_str());
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  lute::Interrupt::install();
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const lute::RenderOptions options = lute::read_options(arguments, lute::OptionEnvironment::of_process());
    return static_cast<int>(lute::run_session(options));
  } catch (const lute::OptionError& error) {
    return report(error.what(), error.hint(), lute::ExitCode::kUsage);
  } catch (const std::bad_alloc&) {
    return report("out of memory", "", lute::ExitCode::kFailed);
  } catch (const std::exception& error) {
    return report(error.what(), "", lute::ExitCode::kFailed);
  }
}
