#include "lua/source_files.h"

#include <charconv>

#include <fmt/format.h>

namespace lapidary::lua {

std::string SourceFiles::add(const std::string& file) {
  // Longer names would be cut in messages, and then two files could look the same.
  constexpr std::size_t longest = LUA_IDSIZE - 8;
  std::string chunk = file;
  if (chunk.size() > longest || chunk.find('\n') != std::string::npos) {
    const std::size_t slash = file.find_last_of('/');
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    chunk = fmt::format("{}~{}", sources_.size() + 1, name.substr(0, longest - 8));
  }
  sources_.push_back({chunk, std::make_shared<const std::string>(file)});
  return "=" + chunk;
}

std::shared_ptr<const std::string> SourceFiles::find(std::string_view chunk) const {
  if (chunk.starts_with('=')) chunk.remove_prefix(1);
  for (const Source& source : sources_) {
    if (source.chunk == chunk) return source.file;
  }
  return nullptr;
}

Location SourceFiles::location(const lua_Debug& ar) const {
  const auto file = find(ar.source);
  return {.file = file ? *file : "", .line = ar.currentline > 0 ? ar.currentline : 0};
}

std::pair<Location, std::string_view> SourceFiles::split_message(std::string_view message) const {
  for (const Source& source : sources_) {
    if (!message.starts_with(source.chunk)) continue;
    std::string_view rest = message.substr(source.chunk.size());
    if (!rest.starts_with(':')) continue;
    rest.remove_prefix(1);
    int line = 0;
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), line);
    if (problem != std::errc()) continue;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (!rest.starts_with(": ")) continue;
    return {Location{.file = *source.file, .line = line}, rest.substr(2)};
  }
  return {Location{}, message};
}

}  // namespace lapidary::lua
