// Reading image files for textures and height fields, each once (specification chapter 30 §7.9).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "engine/image/gamma_curve.hpp"
#include "engine/image/image.hpp"

namespace lute {

struct ImageFileOptions {
  std::string type;                       // "png", "jpeg", ... as the keyword says; empty: the extension decides
  bool for_colors = false;                // image_map: decode to the working space. Others: values as stored
  std::optional<GammaCurve> file_gamma;   // `gamma` after the file name: overrides the file, in every use
  std::optional<bool> premultiplied;      // `premultiplied` after the file name
  std::optional<GammaCurve> working;      // working space of the scene; nothing: no gamma handling
  bool legacy = false;                    // assumed_gamma was given and #version < 3.7: files without a curve are taken as they are

  friend auto operator<=>(const ImageFileOptions&, const ImageFileOptions&) = default;
};

// The types that a file name's extension stands for; empty: none.
std::string image_type_of(const std::string& path);

class ImageFiles {
 public:
  // Null, with `error` set, when the file cannot be read.
  ImagePtr load(const std::string& path, const ImageFileOptions& options, std::string& error);

 private:
  std::map<std::pair<std::string, ImageFileOptions>, ImagePtr> loaded_;
};

}  // namespace lute
