// libFuzzer target: INI text and command lines.
#include <cstddef>
#include <cstdint>
#include <string>

#include "parser/options/option_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  lute::OptionEnvironment environment;
  environment.variable = [](const std::string&) { return std::nullopt; };
  environment.read_file = [&](const std::string& name) {
    return name == "fuzz.ini" ? std::optional<std::string>(text) : std::nullopt;
  };
  const std::string arguments[] = {"fuzz.ini[first]"};
  try {
    lute::read_options(arguments, environment);
  } catch (const lute::OptionError&) {
  }
  return 0;
}
