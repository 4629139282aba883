// The commands of lute-compare. Each adds its switches to the application and returns an exit code when it runs:
// 0 everything matches, 1 something differs, 2 wrong use or a file that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lute::compare {

constexpr int kExitMatch = 0, kExitDiffers = 1, kExitUsage = 2;

void add_diff_command(CLI::App& app, int& exit_code);
void add_run_command(CLI::App& app, int& exit_code);
void add_state_command(CLI::App& app, int& exit_code);
void add_coverage_command(CLI::App& app, int& exit_code);
void add_sweep_command(CLI::App& app, int& exit_code);
void add_noise_command(CLI::App& app, int& exit_code);
void add_parse_command(CLI::App& app, int& exit_code);
void add_speed_command(CLI::App& app, int& exit_code);
void add_samples_command(CLI::App& app, int& exit_code);
void add_section_command(CLI::App& app, int& exit_code);

// "160x120" → width and height; throws CLI::ValidationError.
void parse_size(const std::string& text, int& width, int& height);

// The `lute` beside this program if there is one, else "lute" from PATH.
std::string default_lute_program();

}  // namespace lute::compare
