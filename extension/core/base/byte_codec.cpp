#include "base/byte_codec.hpp"

#include <algorithm>
#include <cstring>

namespace undergrowth {

namespace {

constexpr std::size_t LETTERS = 4;
constexpr int VERSION_BYTES = 2;
constexpr int LENGTH_BYTES = 4;
constexpr std::size_t LENGTH_AT = LETTERS + VERSION_BYTES;
constexpr int COUNT_BITS = 7;
constexpr std::size_t LONGEST_TEXT = 255;

} // namespace

void put_number(std::vector<uint8_t> &to, uint64_t value, int bytes) {
	for (int i = 0; i < bytes; i++) {
		to.push_back(static_cast<uint8_t>(value >> (8 * i)));
	}
}

void put_float(std::vector<uint8_t> &to, float value) {
	uint32_t bits = 0;
	std::memcpy(&bits, &value, sizeof(bits));
	put_number(to, bits, sizeof(bits));
}

void put_double(std::vector<uint8_t> &to, double value) {
	uint64_t bits = 0;
	std::memcpy(&bits, &value, sizeof(bits));
	put_number(to, bits, sizeof(bits));
}

void put_count(std::vector<uint8_t> &to, uint64_t value) {
	for (; value >> COUNT_BITS != 0; value >>= COUNT_BITS) {
		to.push_back(static_cast<uint8_t>(value | 0x80));
	}
	to.push_back(static_cast<uint8_t>(value));
}

void put_text(std::vector<uint8_t> &to, const std::string &text) {
	const std::size_t length = std::min(text.size(), LONGEST_TEXT);
	put_number(to, length, 1);
	to.insert(to.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
}

uint32_t checksum_of(const uint8_t *bytes, std::size_t count) {
	uint32_t hash = 0x811c9dc5u;
	for (std::size_t i = 0; i < count; i++) {
		hash = (hash ^ bytes[i]) * 0x01000193u;
	}
	return hash;
}

uint64_t ByteReader::number(int bytes) {
	has_all = has_all && left >= static_cast<std::size_t>(bytes);
	uint64_t value = 0;
	for (int i = 0; i < bytes && has_all; i++, left--) {
		value |= static_cast<uint64_t>(*next++) << (8 * i);
	}
	return value;
}

float ByteReader::real() {
	const auto bits = static_cast<uint32_t>(number(sizeof(float)));
	float value = 0.0f;
	std::memcpy(&value, &bits, sizeof(value));
	return value;
}

double ByteReader::long_real() {
	const uint64_t bits = number(sizeof(double));
	double value = 0.0;
	std::memcpy(&value, &bits, sizeof(value));
	return value;
}

uint64_t ByteReader::count() {
	uint64_t value = 0;
	for (int shift = 0; has_all; shift += COUNT_BITS) {
		const uint64_t byte = number(1);
		has_all = has_all && shift < 64;
		value |= has_all ? (byte & 0x7f) << shift : 0;
		if (byte < 0x80) {
			break;
		}
	}
	return has_all ? value : 0;
}

std::string ByteReader::text() {
	const auto length = static_cast<std::size_t>(number(1));
	has_all = has_all && left >= length;
	if (!has_all) {
		return {};
	}
	const std::string made(next, next + length);
	next += length;
	left -= length;
	return made;
}

std::vector<uint8_t> ByteFrame::begin(const char (&letters)[5], uint32_t version) {
	std::vector<uint8_t> bytes(letters, letters + LETTERS);
	put_number(bytes, version, VERSION_BYTES);
	put_number(bytes, 0, LENGTH_BYTES); // The length; seal() writes it.
	return bytes;
}

void ByteFrame::seal(std::vector<uint8_t> &bytes) {
	const std::size_t length = bytes.size() + CHECKSUM;
	for (int i = 0; i < LENGTH_BYTES; i++) {
		bytes[LENGTH_AT + static_cast<std::size_t>(i)] = static_cast<uint8_t>(length >> (8 * i));
	}
	put_number(bytes, checksum_of(bytes.data(), bytes.size()), CHECKSUM);
}

BytesFault ByteFrame::check(const char (&letters)[5], uint32_t version, const uint8_t *bytes, std::size_t count) {
	if (count < LETTERS || std::memcmp(bytes, letters, LETTERS) != 0) {
		return BytesFault::other_kind;
	}
	ByteReader header(bytes + LETTERS, count - LETTERS);
	const uint64_t stored_version = header.number(VERSION_BYTES);
	const uint64_t length = header.number(LENGTH_BYTES);
	if (header.is_sound() && stored_version > version) {
		return BytesFault::later_version;
	}
	if (!header.is_sound() || stored_version != version || length != count || count < HEADER + CHECKSUM) {
		return BytesFault::torn;
	}
	const uint64_t stored = ByteReader(bytes + count - CHECKSUM, CHECKSUM).number(CHECKSUM);
	return stored == checksum_of(bytes, count - CHECKSUM) ? BytesFault::none : BytesFault::torn;
}

} // namespace undergrowth
