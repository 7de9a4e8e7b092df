#pragma once

#include "mesh/card_strip.hpp"
#include "mesh/form_body.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/part_attachment.hpp"
#include "mesh/part_template.hpp"
#include "mesh/plant_mesh.hpp"
#include "mesh/vertex_format.hpp"

namespace undergrowth {

/// Writes parts and bodies into the buffers of a mesh, in the order of the calls.
class FormWriter {
public:
	/// All arguments must outlive the object. `bones`: bones of vertices besides root and tip.
	FormWriter(const PlantForm &form, const FormBones &bones, const MeshOptions &options, const FormBuffers &buffers);

	void add_part(const PlacedPart &part, const PartAttachment &attachment, const PartTemplate &shape);
	/// The rings must have positions from DrawnAttachments.
	void add_body(const FormBody &body);
	void add_strip(const CardStrip &strip);

	/// Present size of the mesh.
	struct Mark {
		int vertex;
		int index;
	};
	Mark mark() const { return { vertices, indices }; }
	/// Scales everything along y. Call it last.
	void stretch(float factor);
	/// Returns the factor of width with which everything written from `begin` to `end` has a mean area of `shown` m²
	/// from the side, at most MAX_WIDENING. `near_share`: visible fraction of its triangles.
	float needed_width(const Mark &begin, const Mark &end, float shown, float near_share) const;
	void widen(const Mark &begin, const Mark &end, float factor);
	static constexpr float MAX_WIDENING = 12.0f;

private:
	static constexpr int HEIGHTS = 32;

	/// Data that all vertices of one part or body share.
	struct Common {
		PartAttachment attachment;
		PartMotionCode swing;
		float leafiness;
		float veins; ///< Code of the venation.
		float brightness;
	};

	const PlantForm &form;
	const FormBones &skeleton;
	const FormBuffers &out;
	const float color_deviation;
	float light[HEIGHTS + 2]; ///< Light at each height of the plant.
	int vertices = 0;
	int indices = 0;

	void put(const Common &common, const glm::vec3 &middle, const glm::vec3 &aside, const glm::vec3 &normal,
			const glm::vec3 &along, const glm::vec4 &color, glm::vec2 uv, float offset);
	float openness(const glm::vec3 &point) const;
	void put_index(int index) { out.indices[indices++] = index; }
};

} // namespace undergrowth
