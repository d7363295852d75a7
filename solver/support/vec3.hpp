#pragma once

#include <cmath>
#include <cstring>

namespace slfb {

/// A vector of three components; plain doubles, so that the compiler keeps it in registers.
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};
inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }

/// A vector and a scalar w that is used with it: half a cache line, which one access to a sphere or a pair reads.
struct alignas(32) Vec4 {
  double x = 0.0, y = 0.0, z = 0.0, w = 0.0;
  [[nodiscard]] Vec3 vector() const { return {x, y, z}; }
  void set(Vec3 v) { x = v.x, y = v.y, z = v.z; }
  void add(Vec3 v) { x += v.x, y += v.y, z += v.z; }
};

/// Four numbers in one vector register: a Vec4, or one component of four of them.
using Pack = double __attribute__((vector_size(32)));

inline Pack load(const double* from) {
  Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}
inline void store(double* to, Pack pack) { std::memcpy(to, &pack, sizeof pack); }
inline Pack load(const Vec4& from) { return load(&from.x); }
inline void store(Vec4& to, Pack pack) { store(&to.x, pack); }

/// Turns four Vec4 into their x, y, z and w, and back.
inline void transpose(Pack& a, Pack& b, Pack& c, Pack& d) {
  const Pack ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Pack cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace slfb
