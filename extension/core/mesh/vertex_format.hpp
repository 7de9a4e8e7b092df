#pragma once

#include "plant/part_motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

// The vertex format of plants, for shaders and the engine: appearance and bending in one format. Names of the engine
// are in capitals.
//
// VERTEX    m, in the plant's axes, at rest.
// NORMAL    of the true surface; for open sheets (blades, open tubes) of the upper or outer side. The engine reverses
//           it on back faces, so that both sides are lit. Blades lean it to their edges (BladeShape::roundness).
// TANGENT   along the part, from its base to its tip: the grain for anisotropic reflections. w is 1.
// COLOR     rgb: the author's colour. a: visible fraction of the sky, 0 to 1 (less at the base and inside a tuft).
//           Materials use it for ambient occlusion, not for transparency.
// UV        x from 0 to 1 across a blade, or around a tube and back. y from 1 at a part's base to 0 at its tip.
// CUSTOM0   x: stem offset: position on the plant's stem that moves the vertex, 0 root to 1 tip. For parts on the
//              ground it is the vertex's own height over the plant's. For parts on a stem it is that of their
//              attachment, so that the part moves without bending. It is larger by the amount that leaves the part on
//              the drawn stem, which is straight between rows. With one joint it is the tip's weight (thesis,
//              formula 4.1). With more joints it is x on the line of joints (u(x) of the stem's bend, and its centre).
//           y: own bend weight: fraction of its part's swing that turns the vertex about its pivot. 0 at the
//              attachment, 1 at the tip. 0 on stems and on bodies of many parts. Parts on a swinging part have the
//              weight of their attachment. A head (all short parts on and around a stem's tip) has 1 everywhere.
//           z: rank, 0 to 255/256 in steps of 1/256: the part is drawn if its rank is below the fraction of parts at a
//              distance. Ranks are in golden-ratio order, so that the remaining parts are spread evenly. At least the
//              rank of the carrier.
//              Its whole part is the venation: 0 none, 1 parallel, 2 pinnate, 3 palmate, 4 radial. From 8 on the vertex
//              belongs to a card: 8 + 4·layer + turn (mesh/card_strip.hpp), turn: 0 fixed, 1 turned about its axis, 2
//              a head, turned to the camera, whose first layer this is. Cards have no rank.
//           w: leafiness, 0 to 1: transmitted fraction of the light from behind.
// CUSTOM1   xyz: pivot (m): the attachment of the part, about which its own swing turns it. w: frequency and damping
//           of that swing, PartMotionCode::pace (plant/part_motion.hpp).
// CUSTOM2   xyz: from the part's midrib to the vertex (m): scaled to draw a part wider, if parts of its kind are left
//              out or if a pixel is wider than the part. VERTEX minus it is on the midrib.
//           w: phase and side of the swing, PartMotionCode::place; different for neighbours.
// CUSTOM3   x: height of the plant in the mesh (m), equal at all vertices: a stem that bends along its length needs it
//              for the height of an offset. A lathe has none; its offset contains it.
//           y: stem place: position of the attachment on the plant's stem, 0 root to 1 tip. The stem offset is larger,
//              by (y - a)(b - y)/y between two rows a and b of the stem, because the mesh draws the stem straight
//              there. A stem that bends along its length uses y, and its curvature for the difference.
//           z, w: for a plant on a skeleton, x and z (m) of the vertex in calm air: the light on bent plants depends on
//              the distance from there. For all other plants, x and z of VERTEX. Meshes of fields have none.
// BONES, WEIGHTS  root and tip: (1 - x, x, 0, 0) with the stem offset x. In skeletons with bones of parts, those get
//           the fraction of the own bend weight (mesh/form_bones.hpp). If stems have joints, their bones get the
//           weights of root and tip (mesh/joint_binding.hpp).
//
// Cards (card/card_sheet.hpp) have the attributes of the parts that they replace. UV is the place in the layer. COLOR
// is the mean of these parts; the layer contains the colour relative to it. NORMAL of cards with turns 1 and 2 is the
// axis of the card, which bends like any normal. CUSTOM2.xyz of turned cards is written for one direction of view:
// shaders keep its length across the axis. In heads its parts along NORMAL and along TANGENT are an edge (head_edge()
// in mesh/card_strip.hpp), and VERTEX minus it is the middle of the head.
//
// A swing precedes the stem's bend. A point of weight y turns about the pivot by y times the tip's angle. It also moves
// nearer to the pivot, by the amount that turns a straight blade into an arc of its own length. The tangent turns twice
// as far. A head turns as a whole. motion/part_bend.hpp has the amounts.
//
// Fields with the add-on's material pack these attributes, except VERTEX and COLOR (mesh/packed_vertex.hpp).
//
// A lathe without parts (mesh/plant_mesh.hpp) has only CUSTOM0.x. Renderers then read (x, 0, 0, 1) for CUSTOM0: no own
// swing, drawn at all distances, full leafiness, which is correct for a lathe. CUSTOM1 and CUSTOM2 only have an effect
// if CUSTOM0.y is not 0 or parts are widened. A shader that only uses CUSTOM0.x bends every plant correctly.

/// A swing on a swing, at one vertex.
struct InnerVertex {
	glm::vec3 pivot = { 0.0f, 0.0f, 0.0f }; ///< m.
	float weight = 0.0f; ///< 0 to 1; 0: none.
	PartMotionCode code;
};

/// Output arrays of a form's mesh, with the sizes of its counts; none is null.
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
	float *stem_places = nullptr; ///< y of CUSTOM3.
	/// Swings on the swing in `custom1`, from the outermost to the innermost (InnerSwing). Null: not written.
	InnerVertex *inner[MAX_INNER_SWINGS] = {};
};

} // namespace undergrowth
