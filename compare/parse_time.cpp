#include "compare/parse_time.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <regex>

#include "compare/scratch_folder.hpp"

namespace lute::compare {

namespace {

// Seconds; shorter runs would make ratios of noise.
constexpr double kShortest = 1e-3;

struct Reading {
  ProcessResult result;
  std::string said;
};

Reading read_once(const std::vector<std::string>& arguments, const std::filesystem::path& scene, double time_limit) {
  const ScratchFolder folder(scene.parent_path()), output;
  ProcessRequest request;
  request.arguments = arguments;
  request.working_directory = folder.path();
  request.standard_error = output.path() / "said";
  request.time_limit = time_limit;
  Reading reading{run_process(request), ""};
  std::ifstream in(request.standard_error, std::ios::binary);
  reading.said.assign(std::istreambuf_iterator<char>(in), {});
  return reading;
}

void keep_faster(Reading& best, Reading reading) {
  if (!best.result.started || (reading.result.succeeded() && reading.result.cpu < best.result.cpu)) best = std::move(reading);
}

double ratio_of(double lute, double reference) { return std::max(lute, kShortest) / std::max(reference, kShortest); }

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

double ParseTime::ratio() const { return ratio_of(lute.cpu, reference.cpu); }
double ParseTime::user_ratio() const { return ratio_of(lute.user, reference.user); }

ParseTime measure_parse_time(const SceneFile& scene, const ParseTimeSettings& settings) {
  const std::filesystem::path path = std::filesystem::absolute(scene.path);
  const std::string file = path.filename().string();
  const std::string program = std::filesystem::exists(settings.lute_program)
                                  ? std::filesystem::absolute(settings.lute_program).string()
                                  : settings.lute_program;
  const std::vector<std::string> lute = {program, "--check", "+I" + file, "+W1", "+H1"};
  const std::vector<std::string> reference = {settings.reference_program, "+I" + file, "+W1", "+H1", "-A", "-F", "-D", "-GD", "-GR",
                                              "-GS", "+WT1"};
  Reading ours, theirs;
  for (int i = 0; i < settings.runs; ++i) {
    keep_faster(ours, read_once(lute, path, settings.time_limit));
    keep_faster(theirs, read_once(reference, path, settings.time_limit));
  }
  return {scene.name, ours.result, theirs.result, lute_error_place(ours.said), reference_error_place(theirs.said)};
}

std::string lute_error_place(const std::string& said) {
  static const std::regex pattern(R"((?:^|\n)([^\n]*?):(\d+):\d+: error: )");
  std::smatch found;
  if (!std::regex_search(said, found, pattern)) return "";
  return file_name(found[1]) + ":" + found[2].str();
}

std::string reference_error_place(std::string said) {
  std::erase(said, '\n');
  // A file that cannot be opened is fatal without a place, behind a possible error that has it.
  const std::size_t fatal = said.find("Fatal error in parser");
  if (fatal == std::string::npos) return "";
  said.resize(fatal);
  static const std::regex pattern(R"(File '([^']*)' line (\d+): (?:Possible )?Parse Error: )");
  std::string place;
  for (std::sregex_iterator i(said.begin(), said.end(), pattern), end; i != end; ++i) place = file_name((*i)[1]) + ":" + (*i)[2].str();
  return place;
}

double mean_ratio(const std::vector<ParseTime>& times, double (ParseTime::*ratio)() const) {
  double sum = 0;
  int count = 0;
  for (const ParseTime& time : times) {
    if (!time.comparable()) continue;
    sum += std::log((time.*ratio)());
    ++count;
  }
  return count == 0 ? 0 : std::exp(sum / count);
}

void write_times(std::ostream& out, std::vector<ParseTime> times, bool memory) {
  std::erase_if(times, [](const ParseTime& time) { return !time.comparable(); });
  std::ranges::stable_sort(times, std::greater{}, &ParseTime::ratio);
  out << "| scene | lute, s | POV-Ray, s | ratio |" << (memory ? " lute, MB | POV-Ray, MB |" : "") << "\n|---|---:|---:|---:|"
      << (memory ? "---:|---:|" : "") << "\n";
  for (const ParseTime& time : times) {
    out << "| " << time.name << " | " << std::fixed << std::setprecision(3) << time.lute.cpu << " | " << time.reference.cpu << " | "
        << time.ratio() << " |";
    if (memory) out << ' ' << (time.lute.peak_memory >> 20) << " | " << (time.reference.peak_memory >> 20) << " |";
    out << "\n";
  }
}

void write_rejections(std::ostream& out, const std::vector<ParseTime>& times) {
  out << "| scene | POV-Ray's error | lute's error |\n|---|---|---|\n";
  for (const ParseTime& time : times) {
    if (!time.rejected() && time.lute_error.empty()) continue;
    out << "| " << time.name << " | " << (time.rejected() ? time.reference_error : "none") << " | "
        << (time.lute_error.empty() ? "none" : time.lute_error == time.reference_error ? "the same place" : time.lute_error) << " |\n";
  }
}

}  // namespace lute::compare
