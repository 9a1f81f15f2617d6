#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/vec.h"
#include "schema/context.h"
#include "schema/suggest.h"
#include "schema/value.h"

namespace lapidary::schema {

/// How a parameter of type T is read and shown. A specialisation has
///
///   static std::string type();                           for help: "number"
///   static T read(const Value&, const Context&);         fails through the context
///   static std::string text(const T&);                   a default, as a scene would write it
///
/// A type that can be written in several ways (a colour) gets several readers, named at the
/// parameter; see Declaration::parameter.
template <typename T>
struct Reader;

/// "must be WANTED, not SHOWN"; a hint that the value itself calls for comes before `hint`.
[[noreturn]] void fail_type(std::string_view wanted, const Value& value, const Context& context,
                            std::string_view hint = "");

template <>
struct Reader<double> {
  static std::string type() { return "number"; }
  static double read(const Value& value, const Context& context);
  static std::string text(double x);
};

/// A whole number of magnitude up to 2^53, within the context's range.
std::int64_t read_whole(const Value& value, const Context& context);

template <typename T>
requires std::is_integral_v<T> &&(!std::is_same_v<T, bool>)struct Reader<T> {
  static std::string type() { return "whole number"; }
  static T read(const Value& value, const Context& context) {
    const std::int64_t x = read_whole(value, context);
    if (!std::in_range<T>(x)) context.fail("is a number too large or too small");
    return static_cast<T>(x);
  }
  static std::string text(T x) { return std::to_string(x); }
};

template <>
struct Reader<bool> {
  static std::string type() { return "true or false"; }
  static bool read(const Value& value, const Context& context);
  static std::string text(bool b) { return b ? "true" : "false"; }
};

template <>
struct Reader<std::string> {
  static std::string type() { return "string"; }
  static std::string read(const Value& value, const Context& context);
  static std::string text(const std::string& s) { return s.empty() ? "" : '"' + s + '"'; }
};

/// {x, y, z}, or by name with the rest 0: {z = 1}.
template <>
struct Reader<Vec3d> {
  static std::string type() { return "{x, y, z}"; }
  static Vec3d read(const Value& value, const Context& context);
  static std::string text(const Vec3d& v);
};
/// Reads a vector whose components, when only some are named, are otherwise those of `rest`.
Vec3d read_vector(const Value& value, const Context& context, Vec3d rest);

/// {u, v}.
template <>
struct Reader<Vec2d> {
  static std::string type() { return "{u, v}"; }
  static Vec2d read(const Value& value, const Context& context);
  static std::string text(const Vec2d& v);
};

/// A file that the scene may read.
struct InputFile {
  std::filesystem::path path;
};
template <>
struct Reader<InputFile> {
  static std::string type() { return "file"; }
  static InputFile read(const Value& value, const Context& context);
  static std::string text(const InputFile& file) { return file.path.string(); }
};

template <typename T>
struct Reader<std::optional<T>> {
  static std::string type() { return Reader<T>::type(); }
  static std::optional<T> read(const Value& value, const Context& context) {
    return Reader<T>::read(value, context);
  }
  static std::string text(const std::optional<T>& x) { return x ? Reader<T>::text(*x) : ""; }
};

/// A list; one value that is no list stands for a list of one.
template <typename T>
struct Reader<std::vector<T>> {
  static std::string type() { return "list of " + plural(Reader<T>::type()); }
  static std::vector<T> read(const Value& value, const Context& context) {
    if (value.kind() != ValueKind::table) return {Reader<T>::read(value, context)};
    if (!value.table().fields.empty()) fail_type("a list", value, context);
    std::vector<T> list;
    list.reserve(value.table().items.size());
    for (std::size_t i = 0; i < value.table().items.size(); ++i) {
      list.push_back(Reader<T>::read(value.table().items[i], context.at(i)));
    }
    return list;
  }
  static std::string text(const std::vector<T>&) { return ""; }
};

/// The words a scene uses for an enum: specialise with
/// `static constexpr std::array<std::pair<std::string_view, E>, N> names`.
template <typename E>
struct EnumNames;

/// The index of the word that `value` is; fails with the list of words and a suggestion.
std::size_t read_word(const Value& value, std::span<const std::string_view> words,
                      const Context& context);

template <typename E>
requires std::is_enum_v<E>
struct Reader<E> {
  static constexpr auto words = [] {
    std::array<std::string_view, EnumNames<E>::names.size()> only{};
    for (std::size_t i = 0; i < only.size(); ++i) only[i] = EnumNames<E>::names[i].first;
    return only;
  }();

  static std::string type() { return join_or_quoted(words); }
  static E read(const Value& value, const Context& context) {
    return EnumNames<E>::names[read_word(value, words, context)].second;
  }
  static std::string text(E e) {
    for (const auto& [word, named] : EnumNames<E>::names) {
      if (named == e) return '"' + std::string(word) + '"';
    }
    return "";
  }
};

}  // namespace lapidary::schema
