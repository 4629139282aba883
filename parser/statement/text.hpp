// text { ttf "font" | internal n  "string", depth, offset } (specification chapters 11 §7 and 21 §10).
#pragma once

#include "engine/shape/text.hpp"
#include "parser/reader.hpp"

namespace lute {

Text parse_text(Reader& reader);

}  // namespace lute
