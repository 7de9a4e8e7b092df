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

/// Reads numbers one after the other; whatever is missing makes it fail from there on, and is 0.
class ByteReader {
public:
	ByteReader(const uint8_t *from, std::size_t count) : next(from), left(count) {}

	uint64_t number(int bytes);
	float real();
	double long_real();
	uint64_t count();
	std::string text();

	/// Whether all was there that was asked for.
	bool is_sound() const { return has_all; }
	std::size_t rest() const { return left; }
	/// Whoever reads found something that cannot be.
	void fail() { has_all = false; }

private:
	const uint8_t *next;
	std::size_t left;
	bool has_all = true;
};

/// Why bytes of a kind are not what they should be.
enum class BytesFault {
	none,
	other_kind, ///< Or nothing of ours.
	later_version, ///< Written by a later release.
	torn, ///< Cut off, or not as they were written.
};

/// How all that is kept as bytes begins and ends: four letters, the version (16 bits), the length of all (32 bits),
/// what is kept, and checksum_of() all before (32 bits).
class ByteFrame {
public:
	static constexpr std::size_t HEADER = 10;
	static constexpr std::size_t CHECKSUM = 4;

	/// The beginning, to be appended to.
	static std::vector<uint8_t> begin(const char (&letters)[5], uint32_t version);
	/// The end.
	static void seal(std::vector<uint8_t> &bytes);
	/// Whether whole bytes of these letters, of this version, are between beginning and end.
	static BytesFault check(const char (&letters)[5], uint32_t version, const uint8_t *bytes, std::size_t count);
	/// What is between; check() has found no fault.
	static ByteReader inside(const uint8_t *bytes, std::size_t count) {
		return ByteReader(bytes + HEADER, count - HEADER - CHECKSUM);
	}
};

} // namespace undergrowth
