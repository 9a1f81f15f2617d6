#include "import/obj_statements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "geometry/triangulate.h"
#include "import/line_cursor.h"

namespace lapidary::import {
namespace {

constexpr std::uint32_t none = ObjStatements::none;

// Zero-based indices of one corner of a face.
struct Corner {
  std::uint32_t position = none;
  std::uint32_t uv = none;
  std::uint32_t normal = none;
};

// The vertices, uvs or normals that faces refer to. They may stand behind the face, so the largest
// index that was not there yet is checked when the whole file has been read.
struct References {
  const char* what;     // one of them
  const char* keyword;  // of the statement that makes one
  std::uint32_t largest = 0;
  int line = 0;  // of the largest; 0 when all were there
};

// Statements that were skipped for the same reason.
struct Skipped {
  std::size_t count = 0;
  int line = 0;      // of the first
  std::string word;  // of the first
};

// A face that refers to vertices behind it is cut when they are known.
struct LateFace {
  std::uint32_t first_triangle = 0;
  std::vector<Corner> corners;
  int line = 0;
};

class ObjParser {
 public:
  ObjParser(const std::string& file, WarningLog* warnings)
      : file_(file), warnings_(warnings), cursor_(file) {}

  ObjStatements parse(TextBlocks blocks);

 private:
  void check_encoding(std::string_view& block) const;
  void statement();
  void rare_statement(std::string_view keyword);
  void vertex();
  void normal();
  void uv();
  void face();
  Corner corner();
  std::uint32_t index(std::size_t count, References& references);
  void add_triangle(const std::array<Corner, 3>& corners);
  void set_triangle(std::size_t at, const std::array<Corner, 3>& corners);
  void add_polygon();
  void cut_polygon(std::span<const Corner> corners, std::size_t first_triangle, int line);
  void use_material();
  void smoothing();
  void group();

  void finish();
  void check(const References& references, std::size_t count) const;
  void drop(References& references, std::vector<ObjStatements::Triangle>& triangles) const;
  void report() const;

  Location at_line(int line) const { return {.file = file_, .line = line}; }
  void warn(int line, std::string text) const {
    if (warnings_) warnings_->add(at_line(line), std::move(text));
  }
  std::uint32_t next_triangle() const { return static_cast<std::uint32_t>(out_.triangles.size()); }

  std::string file_;
  WarningLog* warnings_;
  LineCursor cursor_;
  ObjStatements out_;
  References positions_{"vertex", "v"}, uvs_{"texture vertex", "vt"}, normals_{"normal", "vn"};
  bool has_uvs_ = false, has_normals_ = false;
  std::unordered_map<std::string, std::uint32_t> material_index_;
  std::vector<LateFace> late_faces_;
  Skipped lines_, points_, free_forms_, unknown_, forced_;

  geometry::PolygonTriangulator triangulator_;
  std::vector<Corner> corners_;
  std::vector<Vec3d> polygon_;
  std::vector<ObjStatements::Triangle> cut_;
};

void change(std::vector<ObjChange>& changes, std::uint32_t first_triangle, std::uint32_t value) {
  if (!changes.empty() && changes.back().first_triangle == first_triangle) changes.pop_back();
  changes.push_back({first_triangle, value});
}

void count(Skipped& skipped, int line, std::string_view word) {
  if (skipped.count++ > 0) return;
  skipped.line = line;
  skipped.word = word.substr(0, 40);
}

ObjStatements ObjParser::parse(TextBlocks blocks) {
  for (std::string_view block = blocks.next(); !block.empty(); block = blocks.next()) {
    if (cursor_.line() == 1) check_encoding(block);
    cursor_.start_block(block);
    while (!cursor_.block_done()) {
      cursor_.skip_blanks();
      if (!cursor_.at_end()) statement();
      cursor_.next_statement();
    }
  }
  finish();
  return std::move(out_);
}

void ObjParser::check_encoding(std::string_view& block) const {
  if (block.starts_with("\xEF\xBB\xBF")) block.remove_prefix(3);
  if (block.starts_with("\xFF\xFE") || block.starts_with("\xFE\xFF")) {
    throw file_error(file_, "is UTF-16 text", "save it as UTF-8 or plain ASCII");
  }
}

void ObjParser::statement() {
  const std::string_view keyword = cursor_.word();
  if (keyword == "v") return vertex();
  if (keyword == "f" || keyword == "fo") return face();
  if (keyword == "vn") return normal();
  if (keyword == "vt") return uv();
  rare_statement(keyword);
}

void ObjParser::rare_statement(std::string_view keyword) {
  static constexpr std::array<std::string_view, 17> free_form{
      "vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2", "surf", "parm",
      "trim", "hole",   "scrv", "sp",   "end",  "con",  "call",  "csh"};
  // How other programs draw what is there; nothing is lost without.
  static constexpr std::array<std::string_view, 11> attributes{
      "mg",        "bevel", "c_interp", "d_interp", "lod",   "shadow_obj",
      "trace_obj", "ctech", "stech",    "maplib",   "usemap"};
  if (keyword == "usemtl") return use_material();
  if (keyword == "g" || keyword == "o") return group();
  if (keyword == "s") return smoothing();
  if (keyword == "mtllib") {
    Location where = cursor_.here();
    out_.libraries.push_back({cursor_.rest(), std::move(where)});
  } else if (keyword == "l") {
    count(lines_, cursor_.line(), keyword);
  } else if (keyword == "p") {
    count(points_, cursor_.line(), keyword);
  } else if (std::ranges::find(free_form, keyword) != free_form.end()) {
    count(free_forms_, cursor_.line(), keyword);
  } else if (std::ranges::find(attributes, keyword) == attributes.end()) {
    count(unknown_, cursor_.line(), keyword);
  }
}

// More numbers may follow: a weight, or a colour in the manner of MeshLab. They are skipped.
void ObjParser::vertex() {
  const double x = cursor_.number("x of vertex");
  const double y = cursor_.number("y of vertex");
  const double z = cursor_.number("z of vertex");
  if (out_.positions.size() == none) cursor_.fail("there are more vertices than 32 bits can count");
  out_.positions.push_back({x, y, z});
}

void ObjParser::normal() {
  const double x = cursor_.number("x of normal");
  const double y = cursor_.number("y of normal");
  const double z = cursor_.number("z of normal");
  const Vec3d n{x, y, z};
  const double squared = length_squared(n);
  if (out_.normals.size() == none) cursor_.fail("there are more normals than 32 bits can count");
  out_.normals.push_back(squared > 0 ? Vec3f(n * (1 / std::sqrt(squared))) : Vec3f());
}

void ObjParser::uv() {
  const double u = cursor_.number("u of texture vertex");
  cursor_.skip_blanks();
  const double v = cursor_.at_end() ? 0 : cursor_.number("v of texture vertex");
  if (out_.uvs.size() == none) cursor_.fail("there are more uvs than 32 bits can count");
  out_.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
}

void ObjParser::face() {
  corners_.clear();
  for (cursor_.skip_blanks(); !cursor_.at_end(); cursor_.skip_blanks()) {
    corners_.push_back(corner());
  }
  if (corners_.size() < 3) {
    cursor_.fail(fmt::format("face has {} corners", corners_.size()), "a face needs at least 3");
  }
  if (out_.triangles.size() + corners_.size() > none) {
    cursor_.fail("there are more triangles than 32 bits can count");
  }
  if (corners_.size() == 3) {
    add_triangle({corners_[0], corners_[1], corners_[2]});
  } else {
    add_polygon();
  }
}

// position, position/uv, position//normal or position/uv/normal; what is behind a slash may be
// missing.
Corner ObjParser::corner() {
  Corner corner;
  corner.position = index(out_.positions.size(), positions_);
  if (cursor_.peek() == '/') {
    cursor_.advance();
    if (cursor_.peek() != '/' && !cursor_.at_boundary()) {
      corner.uv = index(out_.uvs.size(), uvs_);
    }
    if (cursor_.peek() == '/') {
      cursor_.advance();
      if (!cursor_.at_boundary()) corner.normal = index(out_.normals.size(), normals_);
    }
  }
  if (!cursor_.at_boundary()) {
    cursor_.fail(fmt::format("{} does not belong in a corner of a face", cursor_.quoted_word()),
                 "corners look like 7, 7/3, 7//2 or 7/3/2");
  }
  return corner;
}

std::uint32_t ObjParser::index(std::size_t count, References& references) {
  std::int64_t stated = 0;
  if (!cursor_.integer(stated)) {
    cursor_.fail(fmt::format("{} is not the index of a {}", cursor_.quoted_word(), references.what),
                 "corners look like 7, 7/3, 7//2 or 7/3/2");
  }
  if (stated == 0) {
    cursor_.fail(fmt::format("a {} index is 0", references.what),
                 "indices count from 1, or backwards from -1");
  }
  const std::int64_t index = stated > 0 ? stated - 1 : static_cast<std::int64_t>(count) + stated;
  if (index < 0) {
    cursor_.fail(fmt::format("{} index {} reaches back too far: there are {} so far",
                             references.what, stated, count));
  }
  const auto result = static_cast<std::uint32_t>(std::min<std::int64_t>(index, none - 1));
  if (result >= count && (references.line == 0 || result > references.largest)) {
    references.largest = result;
    references.line = cursor_.line();
  }
  return result;
}

void ObjParser::add_triangle(const std::array<Corner, 3>& corners) {
  const std::size_t at = out_.triangles.size();
  out_.triangles.emplace_back();
  set_triangle(at, corners);
}

// The triangle exists; uvs and normals are made to from the first that has any.
void ObjParser::set_triangle(std::size_t at, const std::array<Corner, 3>& corners) {
  const auto& [a, b, c] = corners;
  out_.triangles[at] = {a.position, b.position, c.position};
  has_uvs_ = has_uvs_ || a.uv != none || b.uv != none || c.uv != none;
  has_normals_ = has_normals_ || a.normal != none || b.normal != none || c.normal != none;
  if (has_uvs_) {
    out_.uv_triangles.resize(out_.triangles.size(), {none, none, none});
    out_.uv_triangles[at] = {a.uv, b.uv, c.uv};
  }
  if (has_normals_) {
    out_.normal_triangles.resize(out_.triangles.size(), {none, none, none});
    out_.normal_triangles[at] = {a.normal, b.normal, c.normal};
  }
}

void ObjParser::add_polygon() {
  const std::uint32_t first = next_triangle();
  out_.triangles.resize(first + corners_.size() - 2);
  const bool known = std::ranges::all_of(
      corners_, [&](const Corner& c) { return c.position < out_.positions.size(); });
  if (known) {
    cut_polygon(corners_, first, cursor_.line());
  } else {
    late_faces_.push_back({first, corners_, cursor_.line()});
  }
}

void ObjParser::cut_polygon(std::span<const Corner> corners, std::size_t first_triangle, int line) {
  polygon_.clear();
  for (const Corner& c : corners) polygon_.push_back(out_.positions[c.position]);
  cut_.clear();
  if (triangulator_.triangulate(polygon_, cut_) == geometry::Triangulation::forced) {
    count(forced_, line, "f");
  }
  for (const auto& [a, b, c] : cut_) {
    set_triangle(first_triangle++, {corners[a], corners[b], corners[c]});
  }
}

void ObjParser::use_material() {
  Location where = cursor_.here();
  std::string name = cursor_.rest();
  if (name.empty()) return change(out_.material_changes, next_triangle(), none);
  const auto next = static_cast<std::uint32_t>(out_.material_names.size());
  const auto [entry, is_new] = material_index_.try_emplace(name, next);
  if (is_new) out_.material_names.push_back({std::move(name), std::move(where)});
  change(out_.material_changes, next_triangle(), entry->second);
}

void ObjParser::smoothing() {
  cursor_.skip_blanks();
  const Location where = cursor_.here();
  const std::string_view word = cursor_.word();
  std::uint32_t number = word == "on" ? 1 : 0;
  if (word != "on" && word != "off" && !word.empty()) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) {
      throw Error(where, "smoothing group is not a number", "write s 1, s 2, ... or s off");
    }
  }
  out_.states_smoothing = true;
  change(out_.smoothing_changes, next_triangle(), number);
}

void ObjParser::group() {
  change(out_.group_changes, next_triangle(), static_cast<std::uint32_t>(out_.group_names.size()));
  out_.group_names.push_back(cursor_.rest());
}

void ObjParser::finish() {
  check(positions_, out_.positions.size());
  for (const LateFace& face : late_faces_) {
    cut_polygon(face.corners, face.first_triangle, face.line);
  }
  const ObjStatements::Triangle bare{none, none, none};
  if (has_uvs_) out_.uv_triangles.resize(out_.triangles.size(), bare);
  if (has_normals_) out_.normal_triangles.resize(out_.triangles.size(), bare);
  if (out_.uvs.empty()) drop(uvs_, out_.uv_triangles);
  if (out_.normals.empty()) drop(normals_, out_.normal_triangles);
  check(uvs_, out_.uvs.size());
  check(normals_, out_.normals.size());
  report();
}

// Some exporters write v/vt/vn corners into files without any vt or vn: nothing is lost then.
void ObjParser::drop(References& references,
                     std::vector<ObjStatements::Triangle>& triangles) const {
  if (references.line == 0) return;
  warn(references.line, fmt::format("faces refer to {0} indices, but there is no {0} in the file",
                                    references.keyword));
  references.line = 0;
  triangles.clear();
}

void ObjParser::check(const References& references, std::size_t count) const {
  if (references.line == 0 || references.largest < count) return;
  throw Error(at_line(references.line),
              fmt::format("face refers to {} {}, but there are {}", references.what,
                          std::uint64_t{references.largest} + 1, count),
              fmt::format("indices count the '{}' statements from 1", references.keyword));
}

void ObjParser::report() const {
  if (out_.triangles.empty()) {
    throw file_error(file_, "has no faces: 0 triangles",
                     lines_.count + points_.count + free_forms_.count > 0
                         ? "only faces (f) can be rendered, not points, lines or free forms"
                         : "is it an OBJ file?");
  }
  const auto tell = [&](const Skipped& skipped, std::string_view what) {
    if (skipped.count > 0) {
      warn(skipped.line, fmt::format("{} {}; the first is '{}' in line {}", skipped.count, what,
                                     skipped.word, skipped.line));
    }
  };
  tell(lines_, "line elements are skipped");
  tell(points_, "point elements are skipped");
  tell(free_forms_, "statements of free-form curves and surfaces are skipped");
  tell(unknown_, "statements of unknown kind are skipped");
  tell(forced_, "polygons cross themselves, so that their triangles overlap");
}

}  // namespace

ObjStatements parse_obj_statements(TextBlocks blocks, const std::string& file,
                                   WarningLog* warnings) {
  return ObjParser(file, warnings).parse(std::move(blocks));
}

}  // namespace lapidary::import
