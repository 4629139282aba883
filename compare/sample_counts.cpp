#include "compare/sample_counts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "compare/difference.hpp"
#include "compare/figures.hpp"
#include "compare/match.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {

namespace {

struct Rendered {
  Picture picture;
  double samples = 0;  // a pixel
};

Rendered rendered(const std::string& program, const SceneFile& scene, const RenderSettings& settings) {
  const ScratchFolder folder;
  const RenderRun run = render(program, scene.path, folder.path() / "picture.png", settings);
  const std::string what = program + ", " + scene.name + ": ";
  if (run.outcome != RenderOutcome::kRendered) throw std::runtime_error(what + name_of(run.outcome));
  const std::optional<double> samples = samples_in(run.messages);
  if (!samples) throw std::runtime_error(what + "no statistics");
  return {read_picture(run.picture), *samples / (settings.width * settings.height)};
}

}  // namespace

bool SampleCount::passes() const { return matches && std::abs(difference()) <= kAllowedSampleDifference; }

std::optional<double> samples_in(const std::string& messages) {
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);) {
    double pixels = 0, samples = 0;
    // "Pixels: 20440   Samples: 13338   Smpls/Pxl: 0.65": those of the base grid, and those of antialiasing.
    if (std::sscanf(line.c_str(), "Pixels: %lf Samples: %lf", &pixels, &samples) == 2) return pixels + samples;
    if (std::sscanf(line.c_str(), " camera %lf", &samples) == 1) return samples;
  }
  return std::nullopt;
}

SampleCount count_samples(const SceneFile& scene, const std::string& switches, const RenderSettings& settings,
                          const std::string& lute_program, const std::string& reference_program) {
  RenderSettings both = settings;
  both.switches = {"+WT1"};
  for (std::string& word : words_of(switches)) both.switches.push_back(std::move(word));
  const Rendered theirs = rendered(reference_program, scene, both);
  both.switches.push_back("--stats");
  const Rendered ours = rendered(lute_program, scene, both);
  const Difference d = difference(ours.picture, theirs.picture);
  return {scene.name, switches, theirs.samples, ours.samples, d.within, compare::matches(d, std::nullopt)};
}

void write_markdown(std::ostream& out, const std::vector<SampleCount>& counts, const std::string& circumstances) {
  const auto passed = std::count_if(counts.begin(), counts.end(), [](const SampleCount& c) { return c.passes(); });
  out << circumstances << "\n\n" << passed << " of " << counts.size()
      << " pictures match with a mean number of samples a pixel within 2 % of POV-Ray's.\n\n"
      << "| scene | switches | POV-Ray, samples a pixel | lute | difference | pixels within 2/255 |\n"
      << "|---|---|---:|---:|---:|---:|\n";
  for (const SampleCount& c : counts) {
    char figures[120];
    std::snprintf(figures, sizeof figures, " | %.4f | %.4f | %+.2f %% | %.2f %% |\n", c.reference, c.own,
                  100 * c.difference(), 100 * c.within);
    out << "| " << c.scene << " | `" << c.switches << '`' << figures;
  }
}

}  // namespace lute::compare
