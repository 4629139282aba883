// Figures as tables and pages show them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lute::compare {

// One number through one printf conversion: formatted("%.3f s", 1.5) is "1.500 s".
std::string formatted(const char* format, double value);

// The middle one, or the mean of the middle two; `values` must not be empty.
double median(std::vector<double> values);

// A field of a CSV file, quoted where it has to be (RFC 4180).
std::string csv_field(std::string_view text);

// The words of a text, without the blanks between them.
std::vector<std::string> words_of(std::string_view text);

}  // namespace lute::compare
