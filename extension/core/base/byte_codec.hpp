#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace undergrowth {

// Numbers as bytes, little-endian, the same on every machine.

/// Appends the lower `bytes` bytes of a number.
void put_number(std::vector<uint8_t> &to, uint64_t value, int bytes);
/// Appends the bits of a float.
void put_float(std::vector<uint8_t> &to, float value);
/// The same of a double.
void put_double(std::vector<uint8_t> &to, double value);
/// Appends seven bits a byte, the lowest first; all but the last byte have their highest bit set.
void put_count(std::vector<uint8_t> &to, uint64_t value);
/// Appends at most 255 bytes of a text, after their number (8 bits).
void put_text(std::vector<uint8_t> &to, const std::string &text);

/// FNV-1a, 32 bits.
uint32_t checksum_of(const uint8_t *bytes, std::size_t count);

/// Reads numbers in sequence. A missing number is 0 and makes is_sound() false from there on.
class ByteReader {
public:
	ByteReader(const uint8_t *from, std::size_t count) : next(from), left(count) {}

	uint64_t number(int bytes);
	float real();
	double long_real();
	uint64_t count();
	std::string text();

	/// True if no number was missing.
	bool is_sound() const { return has_all; }
	std::size_t rest() const { return left; }
	/// Marks the bytes as invalid.
	void fail() { has_all = false; }

private:
	const uint8_t *next;
	std::size_t left;
	bool has_all = true;
};

/// Why bytes are not valid.
enum class BytesFault {
	none,
	other_kind, ///< Bytes of another kind, or foreign bytes.
	later_version, ///< Written by a later release.
	torn, ///< Cut off or changed.
};

/// The frame of all saved bytes: four letters, the version (16 bits), the total length (32 bits), the content, and
/// checksum_of() everything before it (32 bits).
class ByteFrame {
public:
	static constexpr std::size_t HEADER = 10;
	static constexpr std::size_t CHECKSUM = 4;

	/// Returns the beginning; the caller appends the content.
	static std::vector<uint8_t> begin(const char (&letters)[5], uint32_t version);
	/// Writes length and checksum.
	static void seal(std::vector<uint8_t> &bytes);
	/// Checks letters, version, length and checksum.
	static BytesFault check(const char (&letters)[5], uint32_t version, const uint8_t *bytes, std::size_t count);
	/// Reads the content. Precondition: check() found no fault.
	static ByteReader inside(const uint8_t *bytes, std::size_t count) {
		return ByteReader(bytes + HEADER, count - HEADER - CHECKSUM);
	}
};

} // namespace undergrowth
