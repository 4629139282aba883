// Focal blur: the rays of a pixel leave from points on the lens and meet at the focal distance; as many are traced as
// the confidence test asks for.
//
// Active when the camera has an aperture and blur samples. The points on the lens are the same for the whole render,
// the jitter depends on the pixel alone. The lens replaces the origin of the camera type (an orthographic camera with a
// lens has one). Source: specification chapter 30 §4.
#pragma once

#include <functional>
#include <vector>

#include "engine/camera/projection.hpp"
#include "engine/image/color.hpp"

namespace lute {

class FocalBlur {
 public:
  // Light along a ray with unit direction.
  using TraceRay = std::function<Color(const Ray&)>;
  // Gives the unnormalised ray of an image position; false: none there.
  using ProjectRay = std::function<bool(dvec2, ProjectedRay&)>;
  // How much light the lens lets through at (x + 0.5, y + 0.5), 0...1: the grey of the camera's bokeh pigment.
  using LensBrightness = std::function<double(dvec2)>;

  static bool wanted(const Camera& camera) { return camera.aperture != 0 && camera.blur_samples_max > 0; }

  // `brightness` empty: a round lens.
  explicit FocalBlur(const Camera& camera, const LensBrightness& brightness = {});

  // The mean over the lens at an image position.
  Color sample(dvec2 position, const ProjectRay& project, const TraceRay& trace) const;

  const std::vector<dvec2>& lens_points() const { return points_; }  // on a disc of diameter 1

 private:
  void place_on_grid(int count);
  void place_by_brightness(int count, const LensBrightness& brightness);
  void set_thresholds(const Camera& camera);
  int batch_size(std::size_t batch) const;
  Ray through_lens(const ProjectedRay& ray, dvec2 position, int index) const;

  std::vector<dvec2> points_;
  std::vector<int> batches_;        // samples between confidence tests; 4 after the last
  std::vector<double> thresholds_;  // [n]: the variance below which n samples are enough
  double amplitude_;                // of the jitter on the lens
  double radius_, focal_distance_, direction_length_;
  dvec3 location_, across_, along_;  // axes of the lens, unit
  int minimum_;
};

// The radical inverse of `index` (from 1) in `base`.
double halton(int base, int index);

}  // namespace lute
