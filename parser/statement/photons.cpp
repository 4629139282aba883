#include "parser/statement/photons.hpp"

#include <string>

namespace lute {
namespace {

bool number_is_on(Reader& reader) { return reader.integer() != 0; }

// A target that refracts stops photons, pass_through lets them pass: all three contradict each other.
bool in_conflict(const Object& object) {
  return object.photon_pass_through && object.photon_target && object.photon_refraction.value_or(true);
}

void warn_conflict(Reader& reader, const char* turned_off) {
  reader.warning(std::string("pass_through, target and refraction contradict each other: ") + turned_off + " is turned off.");
}

void parse_target(Reader& reader, Object& object) {
  const double density = reader.optional_number().value_or(1);
  object.photon_target = density > 0;
  object.photon_density = static_cast<float>(density);
  if (!in_conflict(object)) return;
  if (object.photon_refraction == true) {
    object.photon_pass_through = false;
    warn_conflict(reader, "pass_through");
  } else {
    object.photon_refraction = false;
    warn_conflict(reader, "refraction");
  }
}

void parse_refraction(Reader& reader, Object& object) {
  object.photon_refraction = number_is_on(reader);
  if (!in_conflict(object)) return;
  object.photon_pass_through = false;
  warn_conflict(reader, "pass_through");
}

void parse_pass_through(Reader& reader, Object& object) {
  const auto value = reader.optional_number();
  object.photon_pass_through = !value || static_cast<int>(*value) != 0;
  if (!in_conflict(object)) return;
  object.photon_refraction = false;
  warn_conflict(reader, "refraction");
}

}  // namespace

void parse_object_photons(Reader& reader, Object& object) {
  reader.open(Word::kPhotons);
  while (true) {
    if (reader.accept(Word::kTarget)) parse_target(reader, object);
    else if (reader.accept(Word::kRefraction)) parse_refraction(reader, object);
    else if (reader.accept(Word::kReflection)) object.photon_reflection = number_is_on(reader);
    else if (reader.accept(Word::kPassThrough)) parse_pass_through(reader, object);
    else if (reader.accept(Word::kCollect)) object.photon_collect = reader.optional_flag();
    else break;
  }
  reader.close(Word::kPhotons);
}

}  // namespace lute
