#include "engine/plan/sampling_plan.hpp"

#include "engine/camera/focal_blur.hpp"

namespace lute {
namespace {

constexpr SourceLocation kNowhere{};

}  // namespace

void plan_sampling(const Scene& scene, const Antialiasing& antialiasing, bool estimate_error, RenderPlan& plan) {
  const auto add = [&](const char* group, const char* name, bool needed, const std::string& because,
                       const std::string& otherwise, SourceLocation where = kNowhere) {
    plan.items.push_back({group, name, needed, needed ? "needed because " + because : "left out: " + otherwise,
                          needed ? where : kNowhere});
  };
  const int method = antialiasing.method;
  const bool driven = antialiasing.error_driven();
  add("buffers", "film", true, "every picture is collected in one", "");
  add("buffers", "estimated errors", driven || estimate_error,
      driven ? "antialiasing follows them" : "--stats asks for them", "neither +AM3 nor --stats");
  add("buffers", "corner samples", driven, "antialiasing begins from them", "not +AM3");
  add("buffers", "patterns found", driven, "antialiasing looks again at the pixels around", "not +AM3");

  add("passes", "antialiasing", method != 0, "the options ask for method " + std::to_string(method),
      "one sample a pixel");
  add("passes", "further passes", driven, "antialiasing needs the pixels around each", "pixels are finished in one pass");

  const bool blur = FocalBlur::wanted(scene.camera);
  const bool jitter = antialiasing.moves_samples();
  add("tables", "lens positions", blur, "the camera has an aperture", "the camera is a pinhole", scene.camera.where);
  add("tables", "jitter", jitter || blur, jitter ? "antialiasing moves its samples" : "the camera has an aperture",
      "no sample is moved");
  add("tables", "coded colours", driven || estimate_error, "errors are estimated as they are seen", "neither +AM3 nor --stats");
  add("tables", "Sobol cells", driven, "antialiasing divides pixels into them", "not +AM3");
}

}  // namespace lute
