#include "render/bake.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::render {
namespace {

using geometry::MeshCharts;
using geometry::SurfaceKind;
using transport::IlluminationMap;
using transport::IlluminationMaps;
using transport::MappedSurface;
using transport::SurfaceSide;
using Entry = IlluminationMaps::Entry;

constexpr std::size_t most_images = 1 << 16;
/// Texels between charts, and how far values go on beyond them.
constexpr int gutter = 2;

/// An image while it is filled, rows from low v; which texels have a value.
struct Canvas {
  int width, height;
  std::vector<Rgb> texels;
  std::vector<std::uint8_t> has_value;

  Canvas(int w, int h) : width(w), height(h), texels(size(w, h)), has_value(size(w, h)) {}

  static std::size_t size(int w, int h) {
    return static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }

  void place(const IlluminationMap& map, int x0, int y0) {
    for (int y = 0; y < map.grid().height; ++y) {
      for (int x = 0; x < map.grid().width; ++x) {
        if (!map.has_value(x, y) || x0 + x >= width || y0 + y >= height) continue;
        const std::size_t i = index(x0 + x, y0 + y);
        texels[i] = map.texel(x, y);
        has_value[i] = 1;
      }
    }
  }

  /// Every texel without a value takes the mean of the neighbours that have one.
  void grow() {
    const std::vector<std::uint8_t> before = has_value;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (before[index(x, y)] != 0) continue;
        Rgb sum;
        int count = 0;
        for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height - 1); ++ny) {
          for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width - 1); ++nx) {
            if (before[index(nx, ny)] != 0) sum += texels[index(nx, ny)], ++count;
          }
        }
        if (count == 0) continue;
        texels[index(x, y)] = sum * (1.0f / static_cast<float>(count));
        has_value[index(x, y)] = 1;
      }
    }
  }

  image::Image image() const {
    image::Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Rgb rgb = texels[index(x, y)];
        const auto pixel = image.pixel(x, height - 1 - y);
        pixel[0] = rgb.r, pixel[1] = rgb.g, pixel[2] = rgb.b;
      }
    }
    return image;
  }
};

image::Image finished(Canvas& canvas) {
  for (int i = 0; i < gutter; ++i) canvas.grow();
  return canvas.image();
}

struct NameOfKind {
  std::string operator()(const geometry::Sphere&) const { return "sphere"; }
  std::string operator()(const geometry::Box&) const { return "box"; }
  std::string operator()(const geometry::HalfSpace&) const { return "half_space"; }
  std::string operator()(const geometry::Cylinder&) const { return "cylinder"; }
  std::string operator()(const geometry::MeshBody&) const { return "mesh"; }
  std::string operator()(const geometry::Polyhedron&) const { return "polyhedron"; }
  std::string operator()(const geometry::Cone&) const { return "cone"; }
  std::string operator()(const geometry::Prism&) const { return "prism"; }
  std::string operator()(const geometry::Torus&) const { return "torus"; }
  std::string operator()(const geometry::Quadric&) const { return "quadric"; }
  std::string operator()(const geometry::Lathe&) const { return "lathe"; }
  std::string operator()(const geometry::Superellipsoid&) const { return "superellipsoid"; }
  std::string operator()(const geometry::Rectangle&) const { return "rectangle"; }
  std::string operator()(const geometry::Disk&) const { return "disk"; }
};

std::string kind_of(const geometry::World& world, const transport::SurfaceKey& key) {
  if (key.kind == SurfaceKind::triangle) return "mesh";
  if (key.kind == SurfaceKind::sheet) return std::visit(NameOfKind(), world.sheets()[key.index]);
  return std::visit(NameOfKind(), world.solids().compound(key.place).leaf(key.index).solid.solid());
}

/// Names for files, each of them once, whatever the case of letters.
class FileNames {
 public:
  std::string unique(std::string_view wanted) {
    std::string name;
    for (const char c : wanted) {
      const bool is_safe = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
      name += is_safe ? c : '_';
    }
    name.resize(std::min<std::size_t>(name.size(), 80));
    std::string candidate = name;
    for (int i = 2; !taken_.insert(folded(candidate)).second; ++i) {
      candidate = fmt::format("{}_{}", name, i);
    }
    return candidate;
  }

 private:
  static std::string folded(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
  }
  std::set<std::string> taken_{"index"};
};

/// Where the charts of a mesh are in their image, in texels from the lower left.
struct Layout {
  int width = 1, height = 1;
  double step = 1;  ///< of coordinates, from texel to texel
  struct Spot {
    int x = 0, y = 0, width = 0, height = 0;
    Vec2d low;  ///< coordinates of its lower left corner
  };
  std::vector<Spot> spots;
};

/// The lattice that the maps of the charts lie on.
double step_of(const Entry& entry) {
  return (entry.map.max().x - entry.map.min().x) / entry.map.grid().width;
}

/// Rows of charts, the highest first.
Layout packed(const MeshCharts& charts, double step) {
  Layout layout;
  layout.step = step;
  double area = 0;
  int widest = 1;
  for (const MeshCharts::Chart& chart : charts.charts) {
    const auto low = [&](double at) { return std::floor(at / step + 1e-6); };
    const auto high = [&](double at) { return std::ceil(at / step - 1e-6); };
    Layout::Spot spot;
    spot.low = {low(chart.min.x) * step, low(chart.min.y) * step};
    spot.width = std::max(1, static_cast<int>(high(chart.max.x) - low(chart.min.x)));
    spot.height = std::max(1, static_cast<int>(high(chart.max.y) - low(chart.min.y)));
    area += (spot.width + 2.0 * gutter) * (spot.height + 2.0 * gutter);
    widest = std::max(widest, spot.width);
    layout.spots.push_back(spot);
  }
  layout.width = std::max(widest + 2 * gutter, static_cast<int>(std::ceil(std::sqrt(1.1 * area))));
  std::vector<std::size_t> order(layout.spots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return layout.spots[a].height > layout.spots[b].height;
  });
  int x = gutter, y = gutter, row = 0;
  for (const std::size_t i : order) {
    Layout::Spot& spot = layout.spots[i];
    if (x + spot.width + gutter > layout.width) x = gutter, y += row + 2 * gutter, row = 0;
    spot.x = x, spot.y = y;
    x += spot.width + 2 * gutter;
    row = std::max(row, spot.height);
  }
  layout.height = y + row + gutter;
  return layout;
}

/// The whole unit square of the mesh's own coordinates.
Layout own_layout(const MeshCharts& charts, double step) {
  Layout layout;
  layout.step = step;
  layout.width = layout.height = static_cast<int>(std::lround(1.0 / step));
  for (const MeshCharts::Chart& chart : charts.charts) {
    Layout::Spot spot;
    spot.x = static_cast<int>(std::floor(chart.min.x / step + 1e-6));
    spot.y = static_cast<int>(std::floor(chart.min.y / step + 1e-6));
    layout.spots.push_back(spot);
  }
  return layout;
}

std::vector<std::array<Vec2d, 3>> atlas_of(const MeshCharts& charts, const Layout& layout) {
  std::vector<std::array<Vec2d, 3>> atlas(charts.faces.size());
  for (std::size_t f = 0; f < atlas.size(); ++f) {
    const MeshCharts::Face& face = charts.faces[f];
    if (face.chart == MeshCharts::no_chart) continue;
    const Layout::Spot& spot = layout.spots[face.chart];
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2d at = (face.at[i] - spot.low) * (1.0 / layout.step);
      atlas[f][i] = {(spot.x + at.x) / layout.width, (spot.y + at.y) / layout.height};
    }
  }
  return atlas;
}

class Baking {
 public:
  Baking(const scene::Scene& scene, const IlluminationMaps& maps) : scene_(scene), maps_(maps) {}

  std::vector<BakedImage> all() {
    const std::vector<Entry>& entries = maps_.entries();
    for (std::size_t i = 0, end = 0; i < entries.size(); i = end) {
      while (end < entries.size() && entries[end].surface == entries[i].surface) ++end;
      const std::span<const Entry> some(entries.data() + i, end - i);
      if (maps_.surfaces()[entries[i].surface].mesh_charts()) {
        add_mesh(some);
      } else {
        for (const Entry& entry : some) add(entry);
      }
      if (baked_.size() > most_images) {
        throw Error({}, fmt::format("there would be more than {} images", most_images),
                    "bake a scene of fewer surfaces");
      }
    }
    return std::move(baked_);
  }

 private:
  BakedImage& start(const Entry& entry, std::string_view piece) {
    BakedImage& baked = baked_.emplace_back();
    const std::uint32_t object = maps_.object_of(entry.surface);
    baked.object = scene_.object(object).name;
    baked.surface = kind_of(scene_.world(), maps_.surfaces()[entry.surface].key());
    baked.map_surface = entry.surface, baked.chart = entry.chart, baked.side = entry.side;
    std::string name =
        baked.object.empty() ? fmt::format("{}{}", baked.surface, object + 1) : baked.object;
    if (!piece.empty()) name += fmt::format("_{}", piece);
    if (entry.side == SurfaceSide::back) name += "_back";
    baked.name = names_.unique(name);
    return baked;
  }

  void add(const Entry& entry) {
    const MappedSurface& surface = maps_.surfaces()[entry.surface];
    const bool is_one = surface.chart_count() == 1;
    BakedImage& baked = start(entry, is_one ? "" : fmt::format("{}", entry.chart + 1));
    Canvas canvas(entry.map.grid().width, entry.map.grid().height);
    canvas.place(entry.map, 0, 0);
    baked.image = finished(canvas);
    baked.photons = entry.photons;
    baked.min = entry.map.min(), baked.max = entry.map.max();
    baked.ends = entry.map.grid();
  }

  void add_mesh(std::span<const Entry> entries) {
    const MeshCharts& charts = *maps_.surfaces()[entries[0].surface].mesh_charts();
    const bool is_own = charts.source == MeshCharts::Source::own_uvs;
    const double step = step_of(entries[0]);
    const Layout layout = is_own ? own_layout(charts, step) : packed(charts, step);
    for (const SurfaceSide side : {SurfaceSide::front, SurfaceSide::back}) {
      Canvas canvas(layout.width, layout.height);
      const Entry* first = nullptr;
      std::size_t photons = 0;
      for (const Entry& entry : entries) {
        if (entry.side != side) continue;
        if (first == nullptr) first = &entry;
        photons += entry.photons;
        canvas.place(entry.map, layout.spots[entry.chart].x, layout.spots[entry.chart].y);
      }
      if (first == nullptr) continue;
      BakedImage& baked = start(*first, "");
      baked.image = finished(canvas);
      baked.photons = photons;
      baked.min = {0, 0}, baked.max = {1, 1};
      if (!is_own) baked.atlas = atlas_of(charts, layout), baked.why_atlas = charts.why_not_own;
    }
  }

  const scene::Scene& scene_;
  const IlluminationMaps& maps_;
  FileNames names_;
  std::vector<BakedImage> baked_;
};

}  // namespace

std::vector<BakedImage> bake(const scene::Scene& scene, const IlluminationMaps& maps) {
  return Baking(scene, maps).all();
}

std::string obj_with_atlas(const MappedSurface& surface, const BakedImage& baked) {
  std::string text = "# A mesh with the texture coordinates of its illumination map.\n";
  auto out = std::back_inserter(text);
  for (std::uint32_t f = 0; f < baked.atlas.size(); ++f) {
    const geometry::Corners c = surface.corners(f);
    for (const Vec3d& p : {c.p0, c.p1, c.p2}) {
      fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    }
    for (const Vec2d& at : baked.atlas[f]) fmt::format_to(out, "vt {:.9g} {:.9g}\n", at.x, at.y);
    const std::uint32_t first = 3 * f + 1;
    fmt::format_to(out, "f {0}/{0} {1}/{1} {2}/{2}\n", first, first + 1, first + 2);
  }
  return text;
}

}  // namespace lapidary::render
