#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "compare/command.hpp"
#include "compare/difference.hpp"
#include "compare/match.hpp"

namespace lute::compare {

namespace {

struct DiffOptions {
  std::string first, second, heat_map;
  double tolerance = kPixelTolerance255;
  double least_within = 100 * kLeastShareWithin;
  double largest_rmse = kLargestRmse;
  bool json = false;
};

void print_text(const Difference& d, bool match) {
  std::cout << std::fixed << std::setprecision(6) << "largest difference  " << d.maximum << "\nmean difference     "
            << d.mean << "\nRMSE                " << d.rmse << std::setprecision(2) << "\nPSNR                "
            << d.psnr << " dB"
            << "\nwithin " << std::setprecision(1) << d.tolerance_255 << "/255      " << std::setprecision(4)
            << 100 * d.within << " % of " << d.pixels << " pixels" << std::setprecision(3)
            << "\n8x8 blocks, 98th percentile  " << d.block98_255 << "/255\n"
            << (d.alpha_compared ? "alpha compared as a fourth channel\n" : "") << (match ? "match" : "differs")
            << '\n';
}

void print_json(const Difference& d, bool match) {
  nlohmann::json result = {{"maximum", d.maximum},
                           {"mean", d.mean},
                           {"rmse", d.rmse},
                           {"within", d.within},
                           {"pixels", d.pixels},
                           {"tolerance_255", d.tolerance_255},
                           {"block98_255", d.block98_255},
                           {"alpha_compared", d.alpha_compared},
                           {"match", match}};
  // JSON has no infinity: equal pictures have no PSNR.
  result["psnr"] = std::isfinite(d.psnr) ? nlohmann::json(d.psnr) : nlohmann::json(nullptr);
  std::cout << result.dump(2) << '\n';
}

int run_diff(const DiffOptions& options) {
  const Picture first = read_picture(options.first);
  const Picture second = read_picture(options.second);
  const Difference d = difference(first, second, options.tolerance);
  const bool match = d.within >= options.least_within / 100 && d.rmse <= options.largest_rmse;
  if (!options.heat_map.empty()) write_picture(heat_map(first, second), options.heat_map);
  if (options.json) {
    print_json(d, match);
  } else {
    print_text(d, match);
  }
  return match ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_diff_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand("diff", "How far two pictures are apart");
  command->add_option("first", options->first, "A picture (PNG, EXR, … 8 or 16 bit or float)")->required();
  command->add_option("second", options->second, "A picture of the same size")->required();
  command->add_option("--threshold", options->tolerance,
                      "A pixel is within when no channel differs by more than N/255");
  command->add_option("--within", options->least_within, "Least percentage of pixels within, for a match");
  command->add_option("--rmse", options->largest_rmse, "Largest RMSE (0…1), for a match");
  command->add_option("--heatmap", options->heat_map, "Write a picture of the differences here");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &exit_code] { exit_code = run_diff(*options); });
}

}  // namespace lute::compare
