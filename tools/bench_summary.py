"""What ./run bench measured means: shares of what the processor can do, and how many times faster one row is than another."""

PEERS = (("jolt", "Jolt body and pin joint"), ("spring_bone_2", "SpringBoneSimulator3D"),
         ("gdscript", "GDScript arrays"), ("plant3d_held", "Plant3D"))
PLANTS = 100000  # The reference size of most figures.
GPU_PASSES = ("colour", "depth", "shadow")


class Rows:
    """Looks rows up by name, about how many plants they are of, and further members."""

    def __init__(self, rows):
        self.rows = rows

    def find(self, name, plants, **members):
        """The first row that matches, or None. A field's number of plants differs slightly from the requested one."""
        for row in self.rows:
            if (row["name"] == name and abs(row["plants"] - plants) <= 0.05 * plants
                    and all(row.get(member, value) == value for member, value in members.items())):
                return row
        return None

    def ratio(self, above, below):
        """Of the times of two rows, or None where one was not measured, or is less than what varies."""
        are_times = above and below and min(above["median_ms"], below["median_ms"]) > 0.0  # Differences may be noise.
        return above["median_ms"] / below["median_ms"] if are_times else None


def lines(rows):
    found = Rows(rows)
    lines = [*kernel_lines(rows), *stem_lines(found), *thread_lines(found)]
    for renderer in ("headless", "forward_plus", "gl_compatibility"):
        lines += field_lines(found, renderer)
    return [*lines, *fill_lines(found), *edit_lines(rows), *scene_lines(rows), *gpu_lines(rows),
            *card_lines(rows), *instruction_lines(rows), *peer_lines(found)]


def kernel_lines(rows):
    return [f"{row['name']}, {row['level']}, {row['plants']:,} plants: {row['g_plant_steps']:.2f} G plant-steps/s, "
            f"{percent(row['compute_share'])} of what the core can compute, {percent(row['memory_share'])} of what its "
            "memory can move" for row in rows if "g_plant_steps" in row]


def instruction_lines(rows):
    """The instructions of kernels, which write the same bits on all processors."""
    return [f"{row['name']}: {row['sse2']:.1f} instructions per plant with SSE2, {row['avx2']:.1f} with AVX2, {row['neon']:.1f} "
            "with NEON; the same bits" for row in rows if "neon" in row]


def edit_lines(rows):
    """The cost of changes in a running game."""
    lines = [f"{row['name']}, {row['plants']:,} plants: {row['median_ms']:.2f} ms, {row['worst_ms']:.2f} ms at worst"
            for row in rows if "worst_ms" in row]
    return lines + [f"{row['name']}: {row['workers_us_per_plant']:.2f} µs of a core place and build a plant"
                   for row in rows if "workers_us_per_plant" in row]


def scene_lines(rows):
    """What the meadow mix costs, and its memory per plant: the growth from one number of plants to the next."""
    lines = [f"{row['name']}, {row['plants']:,} plants: {row['draw_calls']:,} draw calls and "
             f"{row['shadow_draw_calls']:,} for shadows; {row['primitives'] / 1e6:.2f} and "
             f"{row['shadow_primitives'] / 1e6:.2f} M primitives; {row['video_mb']:.0f} MB of video memory"
             for row in rows if "video_mb" in row]
    lines += [f"{row['name']}, {row['plants']:,} plants: the first after {row['first_plant_ms']:.0f} ms, all after "
              f"{row['all_plants_ms']:.0f} ms, {row['processor_ms']:.0f} ms of processors' time; "
              f"{row['resident_mb']:.0f} MB resident"
              for row in rows if "first_plant_ms" in row]
    for member, what in (("resident_mb", "resident memory"), ("video_mb", "video memory")):
        scenes = [row for row in rows if row["name"] == "scene" and member in row]
        lines += [f"scene: {1e6 * (more[member] - less[member]) / (more['plants'] - less['plants']):.0f} bytes of {what} "
                  f"a plant from {less['plants']:,} to {more['plants']:,}" for less, more in zip(scenes, scenes[1:])]
    return lines


def gpu_lines(rows):
    """What the compiler for a graphics card states, and the time that follows from it (tools/gpu)."""
    def by_pass(row, what):
        return " / ".join(f"{row.get(f'{one}_{what}', 0):,.0f}" for one in GPU_PASSES)

    lines = [f"{row['name']}, {row['renderer']}: {by_pass(row, 'cycles')} cycles of a SIMD for 64 vertices in colour / "
             f"depth / shadow, {by_pass(row, 'registers')} vector registers"
             for row in rows if "colour_cycles" in row]
    for row in rows:
        if "colour_vertices" in row:
            times = [row[f"{one}_ms"] for one in GPU_PASSES]
            parts = ", ".join(f"{one} {time:.2f}" for one, time in zip(GPU_PASSES, times))
            lines.append(f"{row['name']}, {row['renderer']}, {row['plants']:,} plants: an estimate of {sum(times):.2f} ms "
                         f"for vertices ({parts})")
    return lines


def card_lines(rows):
    """What this machine's graphics card takes for a frame."""
    return [f"{row['name']}, {row['renderer']}, {row['adapter']}: {row['gpu_ms']:.2f} ms of the card for "
            + (f"{row['plants']:,} plants, {row['drawn']}" if "plants" in row else f"{row['vertices']:,} vertices")
            for row in rows if "gpu_ms" in row]


def stem_lines(found):
    """Stems beside the spring law."""
    lines = []
    for level in ("baseline", "avx2"):
        for name in ("page_stem", "page_stem_upright", "page_stem_two_modes", "page_stem_gale",
                     "page_stem_two_modes_gale"):
            ratio = found.ratio(found.find(name, 10000, level=level), found.find("page_spring", 10000, level=level))
            if ratio:
                lines.append(f"{name}, {level}, 10,000 plants: {ratio:.2f} times the spring law's page")
    for renderer in ("headless", "forward_plus", "gl_compatibility"):
        for name, what in (("field_frame_stems", "stems"),
                           ("field_frame_stems_asleep", "stems of two modes without a push"),
                           ("field_frame_stems_two_modes", "stems of two modes that are pushed")):
            ratio = found.ratio(found.find(name, PLANTS, renderer=renderer),
                                found.find("field_frame_spring", PLANTS, renderer=renderer))
            if ratio:
                lines.append(f"{renderer}: a frame of {PLANTS:,} {what} {ratio:.2f} times that of springs")
        lines += air_lines(found, renderer)
        ratio = found.ratio(found.find("stem_4_held", 1000, renderer=renderer),
                            found.find("spring_bone_4", 1000, renderer=renderer))
        if ratio:
            lines.append(f"{renderer}: 1,000 plants of four joints {ratio:.2f} times SpringBoneSimulator3D's time")
    return lines


def air_lines(found, renderer):
    """Wind in metres per second beside waves in newtons."""
    lines = []
    for name, what in (("field_frame", "plants"), ("field_frame_stems", "stems"), ("field_frame_spring", "springs")):
        ratio = found.ratio(found.find(name + "_air", PLANTS, renderer=renderer),
                            found.find(name, PLANTS, renderer=renderer))
        if ratio:
            lines.append(f"{renderer}: a frame of {PLANTS:,} {what} in air {ratio:.2f} times that in waves")
    return lines


def thread_lines(found):
    lines = []
    for name in ("field_step", "field_contact"):
        ratio = found.ratio(found.find(name, PLANTS, threads=1), found.find(name, PLANTS, threads=4))
        if ratio:
            lines.append(f"{name}, {PLANTS:,} plants: four threads {ratio:.2f} times one")
    return lines


def field_lines(found, renderer):
    frame = found.find("field_frame", PLANTS, renderer=renderer)
    main = found.find("field_frame_main", PLANTS, renderer=renderer)
    if not frame or not main:
        return []
    lines = [f"{renderer}: a frame of {PLANTS:,} plants {frame['median_ms']:.3f} ms, main thread "
            f"{main['median_ms']:.3f} ms ({percent(main['share'])})"]
    for name in ("field_frame_interval_4", "field_frame_prototypes_64", "field_frame_far"):
        ratio = found.ratio(found.find(name, PLANTS, renderer=renderer), frame)
        if ratio:
            lines.append(f"{renderer}: {name} {percent(ratio)} of that")
    ratio = found.ratio(found.find("field_frame_far", 10 * PLANTS, renderer=renderer), frame)
    if ratio:
        lines.append(f"{renderer}: field_frame_far of {10 * PLANTS:,} plants {ratio:.2f} times every one of {PLANTS:,}")
    for name, plants in (("field_frame", 1000), ("field_frame_far", PLANTS)):
        ratio = found.ratio(found.find(name, 10 * PLANTS, renderer=renderer),
                            found.find(name, plants, renderer=renderer))
        if ratio:
            lines.append(f"{renderer}: {name} of {10 * PLANTS:,} plants {ratio:.2f} times {plants:,}")
    return lines


def fill_lines(found):
    """What filling a field costs, and what its plants hold of memory."""
    lines = []
    for name, what in (("field_fill", "lathes"), ("field_fill_of_parts", "ready plants"),
                       ("field_fill_of_tufts", "tufts of five species")):
        row = found.find(name, PLANTS)
        if row and "workers_ms" in row:
            lines.append(f"{PLANTS:,} {what} are there after {row['median_ms']:.0f} ms, {row['processor_ms']:.0f} ms of "
                        f"processors' time, of which workers have {row['workers_ms']:.0f} ms; "
                        f"{row['bytes_per_plant']:.0f} bytes a plant")
    for name, what in (("field_build", "first build"), ("field_build_streaming", "first build with a view distance")):
        row = next((row for row in found.rows if row["name"] == name), None)
        if row:
            lines.append(f"{what} of {row['plants']:,} plants: the first after {row['first_frames']} frames, all after "
                        f"{row['all_frames']}, main thread {row['main_ms']:.0f} ms, at most "
                        f"{row['main_frame_ms']:.1f} ms a frame")
    return lines


def peer_lines(found):
    lines = []
    for plants in (1000, 10000):
        frame = found.find("field_frame", plants, renderer="headless")
        for name, title in PEERS:
            ratio = found.ratio(found.find(name, plants), frame)
            if ratio:
                lines.append(f"{plants:,} plants: a field is {ratio:.0f} times faster than {title}")
    return lines


def percent(share):
    return f"{100.0 * share:.3g} %"
