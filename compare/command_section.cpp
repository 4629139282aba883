#include <iostream>
#include <iterator>
#include <memory>

#include "compare/command.hpp"
#include "compare/page_section.hpp"

namespace lute::compare {

namespace {

struct SectionOptions {
  std::string page, name;
};

}  // namespace

void add_section_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SectionOptions>();
  CLI::App* command = app.add_subcommand("section", "Replaces a section of a page with what standard input says");
  command->add_option("page", options->page, "The page, with the section's two marks")->required();
  command->add_option("name", options->name, "The section's name")->required();
  command->callback([options, &exit_code] {
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    replace_section(options->page, options->name, text);
    exit_code = kExitMatch;
  });
}

}  // namespace lute::compare
