#include "render/origin.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace lapidary::render {
namespace {

constexpr std::array<std::string_view, 4> free_to_change = {"samples", "time", "noise", "tone"};

/// In one line, as sha256sum writes file names.
std::string escaped(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\\' || c == '\n' || c == '\r') line += '\\';
    line += c == '\n' ? 'n' : c == '\r' ? 'r' : c;
  }
  return line;
}

std::string unescaped(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_escape = line[i] == '\\' && i + 1 < line.size();
    const char c = is_escape ? line[++i] : line[i];
    text += !is_escape ? c : c == 'n' ? '\n' : c == 'r' ? '\r' : c;
  }
  return text;
}

template <typename Take>
void for_each_line(std::string_view lines, const Take& take) {
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    take(lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
}

/// What a name stands for in one list and in the other.
struct Texts {
  std::optional<std::string> then, now;

  std::string change() const {
    const auto shown = [](const std::optional<std::string>& text) {
      return !text || text->empty() ? "none" : *text;
    };
    return fmt::format("{}, now {}", shown(then), shown(now));
  }
};

/// What differs. Of a name that is there twice all texts count.
std::map<std::string, Texts> changed(const NamedTexts& then, const NamedTexts& now) {
  std::map<std::string, Texts> both;
  const auto add = [](std::optional<std::string>& all, const std::string& text) {
    all = all ? *all + "\n" + text : text;
  };
  for (const auto& [name, text] : then) add(both[name].then, text);
  for (const auto& [name, text] : now) add(both[name].now, text);
  std::erase_if(both, [](const auto& entry) { return entry.second.then == entry.second.now; });
  return both;
}

}  // namespace

std::pair<description::RenderSettings, description::FilmSettings> settings_of(
    const Origin& origin) {
  std::pair<description::RenderSettings, description::FilmSettings> settings;
  for (const auto& [name, text] : origin.settings) {
    if (!text.empty()) description::apply_override(settings.first, settings.second, name, text);
  }
  return settings;
}

std::vector<std::string> differences(const Origin& then, const Origin& now) {
  std::vector<std::string> all;
  if (then.version != now.version) {
    all.push_back(fmt::format("Lapidary {}, now {}", then.version, now.version));
  }
  for (const auto& [name, texts] : changed(then.settings, now.settings)) {
    const bool counts = std::ranges::find(free_to_change, name) == free_to_change.end();
    if (counts) all.push_back(fmt::format("setting {}: {}", name, texts.change()));
  }
  for (const auto& [name, texts] : changed(then.parameters, now.parameters)) {
    all.push_back(fmt::format("parameter {}: {}", name, texts.change()));
  }
  NamedTexts files_then, files_now;
  for (const FileRecord& file : then.files) files_then.emplace_back(file.name, file.sha256);
  for (const FileRecord& file : now.files) files_now.emplace_back(file.name, file.sha256);
  for (const auto& [name, digests] : changed(files_then, files_now)) {
    all.push_back(fmt::format("file {}: {}", name,
                              !digests.then  ? "was not read then"
                              : !digests.now ? "is not read now"
                                             : "has other content now"));
  }
  return all;
}

std::string to_lines(const NamedTexts& texts) {
  std::string lines;
  for (const auto& [name, text] : texts) {
    lines += fmt::format("{} = {}\n", escaped(name), escaped(text));
  }
  return lines;
}

NamedTexts parse_lines(std::string_view lines) {
  constexpr std::string_view between = " = ";
  NamedTexts texts;
  for_each_line(lines, [&](std::string_view line) {
    const std::size_t at = std::min(line.find(between), line.size());
    const std::size_t text = std::min(at + between.size(), line.size());
    texts.emplace_back(unescaped(line.substr(0, at)), unescaped(line.substr(text)));
  });
  return texts;
}

std::string to_lines(std::span<const FileRecord> files) {
  std::string lines;
  for (const FileRecord& file : files) {
    const std::string name = escaped(file.name);
    lines += fmt::format("{}{}  {}\n", name == file.name ? "" : "\\", file.sha256, name);
  }
  return lines;
}

std::vector<FileRecord> parse_file_lines(std::string_view lines) {
  std::vector<FileRecord> files;
  for_each_line(lines, [&](std::string_view line) {
    const bool is_escaped = line.starts_with('\\');
    if (is_escaped) line.remove_prefix(1);
    const std::size_t at = std::min(line.find("  "), line.size());
    const std::string_view name = line.substr(std::min(at + 2, line.size()));
    files.push_back(
        {is_escaped ? unescaped(name) : std::string(name), std::string(line.substr(0, at))});
  });
  return files;
}

}  // namespace lapidary::render
