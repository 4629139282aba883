#include "parser/statement/image.hpp"
#include "parser/statement/simple_shape.hpp"

namespace lute {
namespace {

std::shared_ptr<const HeightGrid> height_grid(const Image& image) {
  auto grid = std::make_shared<HeightGrid>();
  grid->width = image.width();
  grid->depth = image.height();
  grid->heights.reserve(static_cast<std::size_t>(grid->width) * static_cast<std::size_t>(grid->depth));
  for (int z = 0; z < grid->depth; ++z)
    for (int x = 0; x < grid->width; ++x) grid->heights.push_back(image.height_at(x, grid->depth - 1 - z));
  return grid;
}

}  // namespace

HeightField parse_height_field(Reader& reader) {
  HeightField field;
  const ImagePtr image = parse_image(reader, ImageUse::kHeights);
  if (image->width() < 2 || image->height() < 2) reader.error("A height field needs an image of at least 2 by 2 pixels.");
  field.grid = height_grid(*image);
  while (true) {
    if (reader.accept(Word::kSmooth)) {
      field.smooth = true;
    } else if (reader.accept(Word::kWaterLevel)) {
      field.water_level = reader.number();
      if (reader.version() < 200) field.water_level /= 256;
    } else {
      break;
    }
  }
  return field;
}

}  // namespace lute
