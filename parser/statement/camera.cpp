#include "parser/statement/camera.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <cmath>
#include <string>

#include "parser/statement/normal.hpp"
#include "parser/statement/object.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

struct KindWord {
  Word word;
  CameraKind kind;
};
constexpr std::array kKinds = {KindWord{Word::kPerspective, CameraKind::kPerspective},
                               KindWord{Word::kOrthographic, CameraKind::kOrthographic},
                               KindWord{Word::kFisheye, CameraKind::kFisheye},
                               KindWord{Word::kUltraWideAngle, CameraKind::kUltraWideAngle},
                               KindWord{Word::kOmnimax, CameraKind::kOmnimax},
                               KindWord{Word::kPanoramic, CameraKind::kPanoramic},
                               KindWord{Word::kSpherical, CameraKind::kSpherical}};

std::string_view name_of_kind(CameraKind kind) {
  for (const KindWord& k : kKinds)
    if (k.kind == kind) return spelling(k.word);
  return kind == CameraKind::kMesh ? "mesh" : "cylinder";
}

bool is_flat(const Camera& camera) {
  return camera.kind == CameraKind::kPerspective || camera.kind == CameraKind::kOrthographic;
}

// What was written, besides the values: the arithmetic comes after the last item (from version 3.5 on).
struct Written {
  bool up = false, right = false, look_at = false;
  std::optional<double> angle;
  std::optional<dvec3> focal_point;
  Transform transform;
};

// --- The arithmetic of chapter 30 §2.3 -------------------------------------------------------------------------------

void apply_angle(Camera& camera, double angle) {
  camera.direction = glm::normalize(camera.direction) * (0.5 * glm::length(camera.right) / std::tan(radians(angle) / 2));
}

void apply_look_at(Reader& reader, Camera& camera, bool warn) {
  const double handedness = glm::dot(glm::cross(camera.up, camera.direction), camera.right);
  const double direction_length = glm::length(camera.direction);
  const double up_length = glm::length(camera.up), right_length = glm::length(camera.right);
  const dvec3 to_target = camera.look_at - camera.location;
  if (glm::dot(to_target, to_target) < kEpsilon) reader.error("Camera location and look_at point must be different.");
  const dvec3 direction = glm::normalize(to_target);
  dvec3 right = glm::cross(camera.sky, direction);
  if (std::abs(right.x) < kEpsilon && std::abs(right.y) < kEpsilon && std::abs(right.z) < kEpsilon) {
    right = camera.right;
    if (warn)
      reader.warning("Camera location to look_at direction and sky direction should be different. Using default/supplied right vector instead.");
  }
  right = glm::normalize(right);
  camera.up = up_length * glm::cross(direction, right);
  camera.direction = direction_length * direction;
  camera.right = (handedness > 0 ? right_length : -right_length) * right;
}

// An orthographic camera shows what a perspective one with the same vectors would at the distance of look_at.
void scale_orthographic(Camera& camera) {
  const double distance = glm::length(camera.look_at - camera.location), focal = glm::length(camera.direction);
  if (!(distance > kEpsilon && focal > kEpsilon)) return;
  camera.right *= distance / focal;
  camera.up *= distance / focal;
}

void transform_camera(Camera& camera, const Transform& transform) {
  camera.location = transform.point(camera.location);
  camera.direction = transform.direction(camera.direction);
  camera.up = transform.direction(camera.up);
  camera.right = transform.direction(camera.right);
}

void warn_if_not_perpendicular(Reader& reader, const Camera& camera) {
  const auto slanted = [](const dvec3& a, const dvec3& b) { return std::abs(glm::dot(a, b)) > kEpsilon; };
  if (slanted(camera.right, camera.up) || slanted(camera.right, camera.direction) || slanted(camera.up, camera.direction))
    reader.warning("Camera vectors are not perpendicular. Making look_at the last statement may help.");
}

void settle(Reader& reader, Camera& camera, const Written& written) {
  std::optional<double> focal_distance;
  if (is_flat(camera) && written.angle && *written.angle > 0) {
    apply_angle(camera, *written.angle);
    focal_distance = glm::length(camera.direction);
  }
  if (written.look_at) {
    apply_look_at(reader, camera, true);
    focal_distance = glm::length(camera.direction);
  }
  const bool unscaled = !written.up && !written.right;
  if (camera.kind == CameraKind::kOrthographic && (unscaled || written.angle)) scale_orthographic(camera);
  if (written.focal_point) focal_distance = glm::length(*written.focal_point - camera.location);
  camera.focal_distance = focal_distance.value_or(1);
  if (camera.focal_distance == 0) camera.focal_distance = 1;
  transform_camera(camera, written.transform);
  warn_if_not_perpendicular(reader, camera);
}

// --- Items -----------------------------------------------------------------------------------------------------------

// The body of a mesh, or an identifier that holds one; also behind the word mesh2.
MeshCamera::Part parse_mesh_of_camera(Reader& reader) {
  const ObjectPtr object = parse_mesh_object(reader);
  const auto* mesh = object->shape_if<Mesh>();
  if (mesh == nullptr) reader.error("A mesh camera needs meshes.");
  return {mesh->data, object->transform};
}

void check_mesh_camera(Reader& reader, int rays, int distribution) {
  if (rays == 0) reader.error("Rays per pixel may not be 0");
  if (distribution < 0 || distribution > 3) reader.error("Unrecognized distribution method");
  if (distribution >= 2 && rays != 1) reader.error("Rays per pixel must be 1 for distribution method #2 or #3");
}

std::shared_ptr<const MeshCamera> parse_mesh_camera(Reader& reader) {
  reader.open(Word::kMeshCamera);
  MeshCamera camera;
  camera.rays = reader.integer();
  reader.comma();
  const int distribution = reader.integer();
  reader.comma();
  check_mesh_camera(reader, camera.rays, distribution);
  camera.distribution = static_cast<MeshCamera::Distribution>(distribution);
  camera.reach = reader.optional_number().value_or(0);
  while (reader.accept(Word::kMesh) || reader.accept(Word::kMesh2)) camera.parts.push_back(parse_mesh_of_camera(reader));
  if (camera.parts.empty()) reader.error_expected("mesh or mesh2");
  // A negative number is a very large one in the reference.
  const bool too_many = camera.rays < 0 || static_cast<std::size_t>(camera.rays) > camera.parts.size();
  if (distribution == 0 && too_many) reader.error("Rays per pixel must be <= number of meshes for distribution method #0");
  camera.rays = distribution == 1 ? 1 : camera.rays;  // of more only the first meets a face
  camera.smooth = reader.accept(Word::kSmooth);
  if (camera.smooth && distribution != 3) reader.error("Smooth can only be used with distribution method #3");
  reader.close(Word::kMeshCamera);
  return std::make_shared<const MeshCamera>(std::move(camera));
}

void parse_cylinder_kind(Reader& reader, Camera& camera) {
  const int type = reader.integer();
  if (type < 1 || type > 4) reader.error("Invalid cylinder camera type, valid are types 1 to 4.");
  camera.kind = static_cast<CameraKind>(static_cast<int>(CameraKind::kCylinder1) + type - 1);
}

bool at_kind(Reader& reader) {
  const Word word = reader.word();
  return word == Word::kCylinder || word == Word::kMeshCamera || std::ranges::find(kKinds, word, &KindWord::word) != std::end(kKinds);
}

bool accept_kind(Reader& reader, Camera& camera) {
  for (const KindWord& k : kKinds)
    if (reader.accept(k.word)) {
      camera.kind = k.kind;
      return true;
    }
  if (reader.accept(Word::kCylinder)) {
    parse_cylinder_kind(reader, camera);
  } else if (reader.accept(Word::kMeshCamera)) {
    camera.mesh = parse_mesh_camera(reader);
    camera.kind = CameraKind::kMesh;
  } else {
    return false;
  }
  return true;
}

void parse_spherical_angle(Reader& reader, Camera& camera) {
  camera.horizontal_angle = reader.number();
  reader.comma();
  camera.vertical_angle = reader.optional_number().value_or(camera.horizontal_angle / 2);
  if (camera.horizontal_angle < 0) reader.error("Negative horizontal angle not allowed.");
  if (camera.vertical_angle < 0) reader.error("Negative vertical angle not allowed.");
}

double parse_angle(Reader& reader, const Camera& camera) {
  const double angle =
      camera.kind == CameraKind::kOrthographic ? reader.optional_number().value_or(0) : reader.number();
  if (angle < 0) reader.error("Negative viewing angle.");
  if (is_flat(camera) && angle >= 180) reader.error("Viewing angle has to be smaller than 180 degrees.");
  return angle;
}

void parse_blur_samples(Reader& reader, Camera& camera) {
  const int first = reader.integer();
  reader.comma();
  const auto second = reader.optional_number();
  camera.blur_samples_min = second ? first : 0;
  camera.blur_samples_max = second ? static_cast<int>(*second) : first;
  if (first <= 0 || camera.blur_samples_max <= 0) reader.error("Illegal number of focal blur samples.");
  if (camera.blur_samples_min > camera.blur_samples_max) reader.error("Focal blur samples minimum must not be larger than maximum.");
}

void parse_bokeh(Reader& reader, Camera& camera) {
  reader.open(Word::kBokeh);
  while (reader.accept(Word::kPigment)) camera.bokeh = parse_pigment(reader, statements_of(reader).defaults().pigment);
  reader.close(Word::kBokeh);
}

bool accept_lens_item(Reader& reader, Camera& camera) {
  if (reader.accept(Word::kAperture)) {
    camera.aperture = reader.number();
  } else if (reader.accept(Word::kBlurSamples)) {
    parse_blur_samples(reader, camera);
  } else if (reader.accept(Word::kConfidence)) {
    const double value = reader.number();
    if (value > 0 && value < 1) camera.confidence = value;
    else reader.warning("Illegal confidence value. Default is used.");
  } else if (reader.accept(Word::kVariance)) {
    const double value = reader.number();
    if (value >= 0 && value <= 1) camera.variance = value;
    else reader.warning("Illegal variance value. Default is used.");
  } else if (reader.accept(Word::kNormal)) {
    camera.normal = parse_normal(reader, camera.normal);
  } else {
    return false;
  }
  return true;
}

bool accept_vector_item(Reader& reader, Camera& camera, Written& written) {
  if (reader.accept(Word::kLocation)) {
    camera.location = reader.vector();
  } else if (reader.accept(Word::kDirection)) {
    camera.direction = reader.vector();
  } else if (reader.accept(Word::kSky)) {
    camera.sky = reader.vector();
  } else if (reader.accept(Word::kUp)) {
    camera.up = reader.vector();
    written.up = true;
  } else if (reader.accept(Word::kRight)) {
    camera.right = reader.vector();
    written.right = true;
  } else if (reader.accept(Word::kLookAt)) {
    camera.look_at = reader.vector();
    written.look_at = true;
  } else if (reader.accept(Word::kFocalPoint)) {
    written.focal_point = reader.vector();
  } else {
    return false;
  }
  return true;
}

bool accept_item(Reader& reader, Camera& camera, Written& written) {
  if (camera.kind != CameraKind::kMesh && reader.accept(Word::kAngle)) {
    if (camera.kind == CameraKind::kSpherical) parse_spherical_angle(reader, camera);
    else camera.angle = *(written.angle = parse_angle(reader, camera));
  } else if (reader.accept(Word::kBokeh)) {
    parse_bokeh(reader, camera);
  } else if (const auto transform = accept_transformation(reader)) {
    written.transform = written.transform.then(*transform);
  } else {
    return accept_vector_item(reader, camera, written) || accept_lens_item(reader, camera);
  }
  return true;
}

// Nothing but transformations may follow an identifier.
Camera parse_named(Reader& reader, Camera camera) {
  Transform transform;
  while (const auto next = accept_transformation(reader)) transform = transform.then(*next);
  transform_camera(camera, transform);
  return camera;
}

// --- Versions below 3.5: every item acts when it is read (chapter 30 §2.4) --------------------------------------------

void act_at_once(Reader& reader, Camera& camera, Written& written) {
  if (written.angle && camera.kind == CameraKind::kPerspective) {
    apply_angle(camera, *written.angle);
    camera.focal_distance = glm::length(camera.direction);
  }
  if (written.look_at) {
    apply_look_at(reader, camera, false);
    camera.focal_distance = glm::length(camera.direction);
  }
  if (written.focal_point) camera.focal_distance = glm::length(*written.focal_point - camera.location);
  transform_camera(camera, written.transform);
}

bool accept_old_kind(Reader& reader, Camera& camera) {
  if (reader.at(Word::kSpherical) || reader.at(Word::kMeshCamera)) return false;
  if (!accept_kind(reader, camera)) return false;
  if (camera.kind == CameraKind::kOrthographic) scale_orthographic(camera);
  return true;
}

Camera parse_old(Reader& reader, Camera camera) {
  while (true) {
    if (accept_old_kind(reader, camera)) continue;
    if (reader.accept(Word::kBlurSamples)) {
      camera.blur_samples_min = 0;
      camera.blur_samples_max = reader.integer();
      if (camera.blur_samples_max <= 0) reader.error("Illegal number of focal blur samples.");
      continue;
    }
    Written written;
    if (reader.at(Word::kBokeh) || !accept_item(reader, camera, written)) break;
    act_at_once(reader, camera, written);
  }
  if (camera.focal_distance == 0) camera.focal_distance = 1;
  return camera;
}

}  // namespace

Camera parse_camera(Reader& reader, const Camera& start) {
  const SourceLocation where = reader.location();
  reader.open(Word::kCamera);
  Camera camera = start;
  const auto named = reader.accept_identifier<CameraPtr>();
  if (named) camera = **named;
  camera.where = where;
  if (reader.version() < 350) {
    camera = parse_old(reader, camera);
  } else if (named) {
    camera = parse_named(reader, camera);
  } else {
    Written written;
    while (accept_kind(reader, camera)) {
    }
    while (accept_item(reader, camera, written)) {
    }
    // A type must come first; of a mesh camera POV-Ray says no more than of any other word.
    if (camera.kind != CameraKind::kMesh && at_kind(reader))
      reader.error_expected(std::string(name_of_kind(camera.kind)) + " camera modifier");
    settle(reader, camera, written);
  }
  reader.close(Word::kCamera);
  return camera;
}

}  // namespace lute
