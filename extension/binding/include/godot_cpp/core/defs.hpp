#pragma once

#include <cstddef>
#include <cstdint>

// Macros and names for every header of the binding.

// Not defined by godot-cpp.
#define GODOT_BUNDLED_BINDING

#ifndef _FORCE_INLINE_
#define _FORCE_INLINE_ inline
#endif
#ifndef GDE_EXPORT
#if defined(_WIN32)
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif
#endif
#if defined(__GNUC__)
#define likely(m_condition) __builtin_expect(!!(m_condition), 1)
#define unlikely(m_condition) __builtin_expect(!!(m_condition), 0)
#else
#define likely(m_condition) (m_condition)
#define unlikely(m_condition) (m_condition)
#endif

namespace godot {

// The engine's vectors have 32-bit reals. For double precision see the README.
using real_t = float;

// Declared for every header.
class String;
class StringName;
class NodePath;
class Vector2;
class Vector2i;
class Vector3;
class Vector3i;
class Vector4;
class Vector4i;
class Rect2;
class Rect2i;
class Plane;
class Quaternion;
class AABB;
class Basis;
class Transform2D;
class Transform3D;
class Projection;
class Color;
class RID;
class Callable;
class Signal;
class Array;
class Dictionary;
class PackedByteArray;
class PackedInt32Array;
class PackedInt64Array;
class PackedFloat32Array;
class PackedFloat64Array;
class PackedStringArray;
class PackedVector2Array;
class PackedVector3Array;
class PackedVector4Array;
class PackedColorArray;
class Variant;
class Object;

namespace internal {

// Tag of constructors that leave the bytes uninitialized, for the engine to fill.
struct Uninitialized {};

/// One of the sizes of a type of the engine with pointers of 32 and of 64 bits.
constexpr size_t size_of(size_t with_32, size_t with_64) {
	return sizeof(void *) == 4 ? with_32 : with_64;
}

constexpr size_t alignment_of(size_t size) {
	return size % 8 == 0 ? 8 : 4;
}

} // namespace internal

} // namespace godot
