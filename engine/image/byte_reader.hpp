// The bytes of a file, read in order and never beyond the end.
// Errors: std::runtime_error whose text goes on after the file's name, "it cannot be opened", "it ends too early"; the image readers add
// the name. Positions and sizes are bytes.
#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace lute {

class ByteReader {
 public:
  // Throws std::runtime_error if the file cannot be opened.
  explicit ByteReader(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("it cannot be opened");
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }

  void seek(std::size_t offset) { at_ = offset; }
  std::size_t position() const { return at_; }
  bool at_end() const { return at_ >= bytes_.size(); }
  std::vector<std::uint8_t> bytes() const { return {bytes_.begin(), bytes_.end()}; }  // of the whole file

  // Each throws std::runtime_error at the end of the file.
  std::uint8_t byte() {
    if (at_ >= bytes_.size()) throw std::runtime_error("it ends too early");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  std::uint32_t little_endian(int size) {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(byte()) << (8 * i);
    return value;
  }

 private:
  std::vector<char> bytes_;
  std::size_t at_ = 0;
};

}  // namespace lute
