// PPM and PGM files (netpbm), as numbers or as bytes, with any maximum value up to 65535.
//
// The library of formats is not asked: it brings values of files whose maximum is not 255 to codes that are too low, by one of 65536 or, where
// the maximum is below, by up to half of one of 256. The reference takes the nearest of 65536 codes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lute {

struct PnmContent {
  int width = 0, height = 0;
  int channels = 3;                  // 1: grey (PGM), 3: colours (PPM)
  bool deep = false;                 // the maximum is not 255
  std::vector<std::uint8_t> bytes;   // of files that are not deep
  std::vector<std::uint16_t> words;  // of deep files: 65535 stands for the maximum
};

// `type` is "ppm" or "pgm": a file of the other kind, or of another format, is refused, as the reference refuses it. False, with `error`
// set, when the file cannot be read. Values above the maximum are taken as the maximum.
bool read_pnm(const std::string& path, const std::string& type, PnmContent& content, std::string& error);

}  // namespace lute
