#include "app/session.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>

#include "app/interrupt.hpp"
#include "engine/plan/output_plan.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/plan/sampling_plan.hpp"
#include "parser/dump/dump.hpp"
#include "parser/options/option_table.hpp"

namespace lute {
namespace {

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!text.empty() && text.back() != '\n') std::fputc('\n', stdout);
  std::fflush(stdout);
}

std::string content_of(std::istream& stream) { return std::string(std::istreambuf_iterator<char>(stream), {}); }

std::optional<std::string> standard_input(const RenderOptions& options) {
  if (options.input_file != "-") return std::nullopt;
  return content_of(std::cin);
}

ExitCode dump_scene_tokens(const RenderOptions& options, const std::optional<std::string>& text) {
  if (text) {
    print(dump_tokens("-", *text));
    return ExitCode::kDone;
  }
  std::ifstream file(options.input_file, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open input file '" + options.input_file + "'");
  print(dump_tokens(options.input_file, content_of(file)));
  return ExitCode::kDone;
}

// The actions that only read the scene.
ExitCode inspect(const RenderOptions& options, const std::optional<std::string>& text, Console& console) {
  const std::vector<Frame> frames = frames_of(options);
  const Frame frame = frames.empty() ? Frame{} : frames.front();
  const ParseResult parsed = parse_frame(options, frame, text, console);
  if (parsed.ok && options.action == Action::kExplain) {
    RenderPlan plan = make_plan(parsed.scene, build_options(options));
    plan_sampling(parsed.scene, options.antialiasing, options.statistics, plan);
    plan_output(options.output, options.output_to_file, options.width, options.height, plan);
    print(plan.text(parsed.scene));
  }
  if (parsed.ok && options.action == Action::kDumpScene) print(dump_scene(parsed.scene).dump(2));
  return parsed.ok ? ExitCode::kDone : ExitCode::kFailed;
}

ExitCode render_all(const RenderOptions& options, const std::optional<std::string>& text, Console& console) {
  const std::vector<Frame> frames = frames_of(options);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames.size() > 1) console.line("frame " + std::to_string(i + 1) + " of " + std::to_string(frames.size()));
    const ExitCode code = render_frame(options, frames[i], text, console);
    if (code != ExitCode::kDone) return code;
  }
  return ExitCode::kDone;
}

ExitCode run_action(const RenderOptions& options, Console& console) {
  if (options.input_file.empty())
    throw OptionError("no scene is given", "lute scene.pov; lute --help lists all options");
  for (const std::string& notice : options.notices) console.line("note: " + notice);
  const std::optional<std::string> text = standard_input(options);
  switch (options.action) {
    case Action::kDumpTokens: return dump_scene_tokens(options, text);
    case Action::kRender: return render_all(options, text, console);
    default: return inspect(options, text, console);
  }
}

ExitCode run_reported(const RenderOptions& options, Console& console) {
  try {
    return run_action(options, console);
  } catch (const OptionError& error) {
    return report(error, console);
  } catch (const std::bad_alloc&) {
    console.failure("out-of-memory", "out of memory");
  } catch (const std::exception& error) {
    console.failure("failure", error.what());
  }
  return ExitCode::kFailed;
}

}  // namespace

ExitCode report(const OptionError& error, Console& console) {
  console.failure("usage", error.what(), error.hint());
  return ExitCode::kUsage;
}

ExitCode run_session(const RenderOptions& options) {
  if (options.action == Action::kHelp) {
    print(option_help());
    return ExitCode::kDone;
  }
  if (options.action == Action::kVersion) {
    print("lute " LUTE_VERSION);
    return ExitCode::kDone;
  }
  Console console(options);
  const ExitCode code = run_reported(options, console);
  console.finish(options.action == Action::kRender && options.output_file == "-");
  if (code == ExitCode::kInterrupted) console.line("interrupted");
  return code;
}

}  // namespace lute
