#include <filesystem>
#include <fstream>
#include <memory>

#include "compare/command.hpp"
#include "compare/coverage.hpp"
#include "compare/run_options.hpp"

namespace lute::compare {

namespace {

struct CoverageOptions : RunOptions {
  std::string scenes = LUTE_SOURCE_SCENES;
  std::string table = LUTE_STATE_TABLE;
  std::string page = "docs/coverage.md";
};

int run_coverage(CoverageOptions& options) {
  const StateTable examples = read_states(options.table);
  ReportContext context;
  context.title = "Coverage";
  if (options.filter.empty()) options.filter = "^(lecture|feature)/";
  const std::vector<SceneComparison> features = run_scenes(options, {options.scenes}, context);
  // A page appears whole or not at all.
  const std::string draft = options.page + ".new";
  {
    std::ofstream page(draft);
    write_coverage(page, features, examples);
    if (!page.flush()) throw std::runtime_error("cannot write " + draft);
  }
  std::filesystem::rename(draft, options.page);
  return kExitMatch;
}

}  // namespace

void add_coverage_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CoverageOptions>();
  options->lute = default_lute_program();
  options->output = "lute-coverage";
  CLI::App* command = app.add_subcommand("coverage", "Write the page that says which features match");
  command->add_option("scenes", options->scenes, "Folder with lecture/ and feature/");
  command->add_option("--table", options->table, "States of the example scenes");
  command->add_option("--page", options->page, "The Markdown page to write");
  add_run_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run_coverage(*options); });
}

}  // namespace lute::compare
