#pragma once

#include "base/log.h"
#include "import/find_file.h"
#include "import/image_file.h"
#include "import/mtl.h"
#include "texture/texture.h"

namespace lapidary::import {

/// What materials are made with. Without `images`, textures are left out; `warnings` may be null.
struct MtlReading {
  WarningLog* warnings = nullptr;
  ImageFiles* images = nullptr;
  AllowFile allow = {};
};

/// The textures that the material states, as far as there are files for them: what is missing,
/// refused or broken is told to `reading.warnings`.
class MtlTextures {
 public:
  MtlTextures(const MtlMaterial& material, const MtlReading& reading);

  /// The first of a channel as colours; null when there is none.
  texture::TexturePtr color(MtlChannel channel);
  /// The same as plain numbers.
  texture::TexturePtr number(MtlChannel channel);
  /// Warns of all textures that nobody asked for.
  void warn_of_the_rest() const;

 private:
  texture::TexturePtr read(MtlChannel channel, bool as_number);

  const MtlMaterial& material_;
  const MtlReading& reading_;
  std::vector<bool> used_;
};

}  // namespace lapidary::import
