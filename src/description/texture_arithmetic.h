#pragma once

#include "schema/call_site.h"
#include "schema/node_kind.h"
#include "schema/value.h"
#include "texture/arithmetic.h"

namespace lapidary::description {

bool is_texture(const schema::Value& value);

/// What the operators of the scene language make where one of both is a texture; the other may be
/// one, a number or a colour. Throws Error at `where` when it is something else.
schema::Node reckon(texture::Arithmetic::Operation operation, const schema::Value& left,
                    const schema::Value& right, const schema::CallSite& where);
/// What -texture makes.
schema::Node negative(const schema::Value& value, const schema::CallSite& where);

/// The operators, for help.
std::vector<schema::NodeInfo> texture_operator_infos();

/// mix, min, max, power, clamp, invert, ramp, luminance, channel.
std::vector<schema::NodeKind> arithmetic_kinds();

}  // namespace lapidary::description
