#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lapidary::description {

enum class ToneCurve { filmic, none };

/// How measured light becomes a picture.
struct FilmSettings {
  double exposure = 1;                 ///< factor on linear values
  ToneCurve tone = ToneCurve::filmic;  ///< of 8-bit pictures; linear files ignore it
};

struct PictureSize {
  int width = 1280;
  int height = 720;
  bool operator==(const PictureSize&) const = default;
};

enum class Integrator { path, direct, illumination };

/// What next-event estimation chooses one of many lights by.
enum class LightChoice {
  tree,   ///< how much each could light the point
  power,  ///< power alone
};

/// Who renders light focused by glass and mirrors.
enum class Caustics { automatic, photons, paths, off };

/// Where the photons of caustics go.
enum class PhotonAim {
  learned,  ///< where they were worth most to the picture in a first phase
  none,     ///< wherever lights shine
};

/// How caustics are rendered by photons: to study that, not to get a better picture.
struct PhotonSettings {
  double radius = 2.5;  ///< of a gather in the first pass, pixels; smaller in every later one
  PhotonAim aim = PhotonAim::learned;
};

/// Where camera samples go.
enum class Sampling {
  adaptive,  ///< more where the picture is noisy
  uniform,   ///< the same number in every pixel
};

enum class FilterKind { box, tent, gaussian, blackman_harris };

/// What a sample contributes to the pixels around it.
struct FilterSettings {
  FilterKind kind = FilterKind::blackman_harris;
  std::optional<double> radius;  ///< pixels; none: the kind's own
};

enum class IlluminationFilter { gaussian, box };

/// How illumination maps are made.
struct IlluminationSettings {
  int photons = 1'000'000;
  std::optional<double> radius;  ///< of the blur, scene units; none: by the photons
  IlluminationFilter filter = IlluminationFilter::gaussian;
  std::optional<double> resolution;  ///< texels per scene unit; none: by the radius
};

/// What to render and when to stop: at the first of the limits that are given, or after a default
/// number of samples when none is.
struct RenderSettings {
  PictureSize size;
  std::optional<int> samples;   ///< per pixel
  std::optional<double> time;   ///< seconds of wall time
  std::optional<double> noise;  ///< relative error to reach
  Integrator integrator = Integrator::path;
  int max_depth = 16;  ///< scattering events of a path
  Caustics caustics = Caustics::automatic;
  PhotonSettings photons;
  Sampling sampling = Sampling::adaptive;
  LightChoice light_choice = LightChoice::tree;
  IlluminationSettings illumination;
  FilterSettings filter;
  std::uint64_t seed = 0;
};

/// Sets one key as "--render KEY=VALUE" on the command line does, with the checks and messages of
/// the scene language; throws Error.
void apply_render_override(RenderSettings& settings, std::string_view key, std::string_view value);

/// The same for the keys of both tables: "exposure" and "tone" are the film's.
void apply_override(RenderSettings& render, FilmSettings& film, std::string_view key,
                    std::string_view value);

/// Every key of both tables and its value as --render takes it, empty where there is none: what
/// `apply_override` turns into the same settings.
std::vector<std::pair<std::string, std::string>> setting_texts(const RenderSettings& render,
                                                               const FilmSettings& film);

}  // namespace lapidary::description
