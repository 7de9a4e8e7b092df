#include "form_mesh_fixture.hpp"

#include "../form/form_species.hpp"
#include "motion/part_bend.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <set>

using namespace undergrowth;

namespace {

struct Grown {
	explicit Grown(PlantForm grown) :
			form(std::move(grown)),
			attachments(attach_parts(form)),
			bones(form, attachments),
			mesh(build(form, plan_form(form, measure_form(form), 2000), 0.0f, {}, bones)) {}
	PlantForm form;
	std::vector<PartAttachment> attachments;
	FormBones bones;
	BuiltForm mesh;
};

std::vector<Grown> all_plants() {
	std::vector<Grown> plants;
	plants.emplace_back(grow_grass(3));
	plants.emplace_back(grow_tulip(3));
	plants.emplace_back(grow_daisy(3));
	return plants;
}

/// True if two hangs are equal, in numbers and in the codes of vertices.
bool attached_alike(const PartAttachment &a, const PartAttachment &b) {
	return a.swinger == b.swinger && a.stem_offset == b.stem_offset && a.weight == b.weight && a.pivot == b.pivot &&
			a.code.pace == b.code.pace && a.code.place == b.code.place;
}

/// Position of a vertex in the shaders of fields.
glm::vec3 shaded(const BuiltForm &mesh, size_t i, const StemMotion &stem) {
	glm::vec3 vertex = mesh.positions[i];
	if (mesh.custom0[i].y > 0.0f) {
		const glm::vec3 pivot(mesh.custom1[i]);
		const PartMotion swing = decode_part_motion({ mesh.custom1[i].w, mesh.custom2[i].w });
		const glm::vec2 bend = part_bend(swing, stem);
		vertex = pivot +
				(swing.is_head() ? turned(vertex - pivot, bend_at(bend, mesh.custom0[i].y))
								 : bent_way(vertex - pivot, bend, mesh.custom0[i].y));
	}
	return glm::mix(vertex, turned(vertex, stem.bend), mesh.custom0[i].x);
}

} // namespace

TEST_CASE("a skeleton has root, tip and at most 30 other bones with unique names") {
	for (const Grown &plant : all_plants()) {
		CHECK(plant.bones.bones().size() > 1);
		CHECK(plant.bones.bones().size() <= FormBones::MAX_BONES - FormBones::FIRST);
		const std::vector<std::string> &names = plant.bones.names();
		CHECK(names.size() == plant.bones.bones().size());
		CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
	}
}

TEST_CASE("vertices are bound to four existing bones with weights that sum to 1 exactly") {
	for (const Grown &plant : all_plants()) {
		const int count = FormBones::FIRST + static_cast<int>(plant.bones.bones().size());
		for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
			const float *weights = plant.mesh.weights.data() + 4 * i;
			REQUIRE(weights[0] + weights[1] + weights[2] + weights[3] == 1.0f);
			for (size_t k = 4 * i; k < 4 * i + 4; k++) {
				REQUIRE((plant.mesh.weights[k] >= 0.0f && plant.mesh.bones[k] >= 0 && plant.mesh.bones[k] < count));
			}
		}
	}
}

TEST_CASE("a tulip has a bone for each leaf at its attachment, two for a long one, and one for its head") {
	const Grown plant(grow_tulip(3));
	const std::vector<std::string> &names = plant.bones.names();
	CHECK(std::count(names.begin(), names.end(), "head") == 1);
	for (size_t i = 0; i < plant.attachments.size(); i++) {
		const PlacedPart &part = plant.form.placed[i];
		if (!plant.attachments[i].swings) {
			continue;
		}
		int own = 0;
		for (const PartBone &bone : plant.bones.bones()) {
			own += bone.pivot == part.base && !bone.swing.is_head() ? 1 : 0;
		}
		CHECK(own == (part.length > FormBones::LONG ? 2 : 1));
	}
}

TEST_CASE("a tuft of many blades has bones for eighths of the circle") {
	const Grown plant(grow_grass(3));
	int blades = 0;
	for (const PartAttachment &attachment : plant.attachments) {
		blades += attachment.is_root && attachment.swings ? 1 : 0;
	}
	CHECK(blades > FormBones::MAX_TUFT_BONES);
	for (const std::string &name : plant.bones.names()) {
		CHECK((name.rfind("tuft_", 0) == 0 || name.rfind("lying_", 0) == 0 || name.rfind("leaf_", 0) == 0));
	}
}

TEST_CASE("without swinging parts a skeleton bends a plant like its stem alone") {
	StemMotion stem;
	stem.bend = stem.rest = { 0.2f, 0.1f }; // It leans.
	for (const Grown &plant : all_plants()) {
		float worst = 0.0f;
		for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
			worst = std::max(
					worst, glm::distance(skinned(plant.mesh, plant.bones, i, stem), shaded(plant.mesh, i, stem)));
		}
		CHECK(worst < 0.02f * plant.form.height);
	}
}

TEST_CASE("a skeleton shows the same swing of leaves and heads as shaders") {
	StemMotion stem;
	stem.bend = { 0.15f, -0.05f };
	stem.rate = { -0.6f, 0.3f };
	stem.clock = 0.123f;
	const Grown plant(grow_tulip(3));
	float worst = 0.0f;
	float max = 0.0f;
	for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
		StemMotion stiff = stem;
		stiff.rest = stem.bend;
		stiff.rate = glm::vec2(0.0f);
		const glm::vec3 shown = shaded(plant.mesh, i, stem);
		worst = std::max(worst, glm::distance(skinned(plant.mesh, plant.bones, i, stem), shown));
		max = std::max(max, glm::distance(shaded(plant.mesh, i, stiff), shown));
	}
	CHECK(max > 0.05f * plant.form.height);
	CHECK(worst < 0.1f * max);
}

TEST_CASE("the base of a swinging leaf stays on its stem") {
	StemMotion stem;
	stem.bend = { 0.3f, -0.2f };
	stem.rate = { -2.0f, 1.0f };
	for (const Grown &plant : all_plants()) {
		for (const PartBone &bone : plant.bones.bones()) {
			const PartPose pose = pose_of(bone, stem);
			const glm::quat turn(pose.turn.w, pose.turn.x, pose.turn.y, pose.turn.z);
			const glm::vec3 on_stem = glm::mix(bone.pivot, turned(bone.pivot, stem.bend), bone.stem_offset);
			CHECK(glm::distance(pose.shift + pose.size * (turn * bone.pivot), on_stem) < 1e-5f);
		}
	}
}

TEST_CASE("leaves stay on a stem with few rows at any bend") {
	const PlantForm form = grow_tulip(3);
	int found = 0;
	for (const int budget : { 150, 400, 800 }) {
		const BuiltForm mesh = build(form, plan_form(form, measure_form(form), budget));
		StemMotion stem;
		stem.bend = stem.rest = { 0.4f, 0.1f };
		// The drawn centre of the stem at each of its rows.
		std::vector<std::pair<float, glm::vec3>> rows;
		for (size_t i = 0; i < mesh.positions.size() && mesh.custom0[i].y == 0.0f; i++) {
			const glm::vec3 middle = mesh.positions[i] - glm::vec3(mesh.custom2[i]);
			if (rows.empty() || middle.y > rows.back().first + 1e-4f) {
				rows.emplace_back(middle.y, glm::mix(middle, turned(middle, stem.bend), mesh.custom0[i].x));
			}
		}
		for (size_t i = 0; i < mesh.positions.size(); i++) {
			const glm::vec3 pivot(mesh.custom1[i]);
			for (size_t k = 1; k < rows.size() && mesh.custom0[i].y > 0.0f && mesh.custom0[i].x < 0.5f; k++) {
				if (pivot.y >= rows[k - 1].first && pivot.y < rows[k].first) {
					const float t = (pivot.y - rows[k - 1].first) / (rows[k].first - rows[k - 1].first);
					const glm::vec3 drawn = glm::mix(rows[k - 1].second, rows[k].second, t);
					const glm::vec3 base = glm::mix(pivot, turned(pivot, stem.bend), mesh.custom0[i].x);
					CHECK(glm::distance(drawn, base) < 0.012f * form.height);
					found++;
				}
			}
		}
	}
	CHECK(found > 20);
}

TEST_CASE("bones follow a plant that is stretched") {
	const Grown plant(grow_tulip(3));
	const std::vector<PartBone> tall = plant.bones.stretched(1.5f);
	for (size_t i = 0; i < tall.size(); i++) {
		CHECK(tall[i].origin == plant.bones.bones()[i].origin * glm::vec3(1.0f, 1.5f, 1.0f));
		CHECK(tall[i].pivot == plant.bones.bones()[i].pivot * glm::vec3(1.0f, 1.5f, 1.0f));
	}
}

TEST_CASE("the measure of a form has the hang of its parts, encoded as for vertices") {
	for (const Grown &plant : all_plants()) {
		const std::vector<PartAttachment> measured = measure_form(plant.form).attachments;
		REQUIRE(measured.size() == plant.attachments.size());
		for (size_t i = 0; i < measured.size(); i++) {
			const PartMotionCode code = encode_part_motion(measured[i].swing);
			CHECK(attached_alike(measured[i], plant.attachments[i]));
			CHECK(measured[i].code.pace == code.pace);
			CHECK(measured[i].code.place == code.place);
		}
	}
}
