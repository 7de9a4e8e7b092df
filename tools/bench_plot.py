"""Draws what ./run bench measured: the time of a step over the number of plants, both axes logarithmic."""

import math

# The series in the order of their colours: (name of its rows, what the plot calls it, colour, marker).
SERIES = (
    ("field_frame", "PlantField3D,\nevery plant", "#1b7f3b", "o"),
    ("field_frame_interval_4", "update_interval 4", "#55a868", "^"),
    ("field_frame_prototypes_64", "prototypes 64", "#3a9d8f", "s"),
    ("plant3d_held", "Plant3D", "#7a5195", "o"),
    ("spring_bone_2", "SpringBoneSimulator3D", "#c8553d", "D"),
    ("jolt", "Jolt body and joint", "#d08c12", "v"),
    ("gdscript", "GDScript arrays", "#4c78a8", "P"),
)
TITLE = "Processor time of a frame, by number of plants"
MIN_GAP = 0.062  # Of the plot's height, between two labels.
LABEL_PLACE = 1.4  # Labels are right of the last point by this factor.


def series_in(rows):
    """For each series of the plot that was measured: (name, [(plants, ms), ...] with plants ascending).

    Of fields those in a headless engine count: what they cost, and not how they are drawn. Of rows for the same number
    of plants, the quickest.
    """
    found = {}
    for row in rows:
        if row.get("renderer", "headless") != "headless":
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
    groups = []  # Labels that touch form a group around the mean of their positions: [indices, sum of middles].
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
    """Writes the plot of `rows` to `target`; returns False if there is nothing to draw. Raises ImportError."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.ticker import FuncFormatter, NullLocator

    measured = series_in(rows)
    if not measured:
        return False
    # Twice as many points as it is to be shown with, 800 across.
    figure, axes = pyplot.subplots(figsize=(8.0, 5.0), dpi=200)
    axes.set_xscale("log")
    axes.set_yscale("log")
    looks = {name: (label, colour, marker) for name, label, colour, marker in SERIES}
    for name, points in measured:
        _, colour, marker = looks[name]
        axes.plot(*zip(*points), color=colour, marker=marker, markersize=6, linewidth=2.2)
    axes.set_title(TITLE, loc="left", fontsize=14, fontweight="bold", pad=12)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: count_text(value)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: time_text(value)))
    axes.tick_params(labelsize=11, length=0)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(NullLocator())
    axes.grid(True, color="#e3e3e3", linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)
    label_ends(axes, measured, looks)
    figure.tight_layout()
    figure.savefig(target)
    pyplot.close(figure)
    return True


def label_ends(axes, measured, looks):
    """Writes each series' name beside its last point, moved up or down where names of one column would touch."""
    axes.set_xlim(axes.get_xlim())  # Both as they will be drawn.
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom, 2.0 * top)
    to_axes = (axes.transData + axes.transAxes.inverted()).transform
    ends = {name: to_axes(points[-1]) for name, points in measured}
    for column in columns_of(measured):
        for name, y in zip(column, spread([ends[name][1] for name in column], MIN_GAP)):
            label, colour, _ = looks[name]
            x = dict(measured)[name][-1][0] * LABEL_PLACE
            axes.annotate(label, xy=(x, y), xycoords=("data", "axes fraction"), color=colour, fontsize=12,
                          fontweight="bold" if "\n" in label else "normal", va="center", annotation_clip=False)


def columns_of(measured):
    """Groups of series whose last points are at about the same number of plants."""
    columns = {}
    for name, points in measured:
        columns.setdefault(round(math.log10(points[-1][0])), []).append(name)
    return list(columns.values())
