#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/input_files.h"
#include "base/log.h"
#include "math/vec.h"
#include "spectrum/wavelengths.h"

namespace lapidary::import {

/// What a texture of an MTL material varies.
enum class MtlChannel : std::uint8_t {
  ambient,       ///< map_Ka
  diffuse,       ///< map_Kd
  specular,      ///< map_Ks
  emission,      ///< map_Ke
  transmission,  ///< map_Tf
  shininess,     ///< map_Ns
  dissolve,      ///< map_d, map_Tr
  bump,          ///< map_bump, bump
  normal,        ///< norm, map_Kn
  displacement,  ///< disp, map_disp
  decal,         ///< decal
  reflection,    ///< refl, map_refl
  roughness,     ///< map_Pr
  metallic,      ///< map_Pm
  sheen          ///< map_Ps
};

/// What a texture statement says besides its file.
struct MtlTextureOptions {
  Vec2d scale{1, 1};                      ///< -s: of (u, v), before the offset
  Vec2d offset;                           ///< -o
  double base = 0;                        ///< -mm: is added to all values
  double gain = 1;                        ///< and what they are multiplied by before
  std::optional<double> bump_multiplier;  ///< -bm
  char scalar_channel = 'l';              ///< -imfchan: r, g, b, m, l or z
  bool clamp = false;                     ///< -clamp on: nothing is beside the picture
};

struct MtlTexture {
  MtlChannel channel = MtlChannel::diffuse;
  std::filesystem::path file;  ///< as stated, relative to the MTL file's folder; may not exist
  Location where;
  std::string stated = {};  ///< the file as it stands there
  MtlTextureOptions options = {};
};

/// A material of an MTL file, as stated there. Colours are linear numbers as in the file; what the
/// file does not say has the value given here.
struct MtlMaterial {
  std::string name;
  Rgb diffuse{0.8F, 0.8F, 0.8F};    ///< Kd
  Rgb specular;                     ///< Ks
  Rgb emission;                     ///< Ke
  Rgb transmission{1, 1, 1};        ///< Tf, the filter of light that passes
  double shininess = 0;             ///< Ns, exponent of a Phong lobe
  double dissolve = 1;              ///< d, or 1 - Tr where d is not stated: 1 is opaque
  std::optional<double> index;      ///< Ni, index of refraction
  std::optional<int> illum;         ///< illumination model, 0 .. 10
  std::optional<double> roughness;  ///< Pr
  std::optional<double> metallic;   ///< Pm
  std::vector<MtlTexture> textures;
  Location where;  ///< of its `newmtl`; without a line when no file defines it
};

/// The materials of an MTL file, in its order. Statements that mean nothing here are ignored;
/// colours given as spectra or in XYZ are reported to `warnings`, and that the file was read to
/// `files`, if not null. Throws Error when the file cannot be read, and for a number that is
/// missing, malformed or not finite.
std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file, WarningLog* warnings,
                                  InputFiles* files = nullptr);

/// The same for a text; `file` names it in messages and is where textures are relative to.
std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::filesystem::path& file,
                                   WarningLog* warnings);

}  // namespace lapidary::import
