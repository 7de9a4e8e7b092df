#pragma once

#include <godot_cpp/core/type_info.hpp>
