#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/error.h"
#include "distributed/channel.h"

namespace lapidary::distributed {

/// Numbers as this machine has them in memory: all ranks are of one kind.
template <typename Number>
concept Plain = std::is_arithmetic_v<Number> || std::is_enum_v<Number>;

/// Writes numbers and texts one behind the other.
class ByteWriter {
 public:
  template <Plain Number>
  void add(Number number) {
    append(std::as_bytes(std::span(&number, 1)));
  }
  void add(std::string_view text) { add_bytes(std::as_bytes(std::span(text))); }
  /// With their number before them.
  void add_bytes(std::span<const std::byte> bytes) {
    add(static_cast<std::uint64_t>(bytes.size()));
    append(bytes);
  }
  void append(std::span<const std::byte> bytes) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + bytes.size());
    std::ranges::copy(bytes, bytes_.begin() + static_cast<std::ptrdiff_t>(before));
  }

  /// What was written so far, for those who write by themselves.
  Bytes& bytes() { return bytes_; }
  Message message(Topic topic) && {
    return {topic, std::make_shared<const Bytes>(std::move(bytes_))};
  }

 private:
  Bytes bytes_;
};

/// Reads what a ByteWriter wrote. Throws Error where that ends early.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <Plain Number>
  Number take() {
    Number number{};
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
    return number;
  }
  std::string take_text() {
    const auto bytes = take_bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::span<const std::byte> take_bytes() { return take(take<std::uint64_t>()); }
  std::span<const std::byte> take(std::uint64_t count) {
    if (count > rest_.size()) fail();
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

  std::span<const std::byte> rest() const { return rest_; }
  [[noreturn]] static void fail() {
    throw Error({}, "a message from another rank is broken",
                "do all of them run the same build of Lapidary?");
  }

 private:
  std::span<const std::byte> rest_;
};

}  // namespace lapidary::distributed
