#include "light/ies_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::light {
namespace {

/// The words of a text, which commas and blanks of all kinds separate, and the lines they are in.
class Words {
 public:
  Words(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  /// The rest of the line, without the blanks around it; nothing at the end of the text.
  std::optional<std::string_view> line() {
    if (rest_.empty()) return std::nullopt;
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    while (!found.empty() && is_blank(found.back())) found.remove_suffix(1);
    while (!found.empty() && is_blank(found.front())) found.remove_prefix(1);
    return found;
  }

  /// `what` says in messages which number it is: "the number of lamps".
  double number(const std::string& what) {
    while (!rest_.empty() && is_blank(rest_.front())) advance();
    if (rest_.empty()) fail(fmt::format("the file ends where {} should be", what));
    const char* begin = rest_.data();
    const char* end = begin + rest_.size();
    double x = 0;
    const auto [stop, problem] = std::from_chars(begin + (*begin == '+' ? 1 : 0), end, x);
    const bool is_word = stop == end || is_blank(*stop);
    if (problem != std::errc() || !is_word || !std::isfinite(x)) {
      fail(fmt::format("{} should be a number, not '{}'", what, word()));
    }
    rest_.remove_prefix(static_cast<std::size_t>(stop - begin));
    return x;
  }

  double non_negative(const std::string& what) {
    const double x = number(what);
    if (x < 0.0) fail(fmt::format("{} must not be negative, but is {}", what, x));
    return x;
  }

  std::size_t count(const std::string& what, std::size_t least, std::size_t most) {
    const double x = number(what);
    const bool is_count =
        x == std::floor(x) && x >= static_cast<double>(least) && x <= static_cast<double>(most);
    if (!is_count) {
      fail(fmt::format("{} must be a whole number from {} to {}, not {}", what, least, most, x));
    }
    return static_cast<std::size_t>(x);
  }

  [[noreturn]] void fail(std::string problem, std::string hint = "") const {
    throw Error({.file = file_, .line = std::max(line_, 1)}, std::move(problem), std::move(hint));
  }

  /// The lines that numbers stand in follow those that were read whole.
  void start_numbers() { ++line_; }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == ',' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
  }
  void advance() {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
  /// As far as a message can show it.
  std::string word() const {
    std::string shown;
    for (const char c : rest_.substr(0, 20)) {
      if (is_blank(c)) break;
      shown += c >= ' ' && c <= '~' ? c : '?';
    }
    return shown;
  }

  std::string_view rest_;
  std::string file_;
  int line_ = 0;
};

/// From its beginning to the line of TILT; whether the ballast-lamp factor of old files is used.
struct Head {
  bool has_lamp_factor = true;
  std::string tilt;
};

Head read_head(Words& words) {
  Head head;
  for (bool is_first = true; const auto line = words.line(); is_first = false) {
    // From 1995 on that place is reserved for later use.
    if (is_first && line->starts_with("IES")) {
      head.has_lamp_factor =
          line->find("91") != std::string_view::npos || line->find("86") != std::string_view::npos;
    }
    if (!line->starts_with("TILT=")) continue;
    head.tilt = std::string(line->substr(5));
    return head;
  }
  words.fail("the file has no line TILT=, so it is no IES profile",
             "a profile is a text by ANSI/IES LM-63");
}

void pass_tilt(Words& words) {
  words.number("the geometry of tilted lamps");
  const std::size_t pairs = words.count("the number of tilt angles", 1, 10000);
  for (std::size_t i = 0; i < pairs; ++i) words.number("a tilt angle");
  for (std::size_t i = 0; i < pairs; ++i) words.number("the factor of a tilt angle");
}

std::vector<double> read_angles(Words& words, std::size_t count, const std::string& what) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i) {
    angles.push_back(words.number(what));
    if (i > 0 && !(angles[i] > angles[i - 1])) {
      words.fail(fmt::format("{} of {} must be greater than the one before it, {}", what, angles[i],
                             angles[i - 1]));
    }
  }
  return angles;
}

// The standard has them go to 90 degrees; files of beams stop where there is no more light.
void check_beam_angles(const std::vector<double>& angles, const char* which, const Words& words) {
  const bool is_range = angles.size() >= 2 && angles.front() >= -90.0 && angles.front() <= 0.0 &&
                        angles.back() > 0.0 && angles.back() <= 90.0;
  if (is_range) return;
  words.fail(
      fmt::format("{} angles of types A and B go from 0, or from -90 or more, to 90 degrees or "
                  "less, not from {} to {}",
                  which, angles.front(), angles.back()));
}

void check_angles(const PhotometricWeb::Table& table, const Words& words) {
  if (table.type != PhotometricWeb::Type::c) {
    check_beam_angles(table.vertical, "vertical", words);
    check_beam_angles(table.horizontal, "horizontal", words);
    return;
  }
  const double top = table.vertical.front(), bottom = table.vertical.back();
  if ((top != 0.0 && top != 90.0) || (bottom != 90.0 && bottom != 180.0)) {
    words.fail(
        fmt::format("vertical angles of type C go from 0 or 90 to 90 or 180 degrees, not "
                    "from {} to {}",
                    top, bottom));
  }
  const double first = table.horizontal.front(), last = table.horizontal.back();
  const bool from_zero = first == 0.0 && (last == 90.0 || last == 180.0 || last == 360.0);
  const bool mirrored = first == 90.0 && last == 270.0;
  const bool alone = table.horizontal.size() == 1;
  if (alone ? first != 0.0 : !from_zero && !mirrored) {
    words.fail(
        fmt::format("horizontal angles of type C are 0 alone, or go from 0 to 90, 180 or "
                    "360 degrees or from 90 to 270, not from {} to {}",
                    first, last));
  }
}

}  // namespace

PhotometricWeb parse_ies(std::string_view text, const std::string& file) {
  Words words(text, file);
  const Head head = read_head(words);
  words.start_numbers();
  if (head.tilt == "INCLUDE") pass_tilt(words);

  words.number("the number of lamps");
  words.number("the lumens of a lamp");  // -1 where the whole luminaire was measured
  double factor = words.non_negative("the multiplier of candela");
  const std::size_t verticals = words.count("the number of vertical angles", 2, 10000);
  const std::size_t horizontals = words.count("the number of horizontal angles", 1, 10000);
  const std::size_t type = words.count("the type of photometry", 1, 3);
  for (const char* size : {"the kind of units", "the width", "the length", "the height"}) {
    words.number(size);
  }
  factor *= words.non_negative("the ballast factor");
  const double lamp_factor = words.number("the ballast-lamp factor");
  if (head.has_lamp_factor && lamp_factor > 0.0) factor *= lamp_factor;
  words.number("the input power");

  using Type = PhotometricWeb::Type;
  PhotometricWeb::Table table;
  table.type = std::array{Type::c, Type::b, Type::a}[type - 1];
  table.vertical = read_angles(words, verticals, "a vertical angle");
  table.horizontal = read_angles(words, horizontals, "a horizontal angle");
  check_angles(table, words);
  double brightest = 0.0;
  for (std::size_t i = 0; i < verticals * horizontals; ++i) {
    const double x = factor * words.non_negative("a value in candela");
    if (!(x < 1e30)) words.fail(fmt::format("{} candela are too much", x));
    table.candela.push_back(static_cast<float>(x));
    brightest = std::max(brightest, x);
  }
  if (!(brightest > 0.0)) words.fail("the profile gives no light");
  return PhotometricWeb(table);
}

namespace {

std::string read_text(const std::filesystem::path& file, const InputFiles* files) {
  if (const auto content = file_content(files, file)) return std::string(*content);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw file_error(file.string(), "the file cannot be read");
  constexpr std::uintmax_t most_bytes = 64 << 20;
  std::error_code unknown;
  if (std::filesystem::file_size(file, unknown) > most_bytes || unknown) {
    throw file_error(file.string(), "the file is too large for an IES profile");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

PhotometricWeb read_ies(const std::filesystem::path& file, InputFiles* files) {
  const std::string text = read_text(file, files);
  if (files) files->add(file, std::as_bytes(std::span(text)));
  return parse_ies(text, file.string());
}

}  // namespace lapidary::light
