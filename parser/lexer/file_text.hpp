// The text of a file: small ones are read, large ones are mapped, so that only the part being looked at takes memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lute {

class FileText {
 public:
  FileText() = default;
  explicit FileText(std::string text) : text_(std::move(text)) {}
  ~FileText();
  FileText(FileText&& other) noexcept;
  FileText& operator=(FileText&& other) noexcept;

  // Nothing if the file cannot be opened or read. `size` is the file's.
  static std::optional<FileText> of_file(const std::string& path, std::size_t size);

  // Valid until this is moved or ends.
  std::string_view view() const { return map_ != nullptr ? std::string_view(map_, size_) : std::string_view(text_); }
  // Mapped: the text changes, and ends, with the file.
  bool follows_file() const { return map_ != nullptr; }
  // The bytes from `begin` to `end` are not needed for now: their memory is given back. They can still be read.
  void release(std::size_t begin, std::size_t end) const;

 private:
  std::string text_;
  const char* map_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace lute
