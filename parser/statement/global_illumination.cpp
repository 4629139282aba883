// radiosity { ... } and photons { ... } of global_settings (specification chapter 11 §3.1, §3.2).
#include "parser/statement/global_settings.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

double checked(Reader& reader, bool (*valid)(double), const char* message) {
  const double value = reader.number();
  if (!valid(value)) reader.error(message);
  return value;
}

bool is_positive(double v) { return v > 0; }
bool is_not_negative(double v) { return v >= 0; }
bool is_fraction(double v) { return v >= 0 && v <= 1; }
bool is_positive_fraction(double v) { return v > 0 && v <= 1; }

int second_integer(Reader& reader, int when_missing) {
  reader.comma();
  const auto value = reader.optional_number();
  return value ? static_cast<int>(*value) : when_missing;
}

// Values that are checked against each other at the end of the block.
struct RadiosityLimits {
  double minimum_reuse = 0.015, maximum_reuse = 0.2;
  bool minimum_given = false, maximum_given = false;
  double pretrace_start = 0.08, pretrace_end = 0.04;
};

void parse_radiosity_count(Reader& reader) {
  const int count = reader.integer();
  if (count <= 0) reader.error("Radiosity count must be a positive number.");
  const int pool = second_integer(reader, count > 1600 ? count : 1600);
  if (pool < count) reader.error("Radiosity count can not be more than direction pool size (count 2nd value).");
}

void parse_nearest_count(Reader& reader) {
  const int most = reader.integer();
  if (most < 1 || most > 20) reader.error("Radiosity nearest count must be a value from 1 to 20.");
  const int least = second_integer(reader, 0);
  if (least < 0 || least >= most) reader.error("Radiosity nearest count for adaptive pretrace must be non-negative and smaller than general nearest count.");
}

bool accept_radiosity_limit(Reader& reader, RadiosityLimits& limits) {
  if (reader.accept(Word::kMaximumReuse)) {
    limits.maximum_reuse = checked(reader, is_positive, "Radiosity maximum reuse must be a positive number.");
    limits.maximum_given = true;
  } else if (reader.accept(Word::kMinimumReuse)) {
    limits.minimum_reuse = checked(reader, is_not_negative, "Radiosity minimum reuse can not be a negative number.");
    limits.minimum_given = true;
  } else if (reader.accept(Word::kPretraceStart)) {
    limits.pretrace_start = checked(reader, is_positive_fraction, "Radiosity pretrace start must be greater than 0 and no higher than 1.");
  } else if (reader.accept(Word::kPretraceEnd)) {
    limits.pretrace_end = checked(reader, is_positive_fraction, "Radiosity pretrace end must be greater than 0 and no higher than 1.");
  } else {
    return false;
  }
  return true;
}

bool accept_radiosity_item(Reader& reader) {
  if (reader.accept(Word::kAdcBailout)) {
    checked(reader, is_positive, "ADC Bailout must be a positive number.");
  } else if (reader.accept(Word::kAlwaysSample) || reader.accept(Word::kMedia) || reader.accept(Word::kNormal) ||
             reader.accept(Word::kSubsurface) || reader.accept(Word::kMaxSample)) {
    reader.number();
  } else if (reader.accept(Word::kBrightness)) {
    checked(reader, is_positive, "Radiosity brightness must be a positive number.");
  } else if (reader.accept(Word::kCount)) {
    parse_radiosity_count(reader);
  } else if (reader.accept(Word::kErrorBound)) {
    checked(reader, is_positive, "Radiosity error bound must be a positive number.");
  } else if (reader.accept(Word::kGrayThreshold)) {
    checked(reader, is_fraction, "Radiosity gray threshold must be from 0.0 to 1.0.");
  } else if (reader.accept(Word::kLowErrorFactor)) {
    checked(reader, is_positive, "Radiosity low error factor must be a positive number.");
  } else if (reader.accept(Word::kNearestCount)) {
    parse_nearest_count(reader);
  } else if (reader.accept(Word::kRecursionLimit)) {
    const int limit = reader.integer();
    if (limit < 1 || limit > 20) reader.error("Radiosity recursion limit must be in the range 1 to 20.");
  } else if (reader.accept(Word::kLoadFile) || reader.accept(Word::kSaveFile)) {
    reader.file_name();
    reader.warning("load_file and save_file of radiosity are ignored: use Radiosity_File_Name.");
  } else {
    return false;
  }
  return true;
}

void check_reuse(Reader& reader, RadiosityLimits& limits) {
  if (limits.minimum_reuse <= limits.maximum_reuse / 2) return;
  if (!limits.minimum_given) {
    limits.minimum_reuse = limits.maximum_reuse / 2;
  } else if (!limits.maximum_given) {
    limits.maximum_reuse = 2 * limits.minimum_reuse;
  } else if (limits.minimum_reuse >= limits.maximum_reuse) {
    reader.error("Radiosity maximum_reuse must be larger than minimum_reuse.");
  } else {
    reader.warning("Radiosity minimum reuse should be at most half the maximum reuse.");
  }
}

bool accept_photon_pass_item(Reader& reader) {
  if (reader.accept(Word::kGather)) {
    const int least = reader.integer();
    reader.comma();
    const int most = reader.integer();
    if (most < 0) reader.error("max_gather_count cannot be negative.");
    if (most > 0 && least < 0) reader.error("min_gather_count cannot be negative.");
    if (most > 0 && least > most) reader.error("min_gather_count must be less than max_gather_count.");
  } else if (reader.accept(Word::kRadius)) {
    for (int i = 0; i < 4; ++i) {
      if (i > 0) reader.comma();
      reader.optional_number();
    }
  } else if (reader.accept(Word::kExpandThresholds)) {
    reader.number();
    reader.comma();
    reader.integer();
  } else if (reader.accept(Word::kMedia)) {
    if (reader.integer() < 0) reader.error("max media steps must be non-negative.");
    reader.comma();
    if (const auto factor = reader.optional_number(); factor && *factor <= 0)
      reader.error("media spacing factor must be greater than zero.");
  } else if (reader.accept(Word::kLoadFile) || reader.accept(Word::kSaveFile)) {
    reader.file_name();
  } else {
    return false;
  }
  return true;
}

bool accept_photon_item(Reader& reader) {
  for (const Word word : {Word::kSpacing, Word::kCount, Word::kJitter, Word::kAutostop, Word::kAdcBailout, Word::kMaxTraceLevel})
    if (reader.accept(word)) {
      reader.number();
      return true;
    }
  return accept_photon_pass_item(reader);
}

}  // namespace

void parse_global_radiosity(Reader& reader) {
  warn_not_rendered(reader, "radiosity");
  reader.open(Word::kRadiosity);
  RadiosityLimits limits;
  while (accept_radiosity_limit(reader, limits) || accept_radiosity_item(reader)) {
  }
  reader.close(Word::kRadiosity);
  if (limits.pretrace_end > limits.pretrace_start) reader.error("Radiosity pretrace end must be smaller than or equal to pretrace start.");
  check_reuse(reader, limits);
}

void parse_global_photons(Reader& reader) {
  warn_not_rendered(reader, "photons");
  reader.open(Word::kPhotons);
  while (accept_photon_item(reader)) {
  }
  reader.close(Word::kPhotons);
}

}  // namespace lute
