#include <cmath>
#include <cstdio>
#include <memory>

#include "compare/command.hpp"
#include "compare/noise_comparison.hpp"

namespace lute::compare {

namespace {

struct NoiseOptions {
  int side = 1000;
  double tolerance = 1e-6;
  std::string lute = "lute", povray = "povray";
};

int run_noise(const NoiseOptions& options) {
  std::printf("noise_generator    points   largest difference   mean difference   (resolution %.1e)\n", kNoiseResolution);
  bool good = true;
  for (const int generator : {1, 2, 3}) {
    const NoiseComparison c = compare_noise(generator, options.side, options.lute, options.povray);
    std::printf("%15d  %8zu   %18.3e   %15.3e\n", c.generator, c.points, c.largest, c.mean);
    good = good && c.largest <= options.tolerance;
  }
  return good ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_noise_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<NoiseOptions>();
  options->lute = default_lute_program();
  CLI::App* command = app.add_subcommand("noise", "The noise of both programs at many points, by 16-bit pictures");
  command->add_option("--side", options->side, "Points along each side of the picture")->check(CLI::Range(1, 10000));
  command->add_option("--tolerance", options->tolerance, "Largest difference for a match; the noise is 0...1");
  command->add_option("--lute", options->lute, "The lute program");
  command->add_option("--povray", options->povray, "The reference program");
  command->callback([options, &exit_code] { exit_code = run_noise(*options); });
}

}  // namespace lute::compare
