// lute-compare: how far pictures are apart, and how far lute is from POV-Ray.
#include <exception>
#include <iostream>

#include "compare/command.hpp"

int main(int argc, char** argv) {
  CLI::App app("Compares pictures, and the renderers lute and POV-Ray.", "lute-compare");
  app.require_subcommand(1);
  app.option_defaults()->always_capture_default();
  int exit_code = lute::compare::kExitMatch;
  lute::compare::add_diff_command(app, exit_code);
  lute::compare::add_run_command(app, exit_code);
  lute::compare::add_state_command(app, exit_code);
  lute::compare::add_coverage_command(app, exit_code);
  lute::compare::add_sweep_command(app, exit_code);
  lute::compare::add_noise_command(app, exit_code);
  lute::compare::add_parse_command(app, exit_code);
  lute::compare::add_speed_command(app, exit_code);
  lute::compare::add_samples_command(app, exit_code);
  lute::compare::add_section_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? lute::compare::kExitMatch : lute::compare::kExitUsage;
  } catch (const std::exception& error) {
    std::cerr << "lute-compare: " << error.what() << '\n';
    return lute::compare::kExitUsage;
  }
  return exit_code;
}
