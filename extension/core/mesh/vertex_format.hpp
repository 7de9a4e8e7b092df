#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

// Vertex attributes of a plant, for shaders and for the engine. One format describes both look and bending. Names of
// the engine are in capitals.
//
// VERTEX    Position at rest (m), in the plant's axes.
// NORMAL    Normal of the true surface; on open sheets (blades, open tubes) that of the upper or outer side. The engine
//           flips it on back faces, so both sides are lit. On blades it leans outward towards the edges
//           (BladeShape::roundness).
// TANGENT   Direction along the part, from base to tip: the grain for anisotropic shine. w is 1.
// COLOR     rgb: colour as authored. a: visible fraction of the sky, 0 to 1 (less at the base and inside a tuft).
//           Materials use it as ambient occlusion, not as transparency.
// UV        x: 0 to 1 across a blade, or around a tube and back. y: 1 at a part's base to 0 at its tip.
// CUSTOM0   x: stem offset, from 0 (root) to 1 (tip) of the plant's stem. For parts on the ground it is their own
//              height over the plant's. For parts on a stem it is that of their attachment, so they follow the stem
//              without bending, plus a correction that leaves them on the stem, which is drawn straight between rows.
//              With one joint it is the tip's weight (thesis, formula 4.1). With more joints it is the position x on
//              the line of joints (u(x) of the stem's bend, and its centre).
//           y: own bend weight: the share of its part's swing that turns the vertex about its pivot. 0 at the
//              attachment, 1 at the tip; 0 on stems and on bodies that replace many parts. Parts on a swinging part
//              have the weight of their attachment. A head (all short parts on and around a stem's tip) has 1
//              everywhere.
//           z: rank, 0 to 1. The part is drawn while its rank is below the density of parts at a distance. Ranks are
//              in golden-ratio order, so the remaining parts stay spread. A carried part has at least its carrier's.
//           w: leafiness, 0 to 1: the share of the light from behind that shines through.
// CUSTOM1   xyz: pivot (m): the attachment of the part, about which its own swing turns it. w: frequency and damping
//           of that swing, SwingCode::pace (plant/part_swing.hpp).
// CUSTOM2   xyz: vector (m) from the part's midrib to the vertex. It grows when a part is drawn wider, because other
//              parts of its kind are left out or a pixel is wider than the part. VERTEX minus it is on the midrib.
//           w: phase and side of its swing, SwingCode::place; no two neighbours have the same.
// CUSTOM3   x: height of the plant that the mesh shows (m), the same at all vertices. A stem that bends along its
//              length needs the height of its offset. A lathe has none; its offset is enough.
//           y, z: x and z (m) of the vertex in calm air, in the mesh of a plant on a skeleton. The distance from there
//              changes the light on plants that the wind flattens. In all other meshes x and z of VERTEX.
//           w: stem place: position of the vertex's attachment on the plant's stem, 0 root to 1 tip. The stem offset is
//              larger by (w - a)(b - w)/w between two rows a and b of the stem, since the mesh draws the stem straight
//              there. A stem that bends along its length uses w, and its curvature for the difference.
// BONES, WEIGHTS  Root and tip: (1 - x, x, 0, 0) with the stem offset x. Bones of parts in a skeleton have the share of
//           the own bend weight (mesh/form_bones.hpp). If the stem has joints, its bones replace root and tip
//           (mesh/joint_binding.hpp).
//
// A swing is applied before the stem's bend. A point of weight y turns about the pivot by y times the tip's angle. It
// also moves nearer to the pivot, so that a straight blade becomes an arc of its own length; the tangent turns twice as
// far. A head turns as a whole. motion/part_bend.hpp defines the angle.
//
// A lathe without parts (mesh/plant_mesh.hpp) has CUSTOM0.x alone. For it the renderers set CUSTOM0 to (x, 0, 0, 1): no
// own swing, drawn at all distances, leafy everywhere. CUSTOM1 and CUSTOM2 have an effect only with a CUSTOM0.y above 0
// or a widening. A shader that reads only CUSTOM0.x bends every plant correctly.

/// Output of the mesh of a form: arrays as long as its counts, none of them null.
struct FormBuffers {
	glm::vec3 *positions = nullptr;
	glm::vec3 *normals = nullptr;
	glm::vec4 *tangents = nullptr;
	glm::vec4 *colors = nullptr;
	glm::vec2 *uvs = nullptr;
	glm::vec4 *custom0 = nullptr;
	glm::vec4 *custom1 = nullptr;
	glm::vec4 *custom2 = nullptr;
	int32_t *bones = nullptr; ///< Four per vertex.
	float *weights = nullptr; ///< Four per vertex; they sum to 1 exactly.
	int32_t *indices = nullptr;
	float *stem_places = nullptr; ///< w of CUSTOM3.
};

} // namespace undergrowth
