#include "parser/options/option_value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "parser/options/render_options.hpp"

namespace lute {
namespace {

std::string_view without_plus(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A format by the name of its extension: `--format exr`.
std::optional<FileFormat> format_by_name(std::string_view text) {
  const std::string name = lower_case(text);
  if (name == "png") return FileFormat::kPng;
  if (name == "tga") return FileFormat::kTarga;
  if (name == "bmp") return FileFormat::kBmp;
  if (name == "ppm") return FileFormat::kPpm;
  if (name == "jpg" || name == "jpeg") return FileFormat::kJpeg;
  if (name == "exr") return FileFormat::kOpenExr;
  if (name == "hdr") return FileFormat::kRadianceHdr;
  return std::nullopt;
}

std::optional<FileFormat> format_by_letter(char letter) {
  const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  if (upper == 'S') return FileFormat::kPng;  // "the system's": PNG on Unix
  for (const FileFormat format :
       {FileFormat::kPng, FileFormat::kTarga, FileFormat::kTargaRle, FileFormat::kBmp, FileFormat::kPpm,
        FileFormat::kJpeg, FileFormat::kOpenExr, FileFormat::kRadianceHdr}) {
    if (traits_of(format).letter == upper) return format;
  }
  return std::nullopt;
}

bool is_name(std::string_view text) {
  if (text.empty() || is_digit(text.front())) return false;
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

}  // namespace

namespace {

constexpr char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower_letter(x) == lower_letter(y); });
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), lower_letter);
  return lower;
}

std::string hyphenated(std::string_view keyword) {
  std::string name = lower_case(keyword);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

bool truth_of(std::string_view text) {
  const std::string value = lower_case(text);
  for (const std::string_view word : {"on", "true", "yes", "1"}) {
    const std::size_t common = std::min(value.size(), word.size());
    if (common > 0 && value.substr(0, common) == word.substr(0, common)) return true;
  }
  return false;
}

std::optional<int> leading_integer(std::string_view text) {
  text = without_plus(text);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) throw OptionError("the number '" + std::string(text) + "' is too large");
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> leading_number(std::string_view text) {
  text = without_plus(text);
  if (text.empty() || (!is_digit(text.front()) && text.front() != '.' && text.front() != '-')) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  return value;
}

bool is_integer(std::string_view text) {
  text = without_plus(text);
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

bool is_number(std::string_view text) {
  text = without_plus(text);
  if (text.empty() || (!is_digit(text.front()) && text.front() != '.' && text.front() != '-')) return false;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

void set_file_type(OutputSettings& settings, std::string_view text) {
  const auto refuse = [&] {
    throw OptionError("unrecognized output file format '" + std::string(text) +
                      "': N, T, C, B, P, J, E or H, then bits");
  };
  if (const auto named = format_by_name(text)) {
    settings.format = *named;
    return;
  }
  const auto format = text.empty() ? std::nullopt : format_by_letter(text.front());
  if (!format) refuse();
  std::string_view rest = text.substr(1);
  bool greyscale = false;
  const auto take_g = [&] {
    if (greyscale || rest.empty() || (rest.front() != 'g' && rest.front() != 'G')) return;
    greyscale = true;
    rest.remove_prefix(1);
  };
  take_g();
  if (!rest.empty() && is_digit(rest.front())) {
    settings.bits = leading_integer(rest).value_or(8);
    rest.remove_prefix(static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), is_digit) - rest.begin()));
  }
  take_g();
  if (!rest.empty()) refuse();
  if (greyscale && *format != FileFormat::kPng && *format != FileFormat::kPpm) {
    throw OptionError("greyscale is not supported with the output file format '" + std::string(text) +
                      "', only with N and P");
  }
  settings.format = *format;
  if (greyscale) settings.greyscale = true;
}

GammaCurve gamma_curve(std::string_view text) {
  if (lower_case(text) == "srgb") return GammaCurve::srgb();
  const auto gamma = leading_number(text);
  if (!gamma) throw OptionError("unrecognized gamma setting '" + std::string(text) + "': 'sRGB' or a positive number");
  if (*gamma < 0.001) throw OptionError("the gamma '" + std::string(text) + "' is too small");
  return GammaCurve::power(*gamma);
}

DitherMethod dither_method(std::string_view text) {
  struct Row {
    std::string_view name;
    DitherMethod method;
  };
  static constexpr std::array<Row, 6> kMethods{{{"b2", DitherMethod::kBayer2},
                                                {"b3", DitherMethod::kBayer3},
                                                {"b4", DitherMethod::kBayer4},
                                                {"d1", DitherMethod::kDiffusion1},
                                                {"d2", DitherMethod::kDiffusion2},
                                                {"fs", DitherMethod::kFloydSteinberg}}};
  const std::string name = lower_case(text);
  for (const Row& row : kMethods) {
    if (row.name == name) return row.method;
  }
  throw OptionError("unrecognized dither method '" + std::string(text) + "': B2, B3, B4, D1, D2 or FS");
}

std::pair<std::string, std::string> declaration(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    throw OptionError("a declaration is NAME=VALUE, not '" + std::string(text) + "'");
  const std::string name(text.substr(0, equals));
  const std::string_view value = text.substr(equals + 1);
  if (!is_name(name)) throw OptionError("'" + name + "' cannot be declared: it is no identifier");
  if (const std::size_t open = value.find('"'); open != std::string_view::npos) {
    const std::size_t close = value.find('"', open + 1);
    const std::size_t end = close == std::string_view::npos ? value.size() : close;
    return {name, '"' + std::string(value.substr(open + 1, end - open - 1)) + '"'};
  }
  const auto number = leading_number(value);
  if (!number)
    throw OptionError("the value of '" + name + "' is neither a number nor a text in quotes: '" + std::string(value) +
                      "'");
  std::array<char, 40> digits;
  std::snprintf(digits.data(), digits.size(), "%.6g", *number);
  return {name, digits.data()};
}

}  // namespace lute
