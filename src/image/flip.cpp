#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lapidary::image {
namespace {

constexpr double pixels_per_degree = 67;

using Color = std::array<float, 3>;
using Matrix = std::array<Color, 3>;

/// Linear sRGB to XYZ and back (IEC 61966-2-1); the white is the sum of the columns.
constexpr Matrix xyz_from_rgb = {{{0.41238656f, 0.35759149f, 0.18045049f},
                                  {0.21263682f, 0.71518298f, 0.07218020f},
                                  {0.01933062f, 0.11919716f, 0.95037259f}}};
constexpr Matrix rgb_from_xyz = {{{3.241003275f, -1.537398934f, -0.498615861f},
                                  {-0.969224334f, 1.875930071f, 0.041554224f},
                                  {0.055639423f, -0.204011202f, 1.057148933f}}};
constexpr Color white = {0.95042854f, 1.0f, 1.08890037f};

constexpr Color operator*(const Matrix& m, const Color& v) {
  Color result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  }
  return result;
}

/// CIELAB without its non-linearity, an opponent space in which light adds.
Color ycxcz_from_rgb(const Color& rgb) {
  const Color xyz = xyz_from_rgb * rgb;
  const float x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
  return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

Color rgb_from_ycxcz(const Color& c) {
  const float y = (c[0] + 16.0f) / 116.0f;
  return rgb_from_xyz *
         Color{(y + c[1] / 500.0f) * white[0], y * white[1], (y - c[2] / 200.0f) * white[2]};
}

/// CIELAB with the Hunt effect: colour shows less in the dark (section 4.1, "Hunt-adjusted").
Color hunt_lab_from_rgb(const Color& rgb) {
  constexpr float delta = 6.0f / 29.0f;
  const auto f = [](float t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
  };
  const Color xyz = xyz_from_rgb * rgb;
  const float x = f(xyz[0] / white[0]), y = f(xyz[1] / white[1]), z = f(xyz[2] / white[2]);
  const float lightness = 116.0f * y - 16.0f;
  const float hunt = 0.01f * lightness;
  return {lightness, hunt * 500.0f * (x - y), hunt * 200.0f * (y - z)};
}

/// Abasi et al. 2019: for large differences better than the Euclidean distance.
float hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// One number for each pixel of the crop.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane(int width_, int height_)
      : width(width_), height(height_), values(static_cast<std::size_t>(width_) * height_) {}
};

using Planes = std::array<Plane, 3>;

/// A filter along one axis, 2 * radius + 1 weights.
using Kernel = std::vector<float>;

/// out += weight * in, for as many numbers as a row has.
void add_row(float* out, const float* in, int count, float weight) {
  for (int x = 0; x < count; ++x) out[x] += weight * in[x];
}

/// Convolution along rows; beyond the border the border pixel goes on.
Plane convolved_x(const Plane& in, const Kernel& kernel) {
  const std::size_t radius = kernel.size() / 2;
  const auto width = static_cast<std::size_t>(in.width);
  std::vector<float> padded(width + 2 * radius);
  Plane out(in.width, in.height);
  for (std::size_t row = 0; row < in.values.size(); row += width) {
    const float* values = &in.values[row];
    std::fill_n(padded.begin(), radius, values[0]);
    std::copy_n(values, width, padded.data() + radius);
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, values[width - 1]);
    for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
      add_row(&out.values[row], &padded[tap], in.width, kernel[tap]);
    }
  }
  return out;
}

/// The same along columns.
Plane convolved_y(const Plane& in, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  const auto row_of = [&](int y) { return static_cast<std::size_t>(y) * in.width; };
  Plane out(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    for (int tap = -radius; tap <= radius; ++tap) {
      const std::size_t source = row_of(std::clamp(y + tap, 0, in.height - 1));
      add_row(&out.values[row_of(y)], &in.values[source], in.width,
              kernel[static_cast<std::size_t>(tap + radius)]);
    }
  }
  return out;
}

Plane convolved(const Plane& in, const Kernel& along_x, const Kernel& along_y) {
  return convolved_y(convolved_x(in, along_x), along_y);
}

/// Sampled on integers, times `factor`(x).
template <typename Function>
Kernel kernel_of(int radius, const Function& function) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(static_cast<float>(function(x)));
  return kernel;
}

/// One Gaussian of a contrast sensitivity function in the spatial domain: paper, equation 3.
struct Gaussian {
  double a;
  double b;
};

/// Table 1 of the paper, with the second Gaussian left out where its weight is 0.
constexpr Gaussian achromatic[] = {{1.0, 0.0047}};
constexpr Gaussian red_green[] = {{1.0, 0.0053}};
constexpr Gaussian blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double widest = 0.04;

/// Blurs away what the eye cannot resolve: a sum of separable Gaussians of total weight 1.
Plane seen(const Plane& in, std::span<const Gaussian> sensitivity) {
  constexpr double pi = std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
  double total = 0;
  std::vector<Kernel> kernels;
  std::vector<double> weights;
  for (const Gaussian& gaussian : sensitivity) {
    const auto value = [&](int x) {
      const double degrees = x / pixels_per_degree;
      return std::exp(-pi * pi * degrees * degrees / gaussian.b);
    };
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) sum += value(x);
    kernels.push_back(kernel_of(radius, [&](int x) { return value(x) / sum; }));
    weights.push_back(gaussian.a * std::sqrt(pi / gaussian.b) * sum * sum);
    total += weights.back();
  }
  Plane out(in.width, in.height);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const Plane blurred = convolved(in, kernels[i], kernels[i]);
    const auto weight = static_cast<float>(weights[i] / total);
    for (std::size_t p = 0; p < out.values.size(); ++p) out.values[p] += weight * blurred.values[p];
  }
  return out;
}

/// Scales positive and negative weights to the sums 1 and -1 (section 4.3).
Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (float& weight : kernel) {
    weight = static_cast<float>(weight / (weight > 0 ? positive : -negative));
  }
  return kernel;
}

/// How strong edges and points are at each pixel of the luminance in [0, 1].
struct Features {
  Plane edges;
  Plane points;
};

Plane magnitude(const Plane& in, const Kernel& across, const Kernel& along) {
  Plane x = convolved(in, across, along);
  const Plane y = convolved(in, along, across);
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    x.values[i] = std::hypot(x.values[i], y.values[i]);
  }
  return x;
}

Features features_of(const Plane& luminance) {
  constexpr double width = 0.082;  // of the eye's feature detectors, in degrees, peak to trough
  const double sigma = 0.5 * width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto gauss = [&](int x) { return std::exp(-x * x / (2 * sigma * sigma)); };
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) sum += gauss(x);
  const Kernel smooth = kernel_of(radius, [&](int x) { return gauss(x) / sum; });
  const Kernel slope = balanced(kernel_of(radius, [&](int x) { return -x * gauss(x); }));
  const Kernel bump =
      balanced(kernel_of(radius, [&](int x) { return (x * x / (sigma * sigma) - 1) * gauss(x); }));
  return {magnitude(luminance, slope, smooth), magnitude(luminance, bump, smooth)};
}

/// What a viewer sees of one image: its features, and its colours after the eye's blur.
struct Perceived {
  Features features;
  Planes lab;
};

/// NaN is black.
float on_display(float light) {
  return light > 0 ? std::min(light, 1.0f) : 0.0f;
}

Planes opponent_planes(const Image& image, const Crop& crop) {
  const Plane empty(crop.width, crop.height);
  Planes planes = {empty, empty, empty};
  std::size_t at = 0;
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    for (int x = crop.x; x < crop.x + crop.width; ++x, ++at) {
      const Rgb light = image.rgb(x, y);
      const Color color =
          ycxcz_from_rgb({on_display(light.r), on_display(light.g), on_display(light.b)});
      for (std::size_t c = 0; c < 3; ++c) planes[c].values[at] = color[c];
    }
  }
  return planes;
}

Perceived perceived(const Image& image, const Crop& crop) {
  Planes planes = opponent_planes(image, crop);
  Plane luminance = planes[0];
  for (float& value : luminance.values) value = (value + 16.0f) / 116.0f;
  Features features = features_of(luminance);

  planes[0] = seen(planes[0], achromatic);
  planes[1] = seen(planes[1], red_green);
  planes[2] = seen(planes[2], blue_yellow);
  for (std::size_t i = 0; i < luminance.values.size(); ++i) {
    Color rgb = rgb_from_ycxcz({planes[0].values[i], planes[1].values[i], planes[2].values[i]});
    for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
    const Color lab = hunt_lab_from_rgb(rgb);
    for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = lab[c];
  }
  return {std::move(features), std::move(planes)};
}

/// Colour differences in [0, 1], small ones spread over most of it (section 4.2).
float color_error(const Color& a, const Color& b) {
  constexpr float exponent = 0.7f;
  constexpr float knee = 0.4f, knee_error = 0.95f;
  // The largest difference on a display is that of pure green and pure blue.
  static const float largest =
      std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), exponent);
  const float share = std::pow(hyab(a, b), exponent) / largest;
  if (share < knee) return share * (knee_error / knee);
  return knee_error + (share - knee) / (1.0f - knee) * (1.0f - knee_error);
}

float feature_error(const Features& a, const Features& b, std::size_t i) {
  const float difference = std::max(std::abs(a.edges.values[i] - b.edges.values[i]),
                                    std::abs(a.points.values[i] - b.points.values[i]));
  return std::sqrt(difference * static_cast<float>(1 / std::numbers::sqrt2));
}

}  // namespace

std::vector<float> flip_map(const Image& image, const Image& reference, const Crop& crop) {
  const Perceived a = perceived(image, crop);
  const Perceived b = perceived(reference, crop);
  std::vector<float> errors(a.lab[0].values.size());
  const auto color = [](const Planes& lab, std::size_t i) {
    return Color{lab[0].values[i], lab[1].values[i], lab[2].values[i]};
  };
  for (std::size_t i = 0; i < errors.size(); ++i) {
    // Both can exceed 1 by rounding.
    const float by_color = std::min(color_error(color(a.lab, i), color(b.lab, i)), 1.0f);
    const float by_feature = std::min(feature_error(a.features, b.features, i), 1.0f);
    errors[i] = std::pow(by_color, 1.0f - by_feature);
  }
  return errors;
}

}  // namespace lapidary::image
