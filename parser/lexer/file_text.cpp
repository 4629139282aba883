#include "parser/lexer/file_text.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <utility>

namespace lute {

namespace {

constexpr std::size_t kMapped = 8u << 20;  // from this size on

std::optional<std::string> read(const std::string& path, std::size_t size) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::string text(size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

const char* map(const std::string& path, std::size_t size) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return nullptr;
  void* const memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  if (memory == MAP_FAILED) return nullptr;
  madvise(memory, size, MADV_SEQUENTIAL);
  return static_cast<const char*>(memory);
}

}  // namespace

FileText::~FileText() {
  if (map_ != nullptr) munmap(const_cast<char*>(map_), size_);
}

FileText::FileText(FileText&& other) noexcept
    : text_(std::move(other.text_)), map_(std::exchange(other.map_, nullptr)), size_(std::exchange(other.size_, 0)) {}

FileText& FileText::operator=(FileText&& other) noexcept {
  std::swap(text_, other.text_);
  std::swap(map_, other.map_);
  std::swap(size_, other.size_);
  return *this;
}

std::optional<FileText> FileText::of_file(const std::string& path, std::size_t size) {
  if (size >= kMapped) {
    FileText text;
    text.map_ = map(path, size);
    text.size_ = size;
    if (text.map_ != nullptr) return text;
  }
  auto content = read(path, size);
  if (!content) return std::nullopt;
  return FileText(std::move(*content));
}

void FileText::release(std::size_t begin, std::size_t end) const {
  if (map_ == nullptr) return;
  const auto page = static_cast<std::size_t>(std::max(sysconf(_SC_PAGESIZE), 4096L));
  begin = (begin + page - 1) / page * page;
  end = std::min(end, size_) / page * page;
  if (begin < end) madvise(const_cast<char*>(map_) + begin, end - begin, MADV_DONTNEED);
}

}  // namespace lute
