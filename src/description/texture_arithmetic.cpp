#include "description/texture_arithmetic.h"

#include <fmt/format.h>

#include "description/color_readers.h"
#include "description/texture_parameters.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Value;
using schema::ValueKind;
using texture::Arithmetic;
using texture::Operand;
using Operation = Arithmetic::Operation;

std::string failure(Operation operation, const Value& left, const Value& right) {
  const std::string a = left.describe(), b = right.describe();
  switch (operation) {
    case Operation::subtract:
      return fmt::format("cannot subtract {} from {}", b, a);
    case Operation::multiply:
      return fmt::format("cannot multiply {} by {}", a, b);
    case Operation::divide:
      return fmt::format("cannot divide {} by {}", a, b);
    case Operation::power:
      return fmt::format("cannot raise {} to {}", a, b);
    case Operation::add:
    case Operation::minimum:
    case Operation::maximum:
      break;
  }
  return fmt::format("cannot add {} and {}", a, b);
}

bool may_be_operand(const Value& value) {
  return is_texture(value) || value.kind() == ValueKind::number ||
         value.kind() == ValueKind::string || value.kind() == ValueKind::table ||
         schema::node_as<Spectrum>(value) != nullptr;
}

schema::NodeInfo info(std::string name, std::string doc, std::string example) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .section = "textures",
          .examples = {std::move(example)},
          .form = schema::Form::other,
          .parameters = {}};
}

}  // namespace

bool is_texture(const Value& value) {
  return schema::node_as<texture::Texture>(value) != nullptr;
}

schema::Node reckon(Operation operation, const Value& left, const Value& right,
                    const schema::CallSite& where) {
  if (!may_be_operand(left) || !may_be_operand(right)) {
    throw Error(where.location(), failure(operation, left, right),
                "textures are reckoned with among themselves, and with numbers and colors");
  }
  const schema::Call call{"texture", where};
  const Context context(call);
  return texture_node(Arithmetic{operation,
                                 {OperandReader::read(left, context.at("left side")),
                                  OperandReader::read(right, context.at("right side"))}},
                      context);
}

schema::Node negative(const Value& value, const schema::CallSite& where) {
  return reckon(Operation::multiply, value, Value(-1.0), where);
}

std::vector<schema::NodeInfo> texture_operator_infos() {
  return {
      info("s + t", "Of textures, numbers and colors: both added. Also s - t and -t.",
           "checker {} + noise {} * 0.1"),
      info("s * t",
           "Of textures, numbers and colors: multiplied; s / t, where division by 0 makes "
           "0; s ^ t.",
           "checker { \"white\", \"gray\" } * (0.5 + 0.5 * fbm {})"),
  };
}

}  // namespace lapidary::description
