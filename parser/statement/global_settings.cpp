#include "parser/statement/global_settings.hpp"

#include <algorithm>

#include "parser/session.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

// The first one wins: colours read so far are in its space already.
void parse_assumed_gamma(Reader& reader) {
  GlobalSettings& settings = reader.scene().settings;
  const bool srgb = reader.accept(Word::kSrgb);
  const double gamma = srgb ? 1 : reader.number();
  if (gamma <= 0) reader.error("gamma value must be positive.");
  if (!srgb && gamma < 1)
    reader.possible_error("assumed_gamma below 1 is unusual: it should be 1 or the gamma of a display");
  if (reader.assumed_gamma_given()) {
    reader.warning("New instance of assumed_gamma ignored");
    return;
  }
  settings.gamma_mode = srgb ? GammaMode::kSrgb : GammaMode::kPower;
  settings.assumed_gamma = gamma;
  reader.set_assumed_gamma_given();
}

void parse_charset(Reader& reader) {
  if (reader.accept(Word::kAscii)) reader.set_charset(Reader::Charset::kAscii);
  else if (reader.accept(Word::kUtf8)) reader.set_charset(Reader::Charset::kUtf8);
  else if (reader.accept(Word::kSys)) reader.set_charset(Reader::Charset::kSystem);
  else reader.error_expected("charset type");
}

void parse_noise_generator(Reader& reader) {
  const int generator = reader.integer();
  if (generator < 1 || generator > 3) reader.error("Value for noise_generator in global_settings must be 1, 2, or 3.");
  reader.scene().settings.noise_generator = generator;
  reader.session().noise_generator_given = true;
}

void parse_number_of_waves(Reader& reader) {
  int waves = reader.integer();
  if (waves <= 0) {
    reader.warning("Illegal value for number_of_waves. Changed to 1.");
    waves = 1;
  }
  reader.scene().settings.number_of_waves = waves;
}

void parse_subsurface(Reader& reader) {
  warn_not_rendered(reader, "subsurface");
  reader.open(Word::kSubsurface);
  while (true) {
    if (reader.accept(Word::kSamples)) {
      reader.number();
      reader.comma();
      reader.number();
    } else if (reader.accept(Word::kRadiosity)) {
      reader.number();
    } else {
      break;
    }
  }
  reader.close(Word::kSubsurface);
}

void ignore_number(Reader& reader, const char* message) {
  reader.optional_number();
  reader.warning(message);
}

bool accept_item(Reader& reader) {
  GlobalSettings& settings = reader.scene().settings;
  if (reader.accept(Word::kAdcBailout)) settings.adc_bailout = static_cast<float>(reader.number());
  else if (reader.accept(Word::kAmbientLight)) settings.ambient_light = reader.rgb();
  else if (reader.accept(Word::kAssumedGamma)) parse_assumed_gamma(reader);
  else if (reader.accept(Word::kCharset)) parse_charset(reader);
  else if (reader.accept(Word::kHfGray16)) ignore_number(reader, "hf_gray_16 is ignored: use Grayscale_Output.");
  else if (reader.accept(Word::kIridWavelength)) settings.irid_wavelength = reader.rgb();
  else if (reader.accept(Word::kMaxIntersections)) ignore_number(reader, "max_intersections is ignored: there is no such limit.");
  else if (reader.accept(Word::kMaxTraceLevel)) parse_max_trace_level(reader);
  else if (reader.accept(Word::kMmPerUnit)) settings.mm_per_unit = reader.number();
  else if (reader.accept(Word::kNoiseGenerator)) parse_noise_generator(reader);
  else if (reader.accept(Word::kNumberOfWaves)) parse_number_of_waves(reader);
  else if (reader.accept(Word::kPhotons)) parse_global_photons(reader);
  else if (reader.accept(Word::kRadiosity)) parse_global_radiosity(reader);
  else if (reader.accept(Word::kSubsurface)) parse_subsurface(reader);
  else return false;
  return true;
}

}  // namespace

void parse_max_trace_level(Reader& reader) {
  constexpr int kMost = 256;
  const int level = reader.integer();
  if (level > kMost) reader.warning("Maximum max_trace_level is 256.");
  reader.scene().settings.max_trace_level = std::clamp(level, 1, kMost);
}

void parse_global_settings(Reader& reader) {
  reader.open(Word::kGlobalSettings);
  while (accept_item(reader)) {
  }
  reader.close(Word::kGlobalSettings);
}

}  // namespace lute
