#include "schema/reader.h"

#include <cmath>

#include <fmt/format.h>

namespace lapidary::schema {

void fail_type(std::string_view wanted, const Value& value, const Context& context,
               std::string_view hint) {
  const bool uncalled = value.kind() == ValueKind::other && value.describe() == "a function";
  context.fail(fmt::format("must be {}, not {}", wanted, value.describe()),
               std::string(uncalled ? "call it: name { ... }" : hint));
}

double Reader<double>::read(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::number) fail_type("a number", value, context);
  const double x = value.number();
  if (!std::isfinite(x)) {
    context.fail(fmt::format("must be a finite number, not {}", x),
                 "a division by zero, or 0/0, gives such a number");
  }
  if (!context.range().contains(x)) {
    context.fail(fmt::format("must be {}, not {}", context.range().text(), x));
  }
  return x;
}

std::string Reader<double>::text(double x) {
  return fmt::format("{}", x);
}

std::int64_t read_whole(const Value& value, const Context& context) {
  const double x = Reader<double>::read(value, context);
  if (x != std::floor(x)) context.fail(fmt::format("must be a whole number, not {}", x));
  if (std::abs(x) > 0x1p53) context.fail(fmt::format("must be at most 2^53, not {}", x));
  return static_cast<std::int64_t>(x);
}

bool Reader<bool>::read(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::boolean) fail_type("true or false", value, context);
  return value.boolean();
}

std::string Reader<std::string>::read(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::string) fail_type("a string", value, context);
  return std::string(value.string());
}

Vec3d Reader<Vec3d>::read(const Value& value, const Context& context) {
  return read_vector(value, context, {});
}

std::string Reader<Vec3d>::text(const Vec3d& v) {
  return fmt::format("{{{}, {}, {}}}", v.x, v.y, v.z);
}

Vec3d read_vector(const Value& value, const Context& context, Vec3d rest) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  if (value.kind() != ValueKind::table) fail_type("{x, y, z}", value, context);
  const auto [items, fields] = value.table();
  if (fields.empty()) {
    if (items.size() != 3) {
      context.fail(fmt::format("must be three numbers {{x, y, z}}, not {}", value.describe()));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      rest[i] = Reader<double>::read(items[i], context.at(axes[i]));
    }
    return rest;
  }
  if (!items.empty()) context.fail("must be either {1, 2, 3} or {x = 1, y = 2, z = 3}, not both");
  for (const Field& field : fields) {
    const std::size_t axis = read_word(Value(field.key), axes, context);
    rest[axis] = Reader<double>::read(field.value, context.at(axes[axis]));
  }
  return rest;
}

Vec2d Reader<Vec2d>::read(const Value& value, const Context& context) {
  const bool pair = value.kind() == ValueKind::table && value.table().items.size() == 2 &&
                    value.table().fields.empty();
  if (!pair) fail_type("two numbers {u, v}", value, context);
  return {Reader<double>::read(value.table().items[0], context.at(0)),
          Reader<double>::read(value.table().items[1], context.at(1))};
}

std::string Reader<Vec2d>::text(const Vec2d& v) {
  return fmt::format("{{{}, {}}}", v.x, v.y);
}

InputFile Reader<InputFile>::read(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::string) {
    fail_type("the name of a file, in quotes", value, context);
  }
  if (value.string().empty()) context.fail("is an empty file name");
  const FileAccess* files = context.call().files;
  if (!files) context.fail("names a file, and no file can be read here");
  return {files->resolve(value.string(), context)};
}

std::size_t read_word(const Value& value, std::span<const std::string_view> words,
                      const Context& context) {
  if (value.kind() == ValueKind::string) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == value.string()) return i;
    }
  }
  std::string hint;
  if (value.kind() == ValueKind::string) hint = did_you_mean(value.string(), words);
  context.fail(fmt::format("must be {}{}, not {}", words.size() > 1 ? "one of " : "",
                           fmt::join(words, ", "), value.describe()),
               hint);
}

}  // namespace lapidary::schema
