#pragma once

#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>

// OpenEXR files of kinds that the project does not write, made by OpenEXR itself.

namespace lapidary::image::test {

/// Channels with value 100 c + 10 y + x in a part of an OpenEXR file, c counting from 1.
struct ExrPart {
  std::vector<std::string> names;
  Imath::Box2i window{{0, 0}, {7, 5}};
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
};

class ExrValues {
 public:
  explicit ExrValues(const ExrPart& part) : part_(part) {
    const auto size = part.window.size() + Imath::V2i(1, 1);
    for (std::size_t c = 0; c < part.names.size(); ++c) {
      auto& plane = planes_.emplace_back();
      for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
          plane.push_back(100.0f * static_cast<float>(c + 1) + 10.0f * static_cast<float>(y) +
                          static_cast<float>(x));
        }
      }
    }
  }

  Imf::Header header() const {
    Imf::Header header(part_.window, part_.window);
    header.compression() = part_.compression;
    for (const auto& name : part_.names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
  }

  Imf::FrameBuffer frame() {
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      frame.insert(part_.names[c], Imf::Slice::Make(Imf::FLOAT, planes_[c].data(), part_.window));
    }
    return frame;
  }

 private:
  ExrPart part_;
  std::vector<std::vector<float>> planes_;
};

inline void write_scan_lines(const std::string& path, const ExrPart& part) {
  ExrValues values(part);
  const int rows = part.window.size().y + 1;
  Imf::OutputFile out(path.c_str(), values.header(), 0);
  out.setFrameBuffer(values.frame());
  out.writePixels(rows);
}

inline void write_tiles(const std::string& path, const ExrPart& part, Imath::V2i tile) {
  ExrValues values(part);
  Imf::Header header = values.header();
  header.setTileDescription(
      Imf::TileDescription(static_cast<unsigned>(tile.x), static_cast<unsigned>(tile.y)));
  Imf::TiledOutputFile out(path.c_str(), header, 0);
  out.setFrameBuffer(values.frame());
  out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
}

inline void write_parts(const std::string& path, const std::vector<ExrPart>& parts) {
  std::vector<ExrValues> values;
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) {
    values.emplace_back(part);
    headers.push_back(values.back().header());
    headers.back().setName("part" + std::to_string(headers.size()));
    headers.back().setType(Imf::SCANLINEIMAGE);
  }
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Imf::OutputPart out(file, static_cast<int>(i));
    out.setFrameBuffer(values[i].frame());
    out.writePixels(parts[i].window.size().y + 1);
  }
}

}  // namespace lapidary::image::test
