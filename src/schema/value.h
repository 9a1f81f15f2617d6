#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <span>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>

namespace lapidary::schema {

/// A finished node as the language carries it around: shared, immutable, of any type.
struct Node {
  std::string_view kind;  ///< what constructed it, e.g. "sphere"; outlives the node
  std::shared_ptr<const void> data;
  const std::type_info* type = nullptr;
  std::size_t bytes = 0;  ///< of memory it holds, about

  template <typename T>
  static Node of(std::string_view kind, std::shared_ptr<const T> data, std::size_t bytes) {
    return {kind, std::move(data), &typeid(T), bytes};
  }
  /// Null when the node is something else.
  template <typename T>
  std::shared_ptr<const T> as() const {
    if (!type || *type != typeid(T)) return nullptr;
    return std::static_pointer_cast<const T>(data);
  }
};

enum class ValueKind : unsigned char { nil, boolean, number, string, table, node, other };

struct Table;

/// What a user wrote for a parameter, before anyone knows what it should be. A view: the text,
/// tables and nodes it refers to live elsewhere, usually in a ValueArena.
class Value {
 public:
  Value() : kind_(ValueKind::nil), number_(0) {}
  explicit Value(bool b) : kind_(ValueKind::boolean), boolean_(b) {}
  explicit Value(double x) : kind_(ValueKind::number), number_(x) {}
  explicit Value(std::string_view s) : kind_(ValueKind::string), text_(s) {}
  explicit Value(const char*) = delete;  // would be taken for a bool
  explicit Value(const Table& table) : kind_(ValueKind::table), table_(&table) {}
  explicit Value(const Node& node) : kind_(ValueKind::node), node_(&node) {}
  /// Something no parameter takes, such as a function; `what` names it: "a function".
  static Value other(std::string_view what) {
    Value value(what);
    value.kind_ = ValueKind::other;
    return value;
  }

  ValueKind kind() const { return kind_; }
  bool is_nil() const { return kind_ == ValueKind::nil; }

  // Each of these needs the kind it names.
  bool boolean() const { return boolean_; }
  double number() const { return number_; }
  std::string_view string() const { return text_; }
  const Table& table() const { return *table_; }
  const Node& node() const { return *node_; }

  /// For messages: "the number 3", "the string 'red'", "a sphere".
  std::string describe() const;

 private:
  ValueKind kind_;
  union {
    bool boolean_;
    double number_;
    std::string_view text_;
    const Table* table_;
    const Node* node_;
  };
};

struct Field {
  std::string_view key;
  Value value;
};

/// {a, b, key = c}: values by position and values by name.
struct Table {
  std::span<const Value> items;
  std::span<const Field> fields;  ///< in ascending order of keys
};

/// "a sphere", "an intersection", "a union".
std::string with_article(std::string_view noun);

/// Where the parts of values live; what it gave out dies with it or with `clear`.
class ValueArena {
 public:
  ValueArena() = default;
  ValueArena(const ValueArena&) = delete;
  ValueArena& operator=(const ValueArena&) = delete;

  /// `count` default-constructed objects that need no destructor.
  template <typename T>
  std::span<T> array(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    if (count == 0) return {};
    T* first = static_cast<T*>(memory_.allocate(count * sizeof(T), alignof(T)));
    std::uninitialized_default_construct_n(first, count);
    return {first, count};
  }
  Value table(std::span<const Value> items, std::span<const Field> fields);
  std::string_view text(std::string_view s);
  void clear() { memory_.release(); }

 private:
  alignas(std::max_align_t) std::byte first_[8192];  // enough for almost every call
  std::pmr::monotonic_buffer_resource memory_{first_, sizeof first_};
};

}  // namespace lapidary::schema
