#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

// What a vertex of a plant says, to shaders and to the engine. One format for how plants look and how they bend; the
// engine's names in capitals.
//
// VERTEX    m, in the plant's axes, at rest.
// NORMAL    of the true surface; of open sheets (blades, open tubes) the upper or outer side. The engine turns it round
//           on back faces, so both sides are lit. Blades lean it out towards their edges (BladeShape::roundness).
// TANGENT   along the part, from its base to its tip: the grain that anisotropic shine follows. w is 1.
// COLOR     rgb as the author wrote it; a: how much sky the place sees, 0 to 1 (less at the base and inside a tuft).
//           Materials take it for ambient occlusion, not for transparency.
// UV        x from 0 to 1 across a blade, or around a tube and back; y from 1 at a part's base to 0 at its tip.
// CUSTOM0   x: stem offset: where on the plant's stem the vertex hangs, 0 root to 1 tip. Of what stands on the ground
//              its own height over the plant's; of parts on a stem that of their attachment, so that they go along with
//              it unbent, and so much more that they stay on the stem that is drawn straight from row to row. With
//              one joint it is the tip's weight (thesis, formula 4.1); with more, the place x on the line of joints
//              (u(x) of the stem's bend, and its centre).
//           y: own bend weight: what share of its part's swing turns the vertex about its pivot. 0 at the attachment, 1
//              at the tip; 0 on stems and on bodies that stand for many parts. What a swinging part carries has the
//              weight of where it is attached, a head (all short parts on and around a stem's tip) 1 all over.
//           z: rank, 0 to 1: the part is drawn while its rank is below the share of parts that a distance keeps. In
//              golden-ratio order, so that what is left stays spread; of what is carried at least its carrier's.
//           w: leafiness, 0 to 1: the share of the light from behind that shines through.
// CUSTOM1   xyz: pivot (m): where the part is attached, about which its own swing turns it; w: frequency and damping
//           of that swing, SwingCode::pace (plant/part_swing.hpp).
// CUSTOM2   xyz: from the part's midrib to the vertex (m): what grows when a part is drawn wider, because others of its
//              kind are left away or a pixel is wider than the part. VERTEX minus it lies on the midrib.
//           w: phase and side of its swing, SwingCode::place; no two neighbours have the same.
// CUSTOM3   x: height of the plant that the mesh shows (m), the same at all vertices: a stem that bends along its
//              length wants to know how far up its offset is. A lathe has none, its offset says it.
//           y, z: x and z (m) of where the vertex is in calm air, in the mesh of a plant on a skeleton: what the wind
//              lays down is lit by how far from there it is. Elsewhere x and z of VERTEX.
//           w: stem place: where on the plant's stem the vertex is attached, 0 root to 1 tip. The stem offset is
//           larger,
//              by (w - a)(b - w)/w between two rows a and b of the stem, since the mesh draws the stem straight there.
//              A stem that bends along its length takes w, and its curvature for the difference.
// BONES, WEIGHTS  root and tip: (1 - x, x, 0, 0) with the stem offset x. Where a skeleton has bones of parts, these
//           take the share of the own bend weight (mesh/form_bones.hpp), and where stems have joints, those of the stem
//           that of root and tip (mesh/joint_binding.hpp).
//
// A swing comes before the stem's bend. A place of weight y turns about the pivot by y times the tip's angle and comes
// so much nearer to it that a straight blade becomes an arc of its own length; the tangent turns twice as far. A head
// turns as a whole. How far says motion/part_bend.hpp.
//
// A lathe without parts (mesh/plant_mesh.hpp) has CUSTOM0.x alone. Then the renderers give (x, 0, 0, 1) for CUSTOM0:
// no swing of its own, kept at all distances, leafy all over; that is what a lathe is. CUSTOM1 and CUSTOM2 count only
// where CUSTOM0.y or a widening says so. A shader that knows CUSTOM0.x alone bends every plant right.

/// Where the mesh of a form goes: arrays as long as its counts, none of them null.
struct FormBuffers {
	glm::vec3 *positions = nullptr;
	glm::vec3 *normals = nullptr;
	glm::vec4 *tangents = nullptr;
	glm::vec4 *colors = nullptr;
	glm::vec2 *uvs = nullptr;
	glm::vec4 *custom0 = nullptr;
	glm::vec4 *custom1 = nullptr;
	glm::vec4 *custom2 = nullptr;
	int32_t *bones = nullptr; ///< Four a vertex.
	float *weights = nullptr; ///< Four a vertex; they sum to 1 exactly.
	int32_t *indices = nullptr;
	float *stem_places = nullptr; ///< w of CUSTOM3.
};

} // namespace undergrowth
