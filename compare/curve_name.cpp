#include "compare/curve_name.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "compare/figures.hpp"

namespace lute::compare {

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

struct Sampling {
  bool on = false;
  std::string method = "1";
};

bool is_off(std::string_view value) { return value == "off" || value == "false" || value == "no" || value == "0"; }

// +A0.3, -A, +AM3. Those with a letter more, +AE and +AG, are of other options.
bool read_switch(std::string_view word, Sampling& sampling) {
  if (word.size() < 2 || (word[0] != '+' && word[0] != '-') || word[1] != 'a') return false;
  const std::string_view tail = word.substr(2);
  if (tail.starts_with('m')) {
    sampling.method = tail.substr(1);
    if (sampling.method == "3") sampling.on = true;  // lute's method is asked for by its number alone
    return true;
  }
  if (!tail.empty() && std::isalpha(static_cast<unsigned char>(tail[0]))) return tail[0] == 'e' || tail[0] == 'g';
  sampling.on = word[0] == '+';
  return true;
}

// antialias=on, sampling_method=3, --antialias, --no-antialias, --sampling-method=3.
bool read_option(std::string word, Sampling& sampling) {
  if (word.starts_with("--")) word.erase(0, 2);
  std::replace(word.begin(), word.end(), '-', '_');
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals), value = equals == std::string::npos ? "" : word.substr(equals + 1);
  if (name == "antialias" || name == "no_antialias") {
    sampling.on = name == "antialias" && !is_off(value);
  } else if (name == "sampling_method") {
    sampling.method = value;
    if (value == "3") sampling.on = true;
  } else {
    return name.starts_with("antialias_") || name.starts_with("jitter");
  }
  return true;
}

// Of a word that is not about antialiasing: what it sets, without the value.
std::string name_of_setting(const std::string& word) {
  const std::string lower = lower_case(word);
  if (lower.starts_with("declare=")) return word.substr(8, word.find('=', 8) - 8);
  if (lower.starts_with("+q") || lower.starts_with("quality=")) return "quality";
  return word.substr(0, word.find_first_of("=0123456789"));
}

bool is_about_sampling(const std::string& word, Sampling& sampling) {
  const std::string lower = lower_case(word);
  return read_switch(lower, sampling) || read_option(lower, sampling) || lower.starts_with("+r") || lower.starts_with("-r") ||
         lower.starts_with("+j") || lower.starts_with("-j");
}

std::string name_of(const Sampling& sampling) { return sampling.on ? "method " + sampling.method : "no antialiasing"; }

}  // namespace

std::string method_of(const std::string& switches) {
  Sampling sampling;
  for (const std::string& word : words_of(switches)) is_about_sampling(word, sampling);
  return name_of(sampling);
}

std::string curve_of(const std::string& switches) {
  Sampling sampling;
  std::string others;
  for (const std::string& word : words_of(switches)) {
    if (!is_about_sampling(word, sampling)) others += ", " + name_of_setting(word);
  }
  return name_of(sampling) + others;
}

}  // namespace lute::compare
