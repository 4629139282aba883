// Reading the values of options. All functions throw OptionError. Source: specification chapter 30 §7.3, §7.6, §7.8,
// §9.1, §9.4.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/output/output_settings.hpp"

namespace lute {

// `on`, `true`, `yes`, `1`, or a prefix or an extension of one of these; everything else is false.
bool truth_of(std::string_view text);

// The number at the beginning of a text; nothing where there is none. What follows it is ignored.
std::optional<int> leading_integer(std::string_view text);
std::optional<double> leading_number(std::string_view text);

// True if the whole text is a number, of the digits and points of "12.5".
bool is_number(std::string_view text);
bool is_integer(std::string_view text);

// "N16", "Ng", "PNG": format, bits and greyscale.
void set_file_type(OutputSettings& settings, std::string_view text);
GammaCurve gamma_curve(std::string_view text);  // "sRGB" or a positive number
DitherMethod dither_method(std::string_view text);

// NAME=VALUE. A number is rounded to 6 significant digits, as the reference hands it over; a text in quotes keeps them.
std::pair<std::string, std::string> declaration(std::string_view text);

std::string lower_case(std::string_view text);
bool equal_ignoring_case(std::string_view a, std::string_view b);
std::string hyphenated(std::string_view keyword);  // Antialias_Depth -> antialias-depth

}  // namespace lute
