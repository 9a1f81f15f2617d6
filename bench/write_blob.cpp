// Writes the wrinkled ball of a million triangles as an OBJ file: write_blob FILE.

#include <cstdio>

#include "blob.h"

int main(int argc, char** argv) {
  std::FILE* file = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (file == nullptr) {
    std::fputs("usage: write_blob FILE\n", stderr);
    return 2;
  }
  const lapidary::geometry::TriangleMesh mesh = lapidary::bench::blob();
  for (const auto& p : mesh.positions) std::fprintf(file, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
  for (const auto& [a, b, c] : mesh.triangles)
    std::fprintf(file, "f %u %u %u\n", a + 1, b + 1, c + 1);
  return std::fclose(file) == 0 ? 0 : 1;
}
