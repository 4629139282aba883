// What a scene as a whole needs to be rendered, and why. It is made first: build and tracer read its decisions, and what is not
// needed is not built and not tested for at any ray. What differs from surface to surface or from light to light (colours in shadows,
// iridescence, areas of lights) is decided where that is built; the plan then only tells whether the scene has any.
// `lute --explain` prints the plan.
#pragma once

#include <string>
#include <vector>

#include "engine/plan/build_options.hpp"
#include "engine/plan/feature.hpp"
#include "engine/scene/scene.hpp"

namespace lute {

struct PlanItem {
  std::string group;     // "rays", "shading", "lights", "shapes", "patterns", "acceleration", "tables", "passes", "buffers"
  std::string name;
  bool needed = false;
  std::string reason;    // "needed because ..." or why it can be left out
  SourceLocation where;  // line 0: the reason has no place in the text
};

struct RenderPlan {
  BuildOptions options;  // those that the plan was made for

  bool lights = false;            // some light shines
  bool shadows = false;           // some light casts shadows and quality asks for them
  Feature<kTransmissionCompiled> transmission;  // some surface lets a ray pass
  Feature<kReflectionCompiled> reflection;
  Feature<kNormalsCompiled> normals;            // some normal pattern perturbs
  Feature<kHighlightsCompiled> highlights;      // phong or specular
  bool sky_sphere = false;
  Feature<kFogCompiled> fog;
  Feature<kFogCompiled> rainbow;
  bool uv_patterns = false;       // some texture asks for surface coordinates
  bool interiors = false;         // what a ray begins in matters: it may leave it, fade in it, or find fog
  Feature<kFogCompiled> volume_effects;  // fog, rainbow or media: rays have to know whether they are hollow

  std::vector<PlanItem> items;

  // One line an item, grouped: "shadow rays    needed because light_source casts shadows (scene.pov:12)".
  std::string text(const Scene& scene) const;
};

RenderPlan make_plan(const Scene& scene, const BuildOptions& options = {});

}  // namespace lute
