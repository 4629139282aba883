// global_settings { ... } (specification chapter 11 §3).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword.
void parse_global_settings(Reader& reader);

// `max_trace_level n`, also legal at top level: the keyword was taken.
void parse_max_trace_level(Reader& reader);

// radiosity { ... } and photons { ... } inside of it, `{ ... }` after the keyword: checked, without effect so far.
void parse_global_radiosity(Reader& reader);
void parse_global_photons(Reader& reader);

}  // namespace lute
