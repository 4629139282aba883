#include "engine/scene/media.hpp"
#include "parser/statement/interior.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

Media default_media(Reader& reader) {
  Media media;
  if (reader.version() < 350) {
    media.method = 1;
    media.intervals = 10;
    media.samples_min = media.samples_max = 1;
  }
  return media;
}

void parse_samples(Reader& reader, Media& media) {
  media.samples_min = reader.integer();
  reader.comma();
  const auto most = reader.optional_number();
  media.samples_max = most ? static_cast<int>(*most) : media.samples_min;
  if (media.samples_min < 1) reader.error("At least one sample per interval is needed in media.");
  if (media.samples_max < media.samples_min) reader.error("Maximum number of samples per interval smaller than minimum number.");
}

void parse_scattering(Reader& reader, Media& media) {
  reader.open(Word::kScattering);
  media.scattering_type = reader.integer();
  if (media.scattering_type < 1 || media.scattering_type > 5) reader.warning("Unknown atmospheric scattering type.");
  reader.comma();
  media.scattering = reader.rgb();
  while (true) {
    if (reader.accept(Word::kEccentricity)) {
      if (media.scattering_type != 5) reader.error("Eccentricity cannot be used with this scattering type.");
      media.eccentricity = reader.number();
    } else if (reader.accept(Word::kExtinction)) {
      media.extinction = reader.number();
    } else {
      break;
    }
  }
  reader.close(Word::kScattering);
}

bool accept_sampling_item(Reader& reader, Media& media) {
  if (reader.accept(Word::kMethod)) {
    media.method = reader.integer();
    if (media.method < 1 || media.method > 3) reader.error("Sample method choices are 1, 2, or 3.");
  } else if (reader.accept(Word::kIntervals)) {
    media.intervals = reader.integer();
    if (media.intervals < 1) reader.error("At least one interval is needed in media.");
  } else if (reader.accept(Word::kSamples)) {
    parse_samples(reader, media);
  } else if (reader.accept(Word::kConfidence)) {
    media.confidence = reader.number();
    if (media.confidence < 0 || media.confidence >= 1) reader.error("Illegal confidence value in media.");
  } else if (reader.accept(Word::kVariance)) {
    media.variance = reader.number();
  } else if (reader.accept(Word::kRatio)) {
    media.ratio = reader.number();
  } else if (reader.accept(Word::kAaLevel)) {
    media.aa_level = reader.integer();
    if (media.aa_level < 1) reader.error("aa_level in media must be at least one.");
  } else if (reader.accept(Word::kAaThreshold)) {
    media.aa_threshold = reader.number();
    if (media.aa_threshold <= 0) reader.error("aa_threshold in media must be greater than zero.");
  } else if (reader.accept(Word::kJitter)) {
    media.jitter = reader.number();
  } else {
    return false;
  }
  return true;
}

bool accept_item(Reader& reader, Media& media) {
  if (reader.accept(Word::kAbsorption)) {
    media.absorption = reader.rgb();
  } else if (reader.accept(Word::kEmission)) {
    media.emission = reader.rgb();
  } else if (reader.accept(Word::kScattering)) {
    parse_scattering(reader, media);
  } else if (reader.accept(Word::kCollect)) {
    media.collect = reader.optional_flag();
  } else if (reader.accept(Word::kDensity)) {
    media.densities.push_back(parse_density(reader));
  } else if (const auto transform = accept_transformation(reader)) {
    for (PigmentPtr& density : media.densities) density = moved(density, *transform);
  } else {
    return accept_sampling_item(reader, media);
  }
  return true;
}

}  // namespace

MediaPtr parse_media(Reader& reader) {
  NestingGuard guard(reader);
  const SourceLocation where = reader.location();
  warn_not_rendered(reader, "media");
  reader.open(Word::kMedia);
  const auto named = reader.accept_identifier<MediaPtr>();
  Media media = named ? **named : default_media(reader);
  media.where = where;
  while (accept_item(reader, media)) {
  }
  reader.close(Word::kMedia);
  return std::make_shared<const Media>(std::move(media));
}

}  // namespace lute
