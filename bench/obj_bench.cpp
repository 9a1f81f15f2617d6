// How long it takes to read an OBJ file of a million triangles on one core, and the memory it
// takes.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <sys/resource.h>

#include "import/obj.h"
#include "report.h"

namespace {

using namespace lapidary;
namespace fs = std::filesystem;

constexpr int columns = 1000;
constexpr int rows = 500;

enum class Extras { none, normals };

// A dented sheet of 2 x 1000 x 500 triangles.
void write_mesh(const fs::path& path, Extras extras) {
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "w"));
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double x = i * 0.01, z = j * 0.01;
      fmt::print(file.get(), "v {:.6f} {:.6f} {:.6f}\n", x, std::sin(x) * std::cos(2 * z), z);
      if (extras == Extras::none) continue;
      const double dx = std::cos(x) * std::cos(2 * z), dz = -2 * std::sin(x) * std::sin(2 * z);
      const double scale = 1 / std::sqrt(dx * dx + dz * dz + 1);
      fmt::print(file.get(), "vn {:.6f} {:.6f} {:.6f}\n", -dx * scale, scale, -dz * scale);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i + 1, b = a + 1, c = a + columns + 1, d = c + 1;
      if (extras == Extras::none) {
        fmt::print(file.get(), "f {} {} {}\nf {} {} {}\n", a, c, b, b, c, d);
      } else {
        fmt::print(file.get(), "f {0}//{0} {1}//{1} {2}//{2}\nf {2}//{2} {1}//{1} {3}//{3}\n", a, c,
                   b, d);
      }
    }
  }
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::size_t read(const fs::path& path, import::ObjNormals normals) {
  return import::read_obj(path, {.normals = normals}).mesh.triangles.size();
}

}  // namespace

int main() {
  using import::ObjNormals;
  const fs::path folder = fs::temp_directory_path() / "lapidary-obj-bench";
  fs::create_directories(folder);
  const fs::path plain = folder / "plain.obj", with_normals = folder / "normals.obj";
  write_mesh(plain, Extras::none);
  write_mesh(with_normals, Extras::normals);

  std::size_t triangles = 0;
  const double before = peak_megabytes();
  const auto measure = [&](const fs::path& path, ObjNormals normals) {
    return bench::best_seconds(3, [&] { triangles += read(path, normals); });
  };
  bench::report("obj.million_seconds", measure(plain, ObjNormals::automatic), "s", "<=0.7");
  bench::report("obj.million_memory", peak_megabytes() - before, "MB", "<=150");
  bench::report("obj.million_flat_seconds", measure(plain, ObjNormals::flat), "s");
  bench::report("obj.million_normals_seconds", measure(with_normals, ObjNormals::automatic), "s");
  bench::report("obj.million_normals_memory", peak_megabytes() - before, "MB");
  fs::remove_all(folder);
  return triangles == 9 * 2 * columns * rows ? 0 : 1;
}
