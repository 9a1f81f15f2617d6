#include "import/mtl.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "import/find_file.h"
#include "import/line_cursor.h"
#include "import/numbers.h"
#include "import/text_blocks.h"

namespace lapidary::import {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

bool is_number(const std::string& word) {
  const char* p = word.c_str();
  double value = 0;
  return parse_number(p, value) == NumberStatus::ok && *p == '\0';
}

std::optional<MtlChannel> texture_channel(std::string_view keyword) {
  using enum MtlChannel;
  static constexpr std::array<std::pair<std::string_view, MtlChannel>, 22> channels{{
      {"map_ka", ambient},      {"map_kd", diffuse},      {"map_ks", specular},
      {"map_ke", emission},     {"map_tf", transmission}, {"map_ns", shininess},
      {"map_d", dissolve},      {"map_tr", dissolve},     {"map_bump", bump},
      {"bump", bump},           {"norm", normal},         {"map_kn", normal},
      {"map_norm", normal},     {"disp", displacement},   {"map_disp", displacement},
      {"decal", decal},         {"map_decal", decal},     {"refl", reflection},
      {"map_refl", reflection}, {"map_pr", roughness},    {"map_pm", metallic},
      {"map_ps", sheen},
  }};
  for (const auto& [name, channel] : channels) {
    if (name == keyword) return channel;
  }
  return std::nullopt;
}

struct OptionArguments {
  std::size_t least = 0;
  std::size_t most = 0;  // those after the least are numbers
};

// How many words follow an option of a texture statement; nothing if it is none.
std::optional<OptionArguments> option_arguments(const std::string& word) {
  static constexpr std::array<std::string_view, 9> single{
      "-blendu", "-blendv", "-bm", "-boost", "-cc", "-clamp", "-imfchan", "-texres", "-type"};
  static constexpr std::array<std::string_view, 3> vectors{"-o", "-s", "-t"};
  const std::string option = lower(word);
  if (std::ranges::find(single, option) != single.end()) return OptionArguments{1, 1};
  if (std::ranges::find(vectors, option) != vectors.end()) return OptionArguments{1, 3};
  if (option == "-mm") return OptionArguments{2, 2};
  return std::nullopt;
}

struct Word {
  std::string text;
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Word> split(const std::string& text) {
  constexpr const char* blanks = " \t\v\f";
  std::vector<Word> words;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back({text.substr(begin, end - begin), begin, end});
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

// Index of the word behind the option at words[i] and its arguments.
std::size_t behind_option(const std::vector<Word>& words, std::size_t i, OptionArguments count) {
  const std::size_t least = std::min(i + 1 + count.least, words.size());
  const std::size_t most = std::min(i + 1 + count.most, words.size());
  std::size_t end = least;
  while (end < most && is_number(words[end].text)) ++end;
  return end;
}

struct TextureStatement {
  std::string file;  // may be empty
  MtlTextureOptions options;
};

// Word i as a number; `otherwise` when there is none.
double number_of(const std::vector<Word>& words, std::size_t i, std::size_t end, double otherwise) {
  if (i >= end || !is_number(words[i].text)) return otherwise;
  const char* p = words[i].text.c_str();
  double value = otherwise;
  parse_number(p, value);
  return value;
}

// Takes the option at words[i], with arguments up to `end`.
void take_option(const std::vector<Word>& words, std::size_t i, std::size_t end,
                 MtlTextureOptions& options) {
  const std::string name = lower(words[i].text);
  const auto number = [&](std::size_t k, double otherwise) {
    return number_of(words, i + 1 + k, end, otherwise);
  };
  if (name == "-s") options.scale = {number(0, 1), number(1, 1)};
  if (name == "-o") options.offset = {number(0, 0), number(1, 0)};
  if (name == "-mm") options.base = number(0, 0), options.gain = number(1, 1);
  if (name == "-bm") options.bump_multiplier = number(0, 1);
  if (i + 1 >= end) return;
  const std::string argument = lower(words[i + 1].text);
  if (name == "-clamp") options.clamp = argument == "on";
  if (name == "-imfchan") options.scalar_channel = argument[0];
}

// The file name of a texture statement is the words, blanks between them included, that are no
// options and belong to none. Options may also stand behind it.
TextureStatement parse_texture(const std::string& statement) {
  const std::vector<Word> words = split(statement);
  TextureStatement parsed;
  std::size_t first = words.size(), last = 0;  // of the name
  for (std::size_t i = 0; i < words.size();) {
    const auto arguments = option_arguments(words[i].text);
    const std::size_t end = arguments ? behind_option(words, i, *arguments) : i + 1;
    if (arguments) {
      take_option(words, i, end, parsed.options);
    } else if (first > i || last == i) {
      first = std::min(first, i);
      last = end;
    }
    i = end;
  }
  if (first < last) {
    parsed.file = statement.substr(words[first].begin, words[last - 1].end - words[first].begin);
  }
  return parsed;
}

class MtlParser {
 public:
  MtlParser(const std::filesystem::path& file, WarningLog* warnings)
      : folder_(file.parent_path()), warnings_(warnings), cursor_(file.string()) {}

  std::vector<MtlMaterial> parse(TextBlocks blocks) {
    for (std::string_view block = blocks.next(); !block.empty(); block = blocks.next()) {
      if (cursor_.line() == 1 && block.starts_with("\xEF\xBB\xBF")) block.remove_prefix(3);
      cursor_.start_block(block);
      while (!cursor_.block_done()) {
        cursor_.skip_blanks();
        if (!cursor_.at_end()) statement();
        cursor_.next_statement();
      }
    }
    return std::move(materials_);
  }

 private:
  void statement();
  void begin_material(Location where);
  void colour(Rgb& target, std::string_view keyword);
  double scalar(const char* what) { return cursor_.number(what); }
  void dissolve(bool stated_as_transparency);
  void illum();
  void texture(MtlChannel channel, Location where);
  void warn(Location where, std::string text) const {
    if (warnings_) warnings_->add(std::move(where), std::move(text));
  }

  std::filesystem::path folder_;
  WarningLog* warnings_;
  LineCursor cursor_;
  std::vector<MtlMaterial> materials_;
  bool dissolve_stated_ = false;  // by d, which outranks Tr
};

void MtlParser::statement() {
  Location where = cursor_.here();
  const std::string keyword = lower(cursor_.word());
  if (keyword == "newmtl") return begin_material(std::move(where));
  if (materials_.empty()) return;  // belongs to no material

  MtlMaterial& material = materials_.back();
  if (keyword == "kd") return colour(material.diffuse, "Kd");
  if (keyword == "ks") return colour(material.specular, "Ks");
  if (keyword == "ke") return colour(material.emission, "Ke");
  if (keyword == "tf") return colour(material.transmission, "Tf");
  if (keyword == "ns") material.shininess = scalar("Ns");
  if (keyword == "ni") material.index = scalar("Ni");
  if (keyword == "pr") material.roughness = scalar("Pr");
  if (keyword == "pm") material.metallic = scalar("Pm");
  if (keyword == "d") return dissolve(false);
  if (keyword == "tr") return dissolve(true);
  if (keyword == "illum") return illum();
  if (const auto channel = texture_channel(keyword)) texture(*channel, std::move(where));
}

void MtlParser::begin_material(Location where) {
  MtlMaterial& material = materials_.emplace_back();
  material.name = cursor_.rest();
  material.where = std::move(where);
  dissolve_stated_ = false;
}

void MtlParser::colour(Rgb& target, std::string_view keyword) {
  cursor_.skip_blanks();
  if (cursor_.peek() == 's' || cursor_.peek() == 'x') {
    warn(cursor_.here(), fmt::format("{} is not given in RGB and is ignored", keyword));
    return;
  }
  const std::string what(keyword);
  const auto next = [&] { return static_cast<float>(cursor_.number(what.c_str())); };
  const float r = next();
  cursor_.skip_blanks();
  if (cursor_.at_end()) {
    target = {r, r, r};  // g and b default to r
    return;
  }
  const float g = next(), b = next();
  target = {r, g, b};
}

void MtlParser::dissolve(bool stated_as_transparency) {
  cursor_.skip_blanks();
  if (cursor_.peek() == '-') {
    LineCursor ahead = cursor_;
    if (lower(ahead.word()) == "-halo") cursor_ = ahead;
  }
  const double value = scalar(stated_as_transparency ? "Tr" : "d");
  if (stated_as_transparency && dissolve_stated_) return;
  materials_.back().dissolve = stated_as_transparency ? 1 - value : value;
  dissolve_stated_ = dissolve_stated_ || !stated_as_transparency;
}

void MtlParser::illum() {
  const double value = scalar("illum");
  if (value != static_cast<int>(std::clamp(value, -1.0, 11.0)) || value < 0 || value > 10) {
    warn(cursor_.here(), fmt::format("there is no illumination model {}; illum is ignored", value));
    return;
  }
  materials_.back().illum = static_cast<int>(value);
}

void MtlParser::texture(MtlChannel channel, Location where) {
  TextureStatement parsed = parse_texture(cursor_.rest());
  if (parsed.file.empty()) {
    warn(std::move(where), "texture without a file name is ignored");
    return;
  }
  const std::filesystem::path file = resolve(folder_, parsed.file);
  materials_.back().textures.push_back(
      {channel, file, std::move(where), std::move(parsed.file), parsed.options});
}

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, WarningLog* warnings,
                                  InputFiles* files) {
  return MtlParser(file, warnings).parse(TextBlocks::of_file(file, files));
}

std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::filesystem::path& file,
                                   WarningLog* warnings) {
  return MtlParser(file, warnings).parse(TextBlocks::of_text(text));
}

}  // namespace lapidary::import
