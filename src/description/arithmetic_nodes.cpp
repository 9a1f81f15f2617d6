#include "description/texture_arithmetic.h"
#include "description/texture_parameters.h"

namespace lapidary::schema {

template <>
struct EnumNames<texture::ChannelOf::Channel> {
  using Channel = texture::ChannelOf::Channel;
  static constexpr std::array<std::pair<std::string_view, Channel>, 3> names{
      {{"red", Channel::red}, {"green", Channel::green}, {"blue", Channel::blue}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Shorthand;
using schema::Value;
using schema::ValueKind;
using texture::Arithmetic;
using texture::Operand;
using Operation = Arithmetic::Operation;

constexpr auto section = "textures";

/// What a function is called with, which is one value or a list.
std::span<const Value> arguments(const Value& value) {
  const bool list = value.kind() == ValueKind::table && value.table().fields.empty();
  return list ? value.table().items : std::span<const Value>(&value, 1);
}

/// Fails unless there are `count` of them, called `names`.
std::span<const Value> arguments(const Value& value, std::size_t count, std::string_view names,
                                 const Context& context) {
  const auto all = arguments(value);
  if (all.size() == count) return all;
  throw context.error(fmt::format("{} takes {}", context.call().node, names));
}

/// A function that is called as `name(a, b, ...)`.
template <typename Make>
NodeKind function(std::string name, std::string doc, std::vector<std::string> examples, Make make) {
  schema::NodeInfo info{.name = std::move(name),
                        .doc = std::move(doc),
                        .section = section,
                        .examples = std::move(examples),
                        .form = schema::Form::other,
                        .parameters = {}};
  return {std::move(info), [make](const Value& argument, const schema::Call& call) {
            return make(argument, Context(call));
          }};
}

NodeKind of_two(Operation operation, std::string name, std::string doc, std::string example) {
  return function(std::move(name), std::move(doc), {std::move(example)},
                  [operation](const Value& value, const Context& context) {
                    const auto parts =
                        arguments(value, 2, "two textures, numbers or colors", context);
                    return texture_node(Arithmetic{operation,
                                                   {OperandReader::read(parts[0], context.at(0)),
                                                    OperandReader::read(parts[1], context.at(1))}},
                                        context);
                  });
}

NodeKind mix() {
  return function("mix", "Two textures or colors mixed: mix(a, b, share of b).",
                  {"mix(\"white\", checker {}, 0.3)", "mix(wood {}, bricks {}, noise {})"},
                  [](const Value& value, const Context& context) {
                    const auto parts = arguments(
                        value, 3, "two textures, numbers or colors, and the share of the second",
                        context);
                    const Context share = context.at("share", schema::unit_interval);
                    return texture_node(texture::Mix{{OperandReader::read(parts[0], context.at(0)),
                                                      OperandReader::read(parts[1], context.at(1))},
                                                     NumberReader::read(parts[2], share)},
                                        context);
                  });
}

NodeKind clamp() {
  return function(
      "clamp", "A texture held between two numbers: clamp(texture, from, to); 0 and 1 if left out.",
      {"clamp(noise {} * 3 - 1)", "clamp(fbm {}, 0.2, 0.6)"},
      [](const Value& value, const Context& context) {
        const auto all = arguments(value);
        const auto parts =
            all.size() == 1 ? all : arguments(value, 3, "a texture and two numbers", context);
        const double low =
            parts.size() == 3 ? schema::Reader<double>::read(parts[1], context.at(1)) : 0.0;
        const double high =
            parts.size() == 3 ? schema::Reader<double>::read(parts[2], context.at(2)) : 1.0;
        if (low > high) throw context.error("clamp takes the lower number before the higher one");
        const Arithmetic above{Operation::maximum,
                               {OperandReader::read(parts[0], context.at(0)), low}};
        const auto floor = std::make_shared<const texture::Texture>(above);
        return texture_node(Arithmetic{Operation::minimum, {texture::Color(floor), high}}, context);
      });
}

NodeKind invert() {
  return function("invert", "1 minus a texture.", {"invert(checker {})"},
                  [](const Value& value, const Context& context) {
                    const auto parts = arguments(value, 1, "a texture", context);
                    return texture_node(Arithmetic{Operation::subtract,
                                                   {1.0, OperandReader::read(parts[0], context)}},
                                        context);
                  });
}

NodeKind luminance() {
  return function("luminance", "How bright the colors of a texture are, as numbers.",
                  {"luminance(wood {})"}, [](const Value& value, const Context& context) {
                    const auto parts = arguments(value, 1, "a texture", context);
                    return texture_node(texture::ChannelOf{ColorReader::read(parts[0], context)},
                                        context);
                  });
}

NodeKind channel() {
  using Channel = texture::ChannelOf::Channel;
  return function("channel", "A channel of the colors of a texture, as numbers.",
                  {"channel(wood {}, \"red\")"}, [](const Value& value, const Context& context) {
                    const auto parts = arguments(
                        value, 2, "a texture and \"red\", \"green\" or \"blue\"", context);
                    return texture_node(
                        texture::ChannelOf{ColorReader::read(parts[0], context.at(0)),
                                           schema::Reader<Channel>::read(parts[1], context.at(1))},
                        context);
                  });
}

NodeKind ramp() {
  using texture::Remap;
  Declaration<Remap> d({.name = "ramp",
                        .doc = "Colors for the numbers of a texture, or these spread to 0 to 1.",
                        .section = section,
                        .examples = {"ramp { fbm {}, colors = { \"black\", \"red\", \"yellow\" } }",
                                     "ramp { noise {}, from = 0.4, to = 0.6 }"}});
  d.parameter<NumberReader>(
       "input", &Remap::input,
       {.doc = "The texture.", .need = schema::Need::required, .shorthand = Shorthand::yes})
      .parameter("from", &Remap::from, {.doc = "The number that is 0 on the ramp."})
      .parameter("to", &Remap::to, {.doc = "The number that is 1 on the ramp."})
      .parameter<RampReader>("colors", &Remap::colors,
                             {.doc = "From 0 to 1; greys when left out."});
  return node_kind(std::move(d), [](Remap&& r, const Context& context) {
    if (r.from == r.to) context.at("to").fail("must differ from 'from'");
    return texture_node(std::move(r), context);
  });
}

}  // namespace

std::vector<NodeKind> arithmetic_kinds() {
  return {
      mix(),
      ramp(),
      clamp(),
      of_two(Operation::minimum, "min", "The lesser of two textures, numbers or colors.",
             "min(noise {}, 0.5)"),
      of_two(Operation::maximum, "max", "The greater of two textures, numbers or colors.",
             "max(noise {}, checker {})"),
      of_two(Operation::power, "power",
             "A texture to the power of a number; of what is below 0, 0.", "power(noise {}, 2)"),
      invert(),
      luminance(),
      channel()};
}

}  // namespace lapidary::description
