#include "compare/noise_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "compare/picture.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

constexpr int kMagnification = 1000;

// `value` is an expression of Noise(x, y, z).
std::string scene_text(int generator, const std::string& value) {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
         "#declare Noise = function { pattern { bozo noise_generator " + std::to_string(generator) + " } }\n"
         "camera { orthographic location -10*z look_at 0 right 100*x up 100*y }\n"
         "plane { z, 0 pigment { function { " + value + " } color_map { [0 rgb 0] [1 rgb 1] } rotate <31, 17, 7> translate <0.3, 0.2, 0.1> }\n"
         "  finish { ambient 0 emission 1 diffuse 0 } }\n";
}

Picture rendered(const std::string& program, const fs::path& scene, const RenderSettings& settings) {
  const fs::path picture = scene.string() + ".png";
  const RenderRun run = render(program, scene, picture, settings);
  if (run.outcome != RenderOutcome::kRendered) throw std::runtime_error("'" + program + "' does not render the noise: " + run.messages);
  return read_picture(picture);
}

// The same expression rendered by both.
struct Pair {
  Picture lute, reference;
};

}  // namespace

NoiseComparison compare_noise(int generator, int side, const std::string& lute_program, const std::string& reference_program,
                              double time_limit) {
  RenderSettings settings;
  settings.width = settings.height = side;
  settings.switches = {"-A", "+WT1", "File_Gamma=1"};
  settings.file_type = "N16";
  settings.time_limit = time_limit;
  const ScratchFolder folder;
  const auto both = [&](const std::string& name, const std::string& value) {
    const fs::path scene = folder.path() / name;
    std::ofstream(scene) << scene_text(generator, value);
    return Pair{rendered(lute_program, scene, settings), rendered(reference_program, scene, settings)};
  };
  const Pair coarse = both("coarse.pov", "Noise(x, y, z)");
  const Pair fine = both("fine.pov", "mod(" + std::to_string(kMagnification) + "*Noise(x, y, z), 1)");

  NoiseComparison result;
  result.generator = generator;
  double sum = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto apart = [&](const Pair& p) { return std::fabs(static_cast<double>(p.lute.at(x, y)[0]) - static_cast<double>(p.reference.at(x, y)[0])); };
      // The fine value begins anew every 1/1000: near is near across that step, too.
      const double around = apart(fine);
      const double wrapped = std::min(around, 1 - around) / kMagnification;
      const double d = apart(coarse) < 0.25 / kMagnification ? wrapped : apart(coarse);
      result.largest = std::max(result.largest, d);
      sum += d;
      ++result.points;
    }
  }
  result.mean = sum / static_cast<double>(result.points);
  return result;
}

}  // namespace lute::compare
