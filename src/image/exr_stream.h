#pragma once

// Inside image/ only: OpenEXR on our files.

#include <cstring>
#include <exception>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfIO.h>

#include "image/codecs.h"

namespace lapidary::image {

/// Bytes in memory.
class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(const Source& source)
      : Imf::IStream(source.file.c_str()), bytes_(source.bytes) {}

  bool read(char data[], int size) override {
    if (size < 0 || static_cast<std::uint64_t>(size) > bytes_.size() - position_) {
      throw Iex::InputExc("it ends early");
    }
    std::memcpy(data, bytes_.data() + position_, static_cast<std::size_t>(size));
    position_ += static_cast<std::uint64_t>(size);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override {
    if (position > bytes_.size()) throw Iex::InputExc("it ends early");
    position_ = position;
  }

 private:
  std::span<const std::byte> bytes_;
  std::uint64_t position_ = 0;
};

/// An OutputFile. OpenEXR writes the offset table from a destructor and swallows what goes wrong
/// there, so failures are kept.
class FileStream : public Imf::OStream {
 public:
  explicit FileStream(OutputFile& out) : Imf::OStream(out.path().c_str()), out_(out) {}

  void write(const char data[], int size) override {
    guarded([&] { out_.write(data, static_cast<std::size_t>(size)); });
  }
  std::uint64_t tellp() override { return out_.position(); }
  void seekp(std::uint64_t position) override {
    guarded([&] { out_.seek(position); });
  }

  /// Throws the first failure, if there was one.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <typename Action>
  void guarded(const Action& action) {
    try {
      action();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      throw;
    }
  }

  OutputFile& out_;
  std::exception_ptr failure_;
};

}  // namespace lapidary::image
