#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lapidary::schema {

/// The candidate a user most likely meant by `word`: the nearest by insertions, deletions,
/// replacements and swaps of neighbours, ignoring case; the first of equals. Empty when none is
/// near enough to be a misspelling.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "did you mean 'radius'?", or empty.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// "a, b or c".
std::string join_or(std::span<const std::string_view> words);
/// "\"a\", \"b\" or \"c\"".
std::string join_or_quoted(std::span<const std::string_view> words);

/// What several of `things` are called: "numbers", "lists of {x, y, z}".
std::string plural(const std::string& things);

}  // namespace lapidary::schema
