#include "parser/options/option_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "parser/diagnostic/diagnostic.hpp"
#include "parser/options/ini.hpp"
#include "parser/options/option_table.hpp"
#include "parser/options/option_value.hpp"

namespace lute {
namespace {

constexpr int kMaxIniDepth = 20;
constexpr std::string_view kBuiltInLibrary = "/usr/share/povray-3.7/include";

bool ends_with(std::string_view text, std::string_view end) { return lower_case(text).ends_with(end); }

bool has_extension(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return path.find('.', slash == std::string_view::npos ? 0 : slash) != std::string_view::npos;
}

// True if what stands behind the switch's name is what the row wants there.
bool tail_fits(const OptionRow& row, std::string_view tail) {
  switch (row.tail) {
    case SwitchTail::kNothing:
      return tail.empty();
    case SwitchTail::kInteger:
      return is_integer(tail);
    case SwitchTail::kFloat:
      return is_number(tail);
    case SwitchTail::kText:
      return !tail.empty();
    case SwitchTail::kOptionalInteger:
      return tail.empty() || is_integer(tail);
    case SwitchTail::kOptionalFloat:
      return tail.empty() || is_number(tail);
    case SwitchTail::kOptionalFraction:
      return tail.empty() || (tail.size() > 2 && tail.starts_with("0.") && is_number(tail));
    case SwitchTail::kOptionalText:
      return true;
  }
  return false;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates, std::string_view prefix) {
  const std::vector<std::string_view> views(candidates.begin(), candidates.end());
  const std::string_view nearest = nearest_name(name, views);
  return nearest.empty() ? std::string("lute --help lists all options")
                         : "did you mean '" + std::string(prefix) + std::string(nearest) + "'?";
}

std::string unquoted(std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

class Reader {
 public:
  explicit Reader(const OptionEnvironment& environment) : environment_(environment) {}

  void read_system_ini() {
    std::vector<std::string> candidates;
    if (const auto named = environment_.variable("POVINI")) candidates.push_back(*named);
    candidates.push_back("povray.ini");
    const auto home = environment_.variable("HOME");
    if (home) candidates.push_back(*home + "/.povray/3.7/povray.ini");
    candidates.push_back("/etc/povray/3.7/povray.ini");
    if (home) candidates.push_back(*home + "/.povrayrc");
    candidates.push_back("/etc/povray.ini");
    for (const std::string& path : candidates) {
      if (const auto text = environment_.read_file(path)) {
        read_ini_text(*text, path, "");
        break;
      }
    }
    if (const auto path = environment_.variable("POVINC")) assign("Library_Path", *path);
  }

  void read_arguments(std::span<const std::string> arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (arguments[i].starts_with("--")) {
        i += read_long(arguments[i], i + 1 < arguments.size() ? &arguments[i + 1] : nullptr);
      } else {
        read_word(arguments[i]);
      }
    }
  }

  RenderOptions take() {
    assign("Library_Path", std::string(kBuiltInLibrary));
    if (!options_.antialias) options_.antialiasing.method = 0;
    return std::move(options_);
  }

 private:
  // A switch, an assignment or a file name.
  void read_word(const std::string& word) {
    if (word == "-") {
      options_.input_file = "-";
    } else if (word.starts_with('+') || word.starts_with('-')) {
      read_switch(word);
    } else if (const std::size_t equals = word.find('='); equals != std::string::npos && equals > 0) {
      assign(word.substr(0, equals), unquoted(std::string_view(word).substr(equals + 1)));
    } else {
      read_file_name(word);
    }
  }

  void read_file_name(const std::string& name) {
    if (ends_with(name, ".pov")) {
      options_.input_file = name;
    } else if (name.ends_with('/')) {
      assign("Library_Path", name);
    } else {
      include_ini(name);
    }
  }

  void read_switch(const std::string& word) {
    const std::string lower = lower_case(word);
    const std::string_view body = std::string_view(lower).substr(1);
    const OptionRow* best = nullptr;
    for (const OptionRow& row : option_table()) {
      if (row.switch_name.empty() || (best != nullptr && row.switch_name.size() <= best->switch_name.size())) continue;
      if (body.size() >= row.switch_name.size() && equal_ignoring_case(body.substr(0, row.switch_name.size()), row.switch_name) &&
          tail_fits(row, unquoted(body.substr(row.switch_name.size()))))
        best = &row;
    }
    if (best == nullptr) unknown_switch(word);
    OptionValue value;
    value.on = word.front() == '+';
    value.text = unquoted(std::string_view(word).substr(1 + best->switch_name.size()));
    value.has_tail = !value.text.empty();
    fill_numbers(*best, value);
    if (best->kind == ValueKind::kBoolean && best->tail == SwitchTail::kOptionalText) note_text_file(*best, value);
    apply(*best, value);
  }

  // +GAfile asks for a file with the console's text.
  void note_text_file(const OptionRow& row, const OptionValue& value) {
    if (value.text.empty() || !row.keyword.ends_with("_Console")) return;
    notice("the text file '" + value.text + "' is not written: lute has no text files");
  }

  [[noreturn]] void unknown_switch(const std::string& word) const {
    const std::string body = word.substr(1);
    std::vector<std::string> long_names;
    const OptionRow* longest = nullptr;  // +AEnan is a mistake about +AE, not about +A
    for (const OptionRow& row : option_table()) {
      long_names.push_back(long_name_of(row));
      if (row.switch_name.empty() || !lower_case(body).starts_with(lower_case(row.switch_name))) continue;
      if (row.switch_name.size() < 2 && row.tail == SwitchTail::kNothing) continue;
      if (longest == nullptr || row.switch_name.size() > longest->switch_name.size()) longest = &row;
    }
    if (longest != nullptr) {
      throw OptionError("the switch '" + word + "' is not understood",
                        "'+" + std::string(longest->switch_name) + "' takes " + tail_text(longest->tail));
    }
    throw OptionError("unknown switch '" + word + "'", suggestion(lower_case(body), long_names, "--"));
  }

  static std::string tail_text(SwitchTail tail) {
    switch (tail) {
      case SwitchTail::kNothing:
        return "nothing behind it";
      case SwitchTail::kInteger:
        return "a whole number behind it";
      case SwitchTail::kFloat:
        return "a number behind it";
      case SwitchTail::kOptionalFraction:
        return "nothing or a number like 0.3 behind it";
      case SwitchTail::kOptionalInteger:
      case SwitchTail::kOptionalFloat:
        return "nothing or a number behind it";
      case SwitchTail::kText:
      case SwitchTail::kOptionalText:
        break;
    }
    return "a text behind it";
  }

  // --name, --name=value, --name value, --no-name. Returns how many further arguments were taken.
  std::size_t read_long(const std::string& argument, const std::string* next) {
    const std::size_t equals = argument.find('=');
    const std::string name = lower_case(argument.substr(2, equals == std::string::npos ? equals : equals - 2));
    std::optional<std::string> given;
    if (equals != std::string::npos) given = argument.substr(equals + 1);
    bool on = true;
    const OptionRow* row = find_long(name);
    if (row == nullptr && name.starts_with("no-")) {
      row = find_long(name.substr(3));
      on = false;
      if (row != nullptr && row->kind != ValueKind::kBoolean) row = nullptr;
    }
    if (row == nullptr) unknown_long(name);
    OptionValue value;
    value.on = on;
    std::size_t taken = 0;
    if (row->kind == ValueKind::kNone) {
      if (given) throw OptionError("'--" + name + "' takes no value");
    } else if (row->kind == ValueKind::kBoolean) {
      if (!given && on && next != nullptr && takes_number(*row) && is_number(*next)) {
        given = *next;
        taken = 1;
      }
      if (given) set_boolean(*row, *given, value);
    } else {
      if (!given && next == nullptr) throw OptionError("'--" + name + "' needs a value");
      if (!given) {
        given = *next;
        taken = 1;
      }
      value.text = *given;
      fill_numbers(*row, value);
    }
    apply(*row, value);
    return taken;
  }

  static bool takes_number(const OptionRow& row) {
    return row.tail == SwitchTail::kOptionalFloat || row.tail == SwitchTail::kOptionalFraction;
  }

  // `--antialias=off`, `--antialias=0.3`, `--dither=B4`.
  static void set_boolean(const OptionRow& row, const std::string& given, OptionValue& value) {
    if (takes_number(row) && given.find('.') != std::string::npos && is_number(given)) {
      value.number = leading_number(given).value_or(0);
      value.has_tail = true;
      return;
    }
    value.on = truth_of(given);
  }

  static const OptionRow* find_long(std::string_view name) {
    for (const OptionRow& row : option_table()) {
      if (long_name_of(row) == name ||
          (!row.keyword.empty() && hyphenated(row.keyword) == name && row.keyword != "Version"))
        return &row;
    }
    return nullptr;
  }

  [[noreturn]] static void unknown_long(const std::string& name) {
    std::vector<std::string> names;
    for (const OptionRow& row : option_table()) names.push_back(long_name_of(row));
    throw OptionError("unknown option '--" + name + "'", suggestion(name, names, "--"));
  }

  [[noreturn]] static void unknown_keyword(const std::string& keyword) {
    std::vector<std::string> keywords;
    for (const OptionRow& row : option_table()) {
      if (!row.keyword.empty()) keywords.emplace_back(row.keyword);
    }
    throw OptionError("unknown option '" + keyword + "'", suggestion(keyword, keywords, ""));
  }

  static const OptionRow* find_keyword(const std::string& keyword) {
    for (const OptionRow& row : option_table()) {
      if (!row.keyword.empty() && equal_ignoring_case(row.keyword, keyword)) return &row;
    }
    return nullptr;
  }

  void assign(const std::string& keyword, const std::string& text) {
    const OptionRow* const row = find_keyword(keyword);
    if (row == nullptr) unknown_keyword(keyword);
    if (row->keyword == "Include_Ini") {
      include_ini(text);
      return;
    }
    OptionValue value;
    if (row->kind == ValueKind::kBoolean) {
      value.on = truth_of(text);
    } else {
      value.text = text;
      fill_numbers(*row, value);
    }
    apply(*row, value);
  }

  static void fill_numbers(const OptionRow& row, OptionValue& value) {
    const bool of_switch = row.kind == ValueKind::kBoolean;
    if (of_switch ? value.has_tail && takes_number(row) : row.kind == ValueKind::kFloat) {
      const auto number = leading_number(value.text);
      if (!number) throw OptionError("'" + std::string(row.keyword) + "' needs a number, not '" + value.text + "'");
      value.number = *number;
    } else if (row.kind == ValueKind::kInteger) {
      const auto integer = leading_integer(value.text);
      if (!integer)
        throw OptionError("'" + std::string(row.keyword) + "' needs a whole number, not '" + value.text + "'");
      value.integer = *integer;
      value.number = *integer;
    }
  }

  void apply(const OptionRow& row, const OptionValue& value) {
    if (row.apply != nullptr) {
      row.apply(options_, value);
    } else if (row.kind != ValueKind::kBoolean || value.on) {
      notice("the option '" + std::string(row.keyword) + "' has no effect in lute");
    }
  }

  void notice(std::string text) { options_.notices.push_back(std::move(text)); }

  // "file.ini" or "file.ini[section]"; without an extension also with .ini. The current folder, then the library paths.
  void include_ini(const std::string& given) {
    std::string name = given, section;
    if (const std::size_t open = given.find('['); open != std::string::npos && given.ends_with(']')) {
      name = given.substr(0, open);
      section = given.substr(open + 1, given.size() - open - 2);
    }
    std::vector<std::string> folders{""};
    if (!name.starts_with('/')) {
      for (const std::string& path : options_.library_paths) folders.push_back(path + "/");
    }
    for (const std::string& folder : folders) {
      for (const std::string_view extension : {"", ".ini", ".INI"}) {
        if (!extension.empty() && has_extension(name)) continue;
        const std::string path = folder + name + std::string(extension);
        if (const auto text = environment_.read_file(path)) {
          read_ini_text(*text, path, section);
          return;
        }
      }
    }
    if (section.empty() && name.find('[') != std::string::npos) {
      throw OptionError("the section in '" + name + "' has no ] at its end", name.starts_with('[') ? "a section begins with [NAME]" : "a section of a file is given as file.ini[NAME]");
    }
    const OptionRow* const row = find_keyword(name);
    throw OptionError("cannot open the INI file '" + name + "'",
                      row != nullptr ? "an option is written " + std::string(row->keyword) + "=VALUE"
                                     : "scene files end in .pov; other scenes are given as +Iname or --input name");
  }

  void read_ini_text(const std::string& text, const std::string& path, const std::string& section) {
    if (++depth_ > kMaxIniDepth) throw OptionError(path + ": INI files include each other endlessly");
    const std::vector<IniSection> sections = parse_ini(text, path);
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const bool wanted = i == 0 || (!section.empty() && lower_case(sections[i].name) == lower_case(section));
      if (!wanted) continue;
      for (const IniLine& line : sections[i].lines) read_ini_line(line, path);
    }
    --depth_;
  }

  void read_ini_line(const IniLine& line, const std::string& path) {
    try {
      if (line.keyword.empty()) {
        for (const std::string& word : line.values) read_word(word);
        return;
      }
      if (lower_case(line.keyword).ends_with("_command")) {
        assign(line.keyword, line.raw);
        return;
      }
      for (const std::string& value : line.values) assign(line.keyword, value);
    } catch (const OptionError& error) {
      const std::string message = error.what();
      if (message.starts_with("/") || message.find(".ini:") != std::string::npos) throw;
      throw OptionError(path + ":" + std::to_string(line.number) + ": " + message, error.hint());
    }
  }

  const OptionEnvironment& environment_;
  RenderOptions options_;
  int depth_ = 0;
};

void check(const RenderOptions& options) {
  if (options.width < 1 || options.height < 1) {
    throw OptionError("an image of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                      " pixels is empty");
  }
  constexpr long kMostPixels = 1L << 31;
  if (static_cast<long>(options.width) * options.height > kMostPixels) {
    throw OptionError("an image of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                      " pixels is too large");
  }
  try {
    area_of(options.partial, options.width, options.height);
  } catch (const std::invalid_argument& error) {
    throw OptionError(error.what());
  }
}

}  // namespace

OptionEnvironment OptionEnvironment::of_process() {
  OptionEnvironment environment;
  environment.variable = [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    return value != nullptr && *value != '\0' ? std::optional<std::string>(value) : std::nullopt;
  };
  environment.read_file = [](const std::string& path) -> std::optional<std::string> {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  return environment;
}

RenderOptions read_options(std::span<const std::string> arguments, const OptionEnvironment& environment) {
  Reader reader(environment);
  reader.read_system_ini();
  reader.read_arguments(arguments);
  RenderOptions options = reader.take();
  check(options);
  return options;
}

}  // namespace lute
