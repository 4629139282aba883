#include "parser/statement/photons.hpp"

#include <string>

namespace lute {
namespace {

bool number_is_on(Reader& reader) { return reader.integer() != 0; }

// A target that refracts stops photons, pass_through lets them pass: all three contradict each other.
bool in_conflict(const ObjectExtras& extras) {
  return extras.photon_pass_through && extras.photon_target && extras.photon_refraction.value_or(true);
}

void warn_conflict(Reader& reader, const char* turned_off) {
  reader.warning(std::string("pass_through, target and refraction contradict each other: ") + turned_off + " is turned off.");
}

void parse_target(Reader& reader, ObjectExtras& extras) {
  const double density = reader.optional_number().value_or(1);
  extras.photon_target = density > 0;
  extras.photon_density = static_cast<float>(density);
  if (!in_conflict(extras)) return;
  if (extras.photon_refraction == true) {
    extras.photon_pass_through = false;
    warn_conflict(reader, "pass_through");
  } else {
    extras.photon_refraction = false;
    warn_conflict(reader, "refraction");
  }
}

void parse_refraction(Reader& reader, ObjectExtras& extras) {
  extras.photon_refraction = number_is_on(reader);
  if (!in_conflict(extras)) return;
  extras.photon_pass_through = false;
  warn_conflict(reader, "pass_through");
}

void parse_pass_through(Reader& reader, ObjectExtras& extras) {
  const auto value = reader.optional_number();
  extras.photon_pass_through = !value || static_cast<int>(*value) != 0;
  if (!in_conflict(extras)) return;
  extras.photon_refraction = false;
  warn_conflict(reader, "refraction");
}

}  // namespace

void parse_object_photons(Reader& reader, Object& object) {
  ObjectExtras& extras = object.extras.edit();
  reader.open(Word::kPhotons);
  while (true) {
    if (reader.accept(Word::kTarget)) parse_target(reader, extras);
    else if (reader.accept(Word::kRefraction)) parse_refraction(reader, extras);
    else if (reader.accept(Word::kReflection)) extras.photon_reflection = number_is_on(reader);
    else if (reader.accept(Word::kPassThrough)) parse_pass_through(reader, extras);
    else if (reader.accept(Word::kCollect)) extras.photon_collect = reader.optional_flag();
    else break;
  }
  reader.close(Word::kPhotons);
}

}  // namespace lute
