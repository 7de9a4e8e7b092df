#include "plant/part_motion.hpp"

#include "motion/bend_encoding.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

TEST_CASE("a swing survives encoding and decoding, approximately") {
	for (int i = 0; i < 400; i++) {
		const float t = static_cast<float>(i) / 400.0f;
		PartMotion swing;
		swing.frequency = 0.125f * std::pow(2.0f, 7.9f * t);
		swing.damping_ratio = 2.0f * t * t;
		swing.phase = std::fmod(7.3f * t, 1.0f);
		swing.side = { std::cos(40.0f * t), std::sin(40.0f * t) };
		const PartMotion read = decode_part_motion(encode_part_motion(swing));
		CHECK(read.frequency == doctest::Approx(swing.frequency).epsilon(0.032));
		CHECK(std::abs(std::sqrt(read.damping_ratio / 2.0f) - t) < 0.017f);
		const float turns = read.phase - swing.phase;
		CHECK(std::abs(turns - std::round(turns)) <= 1.0f / 64.0f + 1e-5f);
		CHECK(glm::dot(read.side, swing.side) > 0.994f);
		CHECK(read.room == doctest::Approx(0.32f));
	}
}

TEST_CASE("codes of swings survive half floats unchanged") {
	PartMotion swing;
	for (int i = 0; i < 500; i++) {
		const float t = static_cast<float>(i) / 500.0f;
		swing.frequency = 100.0f * t;
		swing.damping_ratio = 100.0f * t * t;
		swing.phase = 3.0f * t;
		swing.side = { std::cos(9.0f * t), std::sin(9.0f * t) };
		swing.room = t;
		const PartMotionCode code = encode_part_motion(swing);
		CHECK(from_half(to_half(code.pace)) == code.pace);
		CHECK(from_half(to_half(code.place)) == code.place);
		const PartMotionCode again = encode_part_motion(decode_part_motion(code));
		CHECK(again.pace == code.pace);
		CHECK(again.place == code.place);
	}
}

TEST_CASE("all frequencies are whole numbers of swings in the clock's period") {
	for (int i = 0; i < 128; i++) {
		const float swings = decode_part_motion({ static_cast<float>(32 * i - 2048), 0.0f }).frequency * 128.0f;
		CHECK(swings == std::floor(swings));
		CHECK(swings >= 16.0f);
	}
}

TEST_CASE("a head has no side, and its code states that") {
	CHECK(decode_part_motion(encode_part_motion(PartMotion())).is_head());
	PartMotion leaf;
	leaf.side = { 0.0f, 1.0f };
	CHECK_FALSE(decode_part_motion(encode_part_motion(leaf)).is_head());
}
