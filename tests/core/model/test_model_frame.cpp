#include "model_fixture.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace undergrowth;

namespace {

const glm::mat3 TO_Z_UP = { { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { 0.0f, -1.0f, 0.0f } };

ModelFrame frame_of(const MadeSurface &made, const ModelFrameOptions &options = {}) {
	return find_model_frame({ made.surface() }, options);
}

float lowest(const MadeSurface &made, const ModelFrame &frame) {
	float least = 1e9f;
	for (const glm::vec3 &position : made.positions) {
		least = std::min(least, frame.place_of(position).y);
	}
	return least;
}

} // namespace

TEST_CASE("model: a file in metres with y up and its origin at the base stays as it is") {
	const MadeSurface made = leafy_stem();
	const ModelFrame frame = frame_of(made);
	CHECK(frame.up == UpAxis::plus_y);
	CHECK(frame.scale == 1.0f);
	CHECK(frame.height == doctest::Approx(0.8f).epsilon(0.02));
	CHECK(glm::distance(frame.place_of(made.positions[7]), made.positions[7]) < 1e-6f);
}

TEST_CASE("model: z up is found by an origin at the base, and by a base narrower than a side") {
	MadeSurface made = leafy_stem();
	made.transform(TO_Z_UP);
	CHECK(frame_of(made).up == UpAxis::plus_z);
	CHECK(frame_of(made).height == doctest::Approx(0.8f).epsilon(0.02));
	made.transform(glm::mat3(1.0f), glm::vec3(3.0f, -2.0f, -0.4f));
	CHECK(frame_of(made).up == UpAxis::plus_z);
}

TEST_CASE("model: an origin off the base moves to the middle of the base, a buried part stays below the ground") {
	MadeSurface made = leafy_stem();
	made.transform(glm::mat3(1.0f), glm::vec3(2.0f, -0.4f, 1.0f));
	const ModelFrame frame = frame_of(made);
	CHECK(lowest(made, frame) == doctest::Approx(0.0f));
	CHECK(glm::length(frame.place_of(glm::vec3(2.0f, -0.4f, 1.0f))) < 0.01f);
	MadeSurface buried = leafy_stem();
	buried.transform(glm::mat3(1.0f), glm::vec3(0.0f, -0.05f, 0.0f));
	CHECK(lowest(buried, frame_of(buried)) == doctest::Approx(-0.05f));
}

TEST_CASE("model: centimetres, millimetres and units of 100 m are scaled, and a height overrides them") {
	for (const float unit : { 100.0f, 0.01f }) {
		MadeSurface made = leafy_stem();
		made.transform(unit * glm::mat3(1.0f));
		CHECK(frame_of(made).height == doctest::Approx(0.8f).epsilon(0.02));
	}
	MadeSurface tall = leafy_stem();
	tall.transform(3000.0f * glm::mat3(1.0f));
	CHECK(frame_of(tall).height == doctest::Approx(2.4f).epsilon(0.02));
	ModelFrameOptions options;
	options.height = 1.7f;
	CHECK(frame_of(leafy_stem(), options).height == doctest::Approx(1.7f));
}

TEST_CASE("model: turns are rotations, so that textures and normals are not mirrored") {
	for (const UpAxis up :
			{ UpAxis::plus_y, UpAxis::minus_y, UpAxis::plus_z, UpAxis::minus_z, UpAxis::plus_x, UpAxis::minus_x }) {
		ModelFrameOptions options;
		options.up = up;
		const glm::mat3 turn = frame_of(leafy_stem(), options).turn;
		CHECK(glm::dot(glm::cross(turn[0], turn[1]), turn[2]) == doctest::Approx(1.0f));
	}
}

TEST_CASE("model: faults are found in their order and say what to do") {
	MadeSurface made = leafy_stem();
	CHECK(find_model_fault({ made.surface() }) == ModelFault::none);
	CHECK(find_model_fault({}) == ModelFault::no_surface);
	CHECK(find_model_fault({ made.surface(), MadeSurface().surface() }) == ModelFault::empty_surface);
	MadeSurface broken = made;
	broken.positions[5].y = std::numeric_limits<float>::quiet_NaN();
	CHECK(find_model_fault({ broken.surface() }) == ModelFault::not_finite);
	broken = made;
	broken.indices[4] = int32_t(broken.positions.size());
	CHECK(find_model_fault({ broken.surface() }) == ModelFault::bad_index);
	broken = made;
	broken.transform(glm::mat3(0.0f));
	CHECK(find_model_fault({ broken.surface() }) == ModelFault::no_height);
	CHECK(std::string(describe(ModelFault::not_finite)).find("Export") != std::string::npos);
}
