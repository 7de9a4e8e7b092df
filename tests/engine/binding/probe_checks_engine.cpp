#include "probe_checks.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/object.hpp>

#include <atomic>

#include "probe_node.hpp"

using namespace godot;

namespace probe {

PackedStringArray ProbeChecks::check_objects() {
	failures.clear();
	Node3D *node = memnew(Node3D);
	ProbeDerived *derived = memnew(ProbeDerived);
	node->add_child(derived);
	derived->set_name("derived");
	CHECK(derived->get_log().size() == 1 && derived->get_log()[0] == String("postinitialize"));
	CHECK(Object::cast_to<ProbeNode>(node->get_child(0)) == derived && node->get_child(0) == derived);
	CHECK(Object::cast_to<ProbeNode>(node) == nullptr && Object::cast_to<Node>(derived) != nullptr);
	CHECK(node->get_node<ProbeDerived>("derived") == derived && derived->get_parent() == node);
	CHECK(derived->get_class() == "ProbeDerived" && derived->is_class("ProbeNode") && derived->is_class("Node3D"));
	CHECK(derived->call("add", 1) == Variant(111) && derived->has_method("add") && !derived->has_method("nothing"));
	derived->set("speed", 4.0);
	CHECK(derived->get_speed() == 4.0 && double(derived->get("speed")) == 4.0);
	CHECK(ProbeDerived::get_class_static() == StringName("ProbeDerived"));
	const Variant held = derived;
	const uint64_t id = derived->get_instance_id();
	CHECK(ObjectDB::get_instance(id) == derived && Object::cast_to<ProbeDerived>(held) == derived);
	memdelete(node);
	CHECK(ObjectDB::get_instance(id) == nullptr && Object::cast_to<ProbeDerived>(held) == nullptr);
	return failures;
}

PackedStringArray ProbeChecks::check_engine() {
	failures.clear();
	CHECK(int(Engine::get_singleton()->get_version_info()["major"]) == 4);
	CHECK(Time::get_singleton()->get_ticks_msec() > 0 &&
			ProjectSettings::get_singleton()->has_setting("application/config/name"));
	SceneTree *tree = Object::cast_to<SceneTree>(Engine::get_singleton()->get_main_loop());
	CHECK(tree != nullptr && tree->get_root() != nullptr);
	Skeleton3D *skeleton = memnew(Skeleton3D);
	const int bone = skeleton->add_bone("root");
	skeleton->set_bone_pose_rotation(bone, Quaternion(Vector3(0, 1, 0), 1));
	CHECK(skeleton->get_bone_pose_rotation(bone).is_equal_approx(Quaternion(Vector3(0, 1, 0), 1)));
	memdelete(skeleton);
	PackedVector3Array vertices;
	vertices.push_back(Vector3(0, 0, 0));
	vertices.push_back(Vector3(1, 0, 0));
	vertices.push_back(Vector3(0, 1, 0));
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = vertices;
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, arrays);
	Ref<StandardMaterial3D> material;
	material.instantiate();
	material->set_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR, true);
	mesh->surface_set_material(0, material);
	const Ref<StandardMaterial3D> back = mesh->surface_get_material(0);
	CHECK(mesh->get_surface_count() == 1 && back == material);
	CHECK(mesh->get_aabb().size.x == 1 && mesh->get_aabb().size.y == 1 && mesh->get_aabb().size.z < 1e-3f);
	CHECK(back->get_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR) && material->get_reference_count() == 3);
	Ref<Curve> curve;
	curve.instantiate();
	curve->add_point(Vector2(0, 1));
	CHECK(curve->get_point_count() == 1 && curve->sample(0.5) == 1);
	CHECK(!ResourceLoader::get_singleton()->exists("res://no_such_file.tres"));
	check_threads();
	Ref<Image> image = Image::create_empty(2, 1, false, Image::FORMAT_R8);
	image->ptrw()[1] = 9;
	CHECK(image->ptr()[1] == 9 && image->get_data()[1] == 9 && image->get_reference_count() == 1);
	return failures;
}

void ProbeChecks::check_threads() {
	std::atomic<int> sum{ 0 };
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	const auto add = [](void *p_sum, uint32_t p_index) { *static_cast<std::atomic<int> *>(p_sum) += int(p_index); };
	pool->wait_for_group_task_completion(pool->add_native_group_task(add, &sum, 10, -1, true, "add"));
	CHECK(sum == 45);
	const auto set = [](void *p_sum) { *static_cast<std::atomic<int> *>(p_sum) = 7; };
	pool->wait_for_task_completion(pool->add_native_task(set, &sum));
	CHECK(sum == 7);
}

} // namespace probe
