"""Draws what ./run bench measured: the time of a step over the number of plants, both axes logarithmic."""

import math

# The series in the order of their colours: (name of its rows, what the plot calls it, colour, marker).
SERIES = (
    ("field_frame", "PlantField3D", "#1b7f3b", "o"),
    ("field_frame_interval_4", "PlantField3D, update_interval 4", "#1b7f3b", "^"),
    ("field_frame_prototypes_64", "PlantField3D, prototypes 64", "#1b7f3b", "s"),
    ("plant3d", "Plant3D", "#7a5195", "o"),
    ("spring_bone_2", "SpringBoneSimulator3D", "#c8553d", "D"),
    ("jolt", "Jolt body and joint", "#d08c12", "v"),
    ("gdscript", "GDScript arrays", "#4c78a8", "P"),
    ("step_spring", "core alone, spring law", "#555555", "x"),
    ("step_elasticity", "core alone, elasticity law", "#999999", "+"),
)
TITLE = "What a step of all plants takes"
LEAST_GAP = 0.05  # Of the plot's height, between two labels.


def series_in(rows):
    """For each series of the plot that was measured: (name, [(plants, ms), ...] with plants ascending).

    Of the core's rows those on one thread count; where one was measured for several sets of instructions, the quickest.
    """
    found = {}
    for row in rows:
        if row["name"].startswith("step_") and row.get("threads", 1) != 1:
            continue
        plants, time = row.get("plants"), row.get("median_ms")
        if not plants or time is None or time <= 0.0:
            continue
        times = found.setdefault(row["name"], {})
        times[plants] = min(time, times.get(plants, math.inf))
    return [(name, sorted(found[name].items())) for name, *_ in SERIES if name in found]


def spread(wanted, gap):
    """Places as near to `wanted` as they can be at least `gap` apart, in the same order of values."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    groups = []  # Labels that touch stand together around the middle of what they wanted: [indices, sum of middles].
    for i in order:
        groups.append([[i], wanted[i]])
        while len(groups) > 1 and _low(groups[-1], gap) < _high(groups[-2], gap) + gap:
            members, total = groups.pop()
            groups[-1] = [groups[-1][0] + members, groups[-1][1] + total]
    places = [0.0] * len(wanted)
    for group in groups:
        for position, i in enumerate(group[0]):
            places[i] = _low(group, gap) + position * gap
    return places


def _low(group, gap):
    return group[1] / len(group[0]) - 0.5 * gap * (len(group[0]) - 1)


def _high(group, gap):
    return _low(group, gap) + gap * (len(group[0]) - 1)


def time_text(milliseconds):
    """'20 ns', '3 µs', '15 ms' or '2 s'."""
    for unit, factor in (("s", 1e-3), ("ms", 1.0), ("µs", 1e3)):
        if milliseconds * factor >= 0.9995:
            return f"{milliseconds * factor:.3g} {unit}"
    return f"{milliseconds * 1e6:.3g} ns"


def count_text(plants):
    """'100', '10 000' or '1 000 000'."""
    return f"{plants:,.0f}".replace(",", "\u202f")


def draw(rows, target):
    """Writes the plot of `rows` to `target`; tells whether there was anything to draw. Raises ImportError."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.ticker import FuncFormatter, NullLocator

    measured = series_in(rows)
    if not measured:
        return False
    figure, axes = pyplot.subplots(figsize=(10.0, 6.2), dpi=130)
    axes.set_xscale("log")
    axes.set_yscale("log")
    looks = {name: (label, colour, marker) for name, label, colour, marker in SERIES}
    for name, points in measured:
        _, colour, marker = looks[name]
        axes.plot(*zip(*points), color=colour, marker=marker, markersize=6, linewidth=1.8)
    axes.set_title(TITLE, loc="left", fontsize=15, fontweight="bold", pad=14)
    axes.set_xlabel("plants", fontsize=11)
    axes.set_ylabel("time of a step, or of a frame of a field", fontsize=11)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: count_text(value)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: time_text(value)))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(NullLocator())
    axes.grid(True, color="#e3e3e3", linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    label_ends(axes, measured, looks)
    figure.tight_layout()
    figure.savefig(target)
    pyplot.close(figure)
    return True


def label_ends(axes, measured, looks):
    """Writes each series' name to the right of the plot, level with its last point where there is room for it."""
    axes.set_xlim(right=max(points[-1][0] for _, points in measured) * 1.4)
    to_axes = (axes.transData + axes.transAxes.inverted()).transform
    ends = [to_axes(points[-1]) for _, points in measured]
    for (name, points), end, y in zip(measured, ends, spread([end[1] for end in ends], LEAST_GAP)):
        label, colour, _ = looks[name]
        axes.annotate(label, xy=points[-1], xytext=(1.02, y), textcoords="axes fraction", xycoords="data",
                      color=colour, fontsize=10.5, va="center", annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": colour, "alpha": 0.35, "linewidth": 0.8,
                                  "linestyle": ":", "shrinkA": 2, "shrinkB": 5})
