#include "compare/parse_time.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "compare/scratch_folder.hpp"

namespace lute::compare {

namespace {

// Seconds; shorter runs would make ratios of noise.
constexpr double kShortest = 1e-3;

ProcessResult fastest(const std::vector<std::string>& arguments, const std::filesystem::path& scene,
                      const ParseTimeSettings& settings) {
  ProcessResult best;
  for (int i = 0; i < settings.runs; ++i) {
    const ScratchFolder folder(scene.parent_path());
    ProcessRequest request;
    request.arguments = arguments;
    request.working_directory = folder.path();
    request.time_limit = settings.time_limit;
    const ProcessResult result = run_process(request);
    if (i == 0 || (result.succeeded() && result.user < best.user)) best = result;
  }
  return best;
}

}  // namespace

double ParseTime::ratio() const { return std::max(lute.user, kShortest) / std::max(reference.user, kShortest); }

ParseTime measure_parse_time(const SceneFile& scene, const ParseTimeSettings& settings) {
  const std::filesystem::path path = std::filesystem::absolute(scene.path);
  const std::string file = path.filename().string();
  const std::string program = std::filesystem::exists(settings.lute_program)
                                  ? std::filesystem::absolute(settings.lute_program).string()
                                  : settings.lute_program;
  ParseTime time;
  time.name = scene.name;
  time.lute = fastest({program, "--check", "+I" + file, "+W1", "+H1"}, path, settings);
  time.reference = fastest({settings.reference_program, "+I" + file, "+W1", "+H1", "-A", "-F", "-D", "-GA", "+WT1"}, path, settings);
  return time;
}

double mean_ratio(const std::vector<ParseTime>& times) {
  double sum = 0;
  int count = 0;
  for (const ParseTime& time : times) {
    if (!time.comparable()) continue;
    sum += std::log(time.ratio());
    ++count;
  }
  return count == 0 ? 0 : std::exp(sum / count);
}

void write_table(std::ostream& out, const std::vector<ParseTime>& times) {
  out << "| scene | lute, s | POV-Ray, s | ratio | lute, MB | POV-Ray, MB |\n|---|---|---|---|---|---|\n";
  for (const ParseTime& time : times) {
    out << "| " << time.name << " | ";
    if (!time.comparable()) {
      out << (time.lute.succeeded() ? "read" : "failed") << " | " << (time.reference.succeeded() ? "read" : "failed") << " | | | |\n";
      continue;
    }
    out << std::fixed << std::setprecision(3) << time.lute.user << " | " << time.reference.user << " | " << time.ratio() << " | "
        << (time.lute.peak_memory >> 20) << " | " << (time.reference.peak_memory >> 20) << " |\n";
  }
}

}  // namespace lute::compare
