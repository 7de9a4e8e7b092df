#include "climb/climb_settings.hpp"

#include "form/limits.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

bool is_finite(const glm::vec3 &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

std::string find_climb_fault(const ClimbSettings &settings) {
	const auto all_finite = [](const std::vector<glm::vec3> &points) {
		return std::all_of(points.begin(), points.end(), is_finite);
	};
	if (!is_finite(settings.root) || !is_finite(settings.light) || !is_finite(settings.down)) {
		return "root, light and gravity must be finite. Check the transform of the node.";
	}
	if (!all_finite(settings.path)) {
		return "path contains a point that is not finite. Draw it again.";
	}
	return find_limit_fault({
			{ "shoots", static_cast<double>(settings.shoots), 1.0, 64.0 },
			{ "length", static_cast<double>(settings.length), 0.05, 200.0 },
			{ "branching", static_cast<double>(settings.branching), 0.0, 20.0 },
			{ "branch_length", static_cast<double>(settings.branch_length), 0.0, 1.0 },
			{ "stem_spacing", static_cast<double>(settings.stem_spacing), 0.02, 5.0 },
			{ "leaf_spacing", static_cast<double>(settings.leaf_spacing), 0.005, 5.0 },
			{ "leaf_reach", static_cast<double>(settings.leaf_reach), 0.002, 5.0 },
			{ "light_weight", static_cast<double>(settings.light_weight), 0.0, 10.0 },
			{ "gravity_weight", static_cast<double>(settings.gravity_weight), 0.0, 10.0 },
			{ "random_weight", static_cast<double>(settings.random_weight), 0.0, 10.0 },
			{ "adhesion_distance", static_cast<double>(settings.adhesion_distance), 0.01, 5.0 },
			{ "max_hanging", static_cast<double>(settings.max_hanging), 0.0, 20.0 },
			{ "stem_diameter", static_cast<double>(settings.stem_diameter), 0.001, 0.5 },
	});
}

std::string find_support_fault(const ClimbSupport &support) {
	if (support.corners.size() < 3) {
		return "the supports have no surface. Add a MeshInstance3D or CollisionShape3D with triangles.";
	}
	if (!std::all_of(support.corners.begin(), support.corners.end(), is_finite)) {
		return "a support has a corner that is not finite. Repair its mesh or its transform.";
	}
	return {};
}

} // namespace undergrowth
