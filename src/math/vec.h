#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lapidary {

/// A pair; components by name or index.
template <typename T>
struct Vec2 {
  T x{}, y{};

  constexpr T operator[](std::size_t i) const { return i == 0 ? x : y; }
  constexpr T& operator[](std::size_t i) { return i == 0 ? x : y; }
  constexpr bool operator==(const Vec2&) const = default;
};

template <typename T>
constexpr Vec2<T> operator+(Vec2<T> a, Vec2<T> b) {
  return {a.x + b.x, a.y + b.y};
}
template <typename T>
constexpr Vec2<T> operator-(Vec2<T> a, Vec2<T> b) {
  return {a.x - b.x, a.y - b.y};
}
template <typename T>
constexpr Vec2<T> operator*(Vec2<T> a, T s) {
  return {a.x * s, a.y * s};
}
template <typename T>
constexpr Vec2<T> operator*(T s, Vec2<T> a) {
  return a * s;
}

/// A point, a direction or a normal: which one, the name of the variable says.
template <typename T>
struct Vec3 {
  T x{}, y{}, z{};

  constexpr Vec3() = default;
  constexpr Vec3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  template <typename U>
  constexpr explicit Vec3(const Vec3<U>& v)
      : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}

  constexpr T operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr bool operator==(const Vec3&) const = default;

  constexpr Vec3& operator+=(Vec3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3& operator-=(Vec3 b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  constexpr Vec3& operator*=(T s) { return *this = {x * s, y * s, z * s}; }
};

template <typename T>
constexpr Vec3<T> operator+(Vec3<T> a, Vec3<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename T>
constexpr Vec3<T> operator-(Vec3<T> a, Vec3<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename T>
constexpr Vec3<T> operator-(Vec3<T> a) {
  return {-a.x, -a.y, -a.z};
}
template <typename T>
constexpr Vec3<T> operator*(Vec3<T> a, T s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <typename T>
constexpr Vec3<T> operator*(T s, Vec3<T> a) {
  return a * s;
}
template <typename T>
constexpr Vec3<T> operator/(Vec3<T> a, T s) {
  return {a.x / s, a.y / s, a.z / s};
}

template <typename T>
constexpr T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T>
constexpr T length_squared(Vec3<T> a) {
  return dot(a, a);
}
template <typename T>
T length(Vec3<T> a) {
  return std::sqrt(dot(a, a));
}
/// `a` must not be zero.
template <typename T>
Vec3<T> normalize(Vec3<T> a) {
  return a * (T(1) / length(a));
}
template <typename T>
constexpr Vec3<T> min(Vec3<T> a, Vec3<T> b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <typename T>
constexpr Vec3<T> max(Vec3<T> a, Vec3<T> b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
template <typename T>
Vec3<T> abs(Vec3<T> a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
template <typename T>
constexpr T max_component(Vec3<T> a) {
  return std::max(std::max(a.x, a.y), a.z);
}
template <typename T>
bool is_finite(Vec3<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;
using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;

}  // namespace lapidary
