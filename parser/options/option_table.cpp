#include "parser/options/option_table.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "parser/options/option_value.hpp"

namespace lute {
namespace {

using O = RenderOptions;
using V = OptionValue;
using Kind = ValueKind;
using Tail = SwitchTail;

// Accepted and without effect, as in POV-Ray itself or because it concerns a preview window, which lute does not have.
void no_effect(O&, const V&) {}

// Of limits: at least 1, at most what a MB count leaves room for.
std::uint64_t count(const V& v) { return static_cast<std::uint64_t>(std::clamp(v.number, 1.0, 1e13)); }

void set_all_consoles(O& o, const V& v) {
  o.debug_console = o.warning_console = o.render_console = o.statistic_console = o.fatal_console = v.on;
}

template <Action action>
void set_action(O& o, const V&) {
  o.action = action;
}

void set_antialias(O& o, const V& v) {
  o.antialias = v.on;
  if (v.has_tail) o.antialiasing.threshold = static_cast<float>(std::clamp(v.number, 0.0, 1.0));
}

// POV-Ray takes every number above 2 for 2; 3 is lute's own.
void set_sampling_method(O& o, const V& v) {
  o.antialiasing.method = v.integer == 3 ? 3 : std::clamp(v.integer, 0, 2);
  if (v.integer == 3) o.antialias = true;
}

void set_error_bound(O& o, const V& v) {
  if (!(v.number > 0 && v.number <= 1)) throw OptionError("the error bound of antialiasing must be above 0 and at most 1");
  o.antialiasing.error_bound = v.number;
}

void set_jitter(O& o, const V& v) {
  if (v.has_tail) o.antialiasing.jitter = static_cast<float>(std::clamp(v.number, 0.0, 1.0));
  if (!v.on) o.antialiasing.jitter = 0;
  if (v.on && !v.has_tail && o.antialiasing.jitter == 0) o.antialiasing.jitter = 1;
}

void set_output(O& o, const V& v) {
  o.output_to_file = v.on;
  if (!v.text.empty()) set_file_type(o.output, v.text);
}

void set_dither(O& o, const V& v) {
  if (!v.text.empty()) {
    o.output.dither = dither_method(v.text);
  } else if (o.output.dither == DitherMethod::kNone) {
    o.output.dither = DitherMethod::kFloydSteinberg;
  }
  if (!v.on) o.output.dither = DitherMethod::kNone;
}

void set_block_size(O& o, const V& v) {
  if (v.integer < 4) throw OptionError("the render block size must be at least 4");
  o.block_size = v.integer;
}

void set_diagnostics(O& o, const V& v) {
  if (v.text != "json" && v.text != "text")
    throw OptionError("'" + v.text + "' is no form of diagnostics: 'text' or 'json'");
  o.json_diagnostics = v.text == "json";
}

void add_library_path(O& o, const V& v) {
  if (std::find(o.library_paths.begin(), o.library_paths.end(), v.text) == o.library_paths.end())
    o.library_paths.push_back(v.text);
}

// clang-format off
const OptionRow kOptions[] = {
    // What to do.
    {"", "", "help",        Kind::kNone, Tail::kNothing, set_action<Action::kHelp>,       "print this text"},
    {"", "", "version",     Kind::kNone, Tail::kNothing, set_action<Action::kVersion>,    "print the version"},
    {"", "", "check",       Kind::kNone, Tail::kNothing, set_action<Action::kCheck>,      "read the scene only; report every mistake"},
    {"", "", "explain",     Kind::kNone, Tail::kNothing, set_action<Action::kExplain>,    "say what the scene needs, and why"},
    {"", "", "dump-tokens", Kind::kNone, Tail::kNothing, set_action<Action::kDumpTokens>, "print the scene's tokens"},
    {"", "", "dump-scene",  Kind::kNone, Tail::kNothing, set_action<Action::kDumpScene>,  "print the scene as JSON, as it was read"},
    {"", "", "stats",       Kind::kNone, Tail::kNothing, [](O& o, const V&) { o.statistics = true; }, "print rays by kind and time by stage"},
    {"", "", "diagnostics", Kind::kText, Tail::kNothing, set_diagnostics, "text, or json for programs"},
    {"", "", "max-errors",  Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.limits.errors = static_cast<std::size_t>(std::max(v.integer, 1)); }, "stop reading a scene at this many errors (20)"},

    // What a scene may do.
    {"", "", "allow-read",  Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.allow_read.push_back(v.text); }, "a folder that the scene may read from, with all below it; may be given often"},
    {"", "", "allow-write", Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.allow_write.push_back(v.text); }, "a folder that the scene may write to"},
    {"", "", "max-loop-turns", Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.limits.loop_turns = count(v); }, "of all loops together (1e9)"},
    {"", "", "max-tokens",  Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.limits.tokens = count(v); }, "read from the scene, loops and macros included (4e9)"},
    {"", "", "max-memory",  Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.limits.memory_bytes = count(v) << 20; }, "in MB, while the scene is read (3/4 of what the machine, its control groups and ulimit give)"},
    {"", "", "max-file-size", Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.limits.file_bytes = std::min(count(v) << 20, o.limits.file_bytes); }, "of each file that is read, in MB (4096)"},
    {"", "", "max-nesting", Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.limits.nesting = static_cast<std::size_t>(std::clamp(v.integer, 1, 2000)); }, "parentheses and calls in each other, up to 2000 (200)"},
    {"", "", "max-depth",   Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.limits.depth = static_cast<std::size_t>(std::clamp(v.integer, 1, 2000)); }, "declared objects, textures and functions in each other, up to 2000 (1000)"},
    {"", "", "max-blocks",  Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.limits.blocks = static_cast<std::size_t>(std::clamp(v.integer, 1, 1000)); }, "braces in each other, up to 1000 (1000)"},

    // The scene.
    {"Input_File_Name", "I", "input", Kind::kText, Tail::kText, [](O& o, const V& v) { o.input_file = v.text; }, "the scene; - for standard input"},
    {"Include_Header", "HI", "", Kind::kText, Tail::kText, [](O& o, const V& v) { o.include_header = v.text; }, "a file included before the scene"},
    {"Include_Ini", "", "", Kind::kText, Tail::kNothing, no_effect, "read options from an INI file"},  // see option_reader.cpp
    {"Library_Path", "L", "", Kind::kText, Tail::kText, add_library_path, "a folder searched for files; may be given often"},
    {"Declare", "", "", Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.declares.push_back(declaration(v.text)); }, "NAME=VALUE, an identifier for the scene"},
    {"Version", "MV", "language-version", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.version = static_cast<int>(v.number * 100 + 0.5); }, "language version of a scene that states none"},

    // The picture.
    {"Width", "W", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.width = v.integer; }, "in pixels"},
    {"Height", "H", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.height = v.integer; }, "in pixels"},
    {"Start_Column", "SC", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.partial.start_column = v.number; }, "first column, from 1, or a fraction"},
    {"Start_Row", "SR", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.partial.start_row = v.number; }, "first row"},
    {"End_Column", "EC", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.partial.end_column = v.number; }, "last column"},
    {"End_Row", "ER", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.partial.end_row = v.number; }, "last row"},
    {"Antialias", "A", "", Kind::kBoolean, Tail::kOptionalFraction, set_antialias, "antialiasing, with its threshold: +A0.3"},
    {"Antialias_Threshold", "", "", Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.antialiasing.threshold = static_cast<float>(std::clamp(v.number, 0.0, 1.0)); }, "difference from which pixels get more samples"},
    {"Antialias_Depth", "R", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.antialiasing.depth = std::clamp(v.integer, 1, 9); }, "1...9: method 1 takes its square of samples"},
    {"Antialias_Gamma", "AG", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.antialiasing.gamma = v.number; }, "encoding in which colours are compared"},
    {"Sampling_Method", "AM", "", Kind::kInteger, Tail::kInteger, set_sampling_method, "1: supersampling, 2: recursive, 3: driven by the estimated error"},
    {"Antialias_Error", "AE", "", Kind::kFloat, Tail::kFloat, set_error_bound, "bound of method 3 on the error of each pixel, 0...1: default 0.01"},
    {"Jitter", "J", "", Kind::kBoolean, Tail::kOptionalFloat, set_jitter, "move antialiasing samples, with the amount: +J0.5"},
    {"Jitter_Amount", "", "", Kind::kFloat, Tail::kNothing, [](O& o, const V& v) { o.antialiasing.jitter = static_cast<float>(std::clamp(v.number, 0.0, 1.0)); }, "0...1"},
    {"Quality", "Q", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.quality = std::clamp(v.integer, 0, 9); }, "0...9, see the manual"},
    {"Work_Threads", "WT", "threads", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.threads = std::clamp(v.integer, 1, 512); }, "default: the number of processors"},
    {"Render_Block_Size", "BS", "", Kind::kInteger, Tail::kInteger, set_block_size, "side of a unit of work"},
    {"Bounding_Threshold", "MB", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.bounding_threshold = std::max(v.integer, 0); }, "part of the rules for bounding CSG"},
    {"Remove_Bounds", "UR", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.remove_bounds = v.on; }, "drop bounded_by where it does not help"},
    {"Split_Unions", "SU", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.split_unions = v.on; }, "take bounded unions apart"},

    // The file.
    {"Output_File_Name", "O", "output", Kind::kText, Tail::kText, [](O& o, const V& v) { o.output_file = v.text; }, "name or folder/; - for standard output"},
    {"Output_To_File", "F", "", Kind::kBoolean, Tail::kOptionalText, set_output, "write a file, with its type: +FN16"},
    {"Output_File_Type", "", "format", Kind::kText, Tail::kNothing, [](O& o, const V& v) { set_file_type(o.output, v.text); }, "N png, T tga, C tga packed, B bmp, P ppm, J jpg, E exr, H hdr; then bits"},
    {"Bits_Per_Color", "", "", Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.output.bits = v.integer; }, "5...16: PNG and PPM"},
    {"Bits_Per_Colour", "", "", Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.output.bits = v.integer; }, "the same"},
    {"Output_Alpha", "UA", "alpha", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.output.alpha = v.on; }, "keep transparency"},
    {"Grayscale_Output", "", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.output.greyscale = v.on; }, "PNG, PPM (as PGM), EXR"},
    {"File_Gamma", "", "", Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.output.file_gamma = gamma_curve(v.text); }, "sRGB or a number"},
    {"Display_Gamma", "", "", Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.output.display_gamma = gamma_curve(v.text); }, "of scenes without gamma handling"},
    {"Dither", "TH", "", Kind::kBoolean, Tail::kOptionalText, set_dither, "dithering, with its method: +THB4"},
    {"Dither_Method", "", "", Kind::kText, Tail::kNothing, [](O& o, const V& v) { o.output.dither = dither_method(v.text); }, "B2, B3, B4, D1, D2, FS"},
    {"Compression", "", "", Kind::kInteger, Tail::kNothing, [](O& o, const V& v) { o.output.compression = std::clamp(v.integer, 0, 255); }, "JPEG quality 2...100"},
    {"Continue_Trace", "C", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.continue_trace = v.on; }, "skip what was rendered before"},

    // Animation.
    {"Clock", "K", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.clock = v.number; o.clock_given = true; }, "value of `clock`"},
    {"Initial_Frame", "KFI", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.initial_frame = v.integer; }, "first frame"},
    {"Final_Frame", "KFF", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.final_frame = v.integer; }, "last frame"},
    {"Initial_Clock", "KI", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.initial_clock = v.number; }, "clock of the first frame"},
    {"Final_Clock", "KF", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.final_clock = v.number; }, "clock of the last frame"},
    {"Subset_Start_Frame", "SF", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.subset_start = v.number; }, "render from here; below 1 a fraction"},
    {"Subset_End_Frame", "EF", "", Kind::kFloat, Tail::kFloat, [](O& o, const V& v) { o.subset_end = v.number; }, "render up to here"},
    {"Frame_Step", "STP", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.frame_step = std::max(v.integer, 1); }, "render every n-th frame"},
    {"Cyclic_Animation", "KC", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.cyclic = v.on; }, "the last frame leads to the first"},
    {"Clockless_Animation", "KLA", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},
    {"Real_Time_Raytracing", "RTR", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},

    // What is said.
    {"Verbose", "V", "", Kind::kBoolean, Tail::kNothing, [](O& o, const V& v) { o.verbose = v.on; }, "progress and summary on standard error"},
    {"All_Console", "GA", "", Kind::kBoolean, Tail::kOptionalText, set_all_consoles, "all of the following"},
    {"Debug_Console", "GD", "", Kind::kBoolean, Tail::kOptionalText, [](O& o, const V& v) { o.debug_console = v.on; }, "text of #debug"},
    {"Warning_Console", "GW", "", Kind::kBoolean, Tail::kOptionalText, [](O& o, const V& v) { o.warning_console = v.on; }, "warnings"},
    {"Render_Console", "GR", "", Kind::kBoolean, Tail::kOptionalText, [](O& o, const V& v) { o.render_console = v.on; }, "what is rendered and how"},
    {"Statistic_Console", "GS", "", Kind::kBoolean, Tail::kOptionalText, [](O& o, const V& v) { o.statistic_console = v.on; }, "the summary"},
    {"Fatal_Console", "GF", "", Kind::kBoolean, Tail::kOptionalText, [](O& o, const V& v) { o.fatal_console = v.on; }, "the text of errors in scenes"},
    {"Warning_Level", "WL", "", Kind::kInteger, Tail::kInteger, [](O& o, const V& v) { o.warning_level = std::clamp(v.integer, 0, 9); }, "0: no warnings"},

    // Accepted without effect, as POV-Ray accepts them, or because lute has no preview and one acceleration structure.
    {"Append_File", "GP", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Bounding", "B", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Bounding_Method", "BM", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"BSP_MaxDepth", "", "", Kind::kInteger, Tail::kNothing, no_effect, ""},
    {"BSP_BaseAccessCost", "", "", Kind::kFloat, Tail::kNothing, no_effect, ""},
    {"BSP_ChildAccessCost", "", "", Kind::kFloat, Tail::kNothing, no_effect, ""},
    {"BSP_ISectCost", "", "", Kind::kFloat, Tail::kNothing, no_effect, ""},
    {"BSP_MissChance", "", "", Kind::kFloat, Tail::kNothing, no_effect, ""},
    {"Buffer_Output", "", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Buffer_Size", "", "", Kind::kInteger, Tail::kNothing, no_effect, ""},
    {"Display", "D", "", Kind::kBoolean, Tail::kOptionalText, no_effect, ""},
    {"Draw_Vistas", "UD", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Field_Render", "UF", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"High_Reproducibility", "HR", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Light_Buffer", "UL", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Max_Image_Buffer_Memory", "MI", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"Odd_Field", "UO", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Palette", "", "", Kind::kText, Tail::kNothing, no_effect, ""},
    {"Pause_When_Done", "P", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},
    {"Preview_Start_Size", "SP", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"Preview_End_Size", "EP", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"Render_Block_Step", "RS", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"Render_Pattern", "RP", "", Kind::kInteger, Tail::kInteger, no_effect, ""},
    {"Test_Abort", "X", "", Kind::kBoolean, Tail::kOptionalInteger, no_effect, ""},
    {"Test_Abort_Count", "", "", Kind::kInteger, Tail::kNothing, no_effect, ""},
    {"Video_Mode", "", "", Kind::kText, Tail::kNothing, no_effect, ""},
    {"Vista_Buffer", "UV", "", Kind::kBoolean, Tail::kNothing, no_effect, ""},

    // Accepted with a notice: POV-Ray does something that lute does not.
    {"Create_Ini", "GI", "", Kind::kText, Tail::kText, nullptr, ""},
    {"All_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Debug_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Fatal_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Render_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Statistic_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Warning_File", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Create_Histogram", "", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},
    {"Histogram_Grid_Size", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Histogram_Name", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Histogram_Type", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Radiosity_File_Name", "RF", "", Kind::kText, Tail::kText, nullptr, ""},
    {"Radiosity_From_File", "RFI", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},
    {"Radiosity_To_File", "RFO", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},
    {"Radiosity_Vain_Pretrace", "RVP", "", Kind::kBoolean, Tail::kNothing, nullptr, ""},
    {"Pre_Scene_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"Pre_Scene_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Pre_Frame_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"Pre_Frame_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Post_Frame_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"Post_Frame_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Post_Scene_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"Post_Scene_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"User_Abort_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"User_Abort_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
    {"Fatal_Error_Command", "", "", Kind::kCommand, Tail::kNothing, nullptr, ""},
    {"Fatal_Error_Return", "", "", Kind::kText, Tail::kNothing, nullptr, ""},
};
// clang-format on

std::string placeholder(const OptionRow& row) {
  switch (row.kind) {
    case Kind::kNone:
      return "";
    case Kind::kBoolean:
      return row.tail == Tail::kOptionalFraction || row.tail == Tail::kOptionalFloat ? "[=N]" : "";
    case Kind::kInteger:
      return " N";
    case Kind::kFloat:
      return " X";
    default:
      return " TEXT";
  }
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

}  // namespace

std::span<const OptionRow> option_table() { return kOptions; }

std::string long_name_of(const OptionRow& row) {
  if (!row.long_name.empty()) return std::string(row.long_name);
  return hyphenated(row.keyword);
}

std::string option_help() {
  std::string text =
      "usage: lute [options] scene.pov\n\n"
      "Renders POV-Ray scene files. Options are POV-Ray's, in any of its forms, or GNU style:\n"
      "  +W800  or  Width=800  or  --width 800\n"
      "Switches are on with + and off with -; long booleans are off with --no-. Other arguments are INI files.\n\n";
  std::string ignored;
  for (const OptionRow& row : kOptions) {
    if (row.help.empty()) {
      ignored += (ignored.empty() ? "" : ", ") + std::string(row.keyword);
      continue;
    }
    const std::string switch_text = row.switch_name.empty() ? "" : "+" + std::string(row.switch_name);
    text += "  " + padded("--" + long_name_of(row) + placeholder(row), 30) + " " + padded(switch_text, 5) + " " +
            padded(std::string(row.keyword), 20) + " " + std::string(row.help) + "\n";
  }
  return text + "\nAccepted without effect: " + ignored +
         ".\n\nExit codes: 0 done, 1 mistake in the scene or while rendering, 2 mistake in the options, 130 "
         "interrupted.\n";
}

}  // namespace lute
