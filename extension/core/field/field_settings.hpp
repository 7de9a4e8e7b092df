#pragma once

#include <cstdint>

namespace undergrowth {

struct FieldSettings {
	float step = 1.0f / 60.0f; ///< s, finite, > 0.
	int update_interval = 1; ///< Steps, 1 to 64.
	int prototypes = 0; ///< Per species, up to Prototypes::MAX_COUNT; 0: every plant is simulated.
	uint64_t seed = 0; ///< Chooses prototypes and delays.
};

} // namespace undergrowth
