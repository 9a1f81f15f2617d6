#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// After <cstdio>, which jpeglib.h needs and does not include.
#include <jpeglib.h>

namespace lapidary::image::test {

/// A JPEG of one colour, in the colour space of the components given.
inline std::string jpeg_bytes(J_COLOR_SPACE space, std::vector<JSAMPLE> color, bool progressive) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr handler{};
  jpeg.err = jpeg_std_error(&handler);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = jpeg.image_height = 24;
  jpeg.input_components = static_cast<int>(color.size());
  jpeg.in_color_space = space;
  jpeg_set_defaults(&jpeg);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> row;
  for (int x = 0; x < 24; ++x) row.insert(row.end(), color.begin(), color.end());
  JSAMPROW pointer = row.data();
  for (int y = 0; y < 24; ++y) jpeg_write_scanlines(&jpeg, &pointer, 1);
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string bytes(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  return bytes;
}

}  // namespace lapidary::image::test
