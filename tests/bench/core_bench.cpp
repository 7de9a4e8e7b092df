// Times the core and prints a JSON list of rows: each law's step at each level that this processor has, whole steps of
// fields of plants, contact, building meshes, and what one core can do at most: arithmetic without fused operations,
// and moving the bytes of a step of that many plants. "us_per_plant" is the median run's time per plant and step
// (or per mesh). Rows of steps contain their share of both ceilings at their level.

#include "report.hpp"

int main() {
	undergrowth::Report report;
	undergrowth::time_kernels(report);
	undergrowth::time_air(report);
	undergrowth::time_fields(report);
	undergrowth::time_meshes(report);
	report.end();
	return 0;
}
