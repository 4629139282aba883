#include "parser/statement/material_map.hpp"

#include "parser/statement/image.hpp"
#include "parser/statement/texture.hpp"

namespace lute {

void parse_material_map(Reader& reader, Texture& texture) {
  reader.open(Word::kMaterialMap);
  MaterialMap pattern;
  pattern.mapping.image = parse_image(reader, ImageUse::kValues);
  while (accept_mapping_item(reader, pattern.mapping, false)) {
  }
  PatternedTexture patterned;
  if (!reader.at(Word::kTexture)) reader.expect(Word::kTexture);
  while (reader.accept(Word::kTexture)) {
    const auto position = static_cast<float>(patterned.map.entries.size());
    patterned.map.entries.push_back({position, parse_texture(reader)});
  }
  reader.close(Word::kMaterialMap);
  pattern.texture_count = static_cast<int>(patterned.map.entries.size());
  patterned.body.frequency = MaterialMap::kFrequency;
  patterned.body.pattern = AnyPattern(std::move(pattern));
  texture.content = std::move(patterned);
}

}  // namespace lute
