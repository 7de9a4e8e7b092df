"""Reads the log of tools/gpu/layer: pipelines with their compiler's statistics, and the draws of a frame.

The lines are described in pipelines.hpp and draws.hpp. Lines `mark TEXT` are of tests/bench/gpu_bench.gd; the frame
before a mark belongs to it.
"""

import dataclasses
import re

from .cards import WAVE

PIPELINE = re.compile(r"pipeline (\d+) vertex=(\w+) colours=(\d+) attributes=(\d+)$")
STAGE = re.compile(r"stage (\d+) (.+?) subgroup=(\d+)((?:; [^;=]+=[^;]+)*)$")
DRAW = re.compile(r"draw (\d+) (\d+)x(\d+) draws=(\d+) instances=(\d+) indices=(\d+) vertices=(\d+)$")


@dataclasses.dataclass
class Pipeline:
    has_colour: bool
    attributes: int  # Of a vertex; 0 for passes over the screen.
    cycles: float = 0.0  # Of a SIMD for 64 vertices, by the compiler's inverse throughput.
    registers: int = 0  # Vector registers of the vertex shader.


@dataclasses.dataclass(frozen=True)
class Draw:
    pipeline: int
    size: tuple  # Of the target, in pixels.
    draws: int
    instances: int
    indices: int
    vertices: int


@dataclasses.dataclass
class Log:
    device: str = ""
    pipelines: dict = dataclasses.field(default_factory=dict)  # By number.
    frames: dict = dataclasses.field(default_factory=dict)  # The draws, by the text of the mark.


def read(text):
    """The Log in a text. A line that was cut off is left out."""
    log, frame, last = Log(), [], []
    for line in text.splitlines():
        word = line.split(" ", 1)[0]
        if word == "device":
            log.device = line.split(" ", 1)[1]
        elif word == "frame":
            frame, last = [], frame
        elif word == "mark":
            log.frames[line.split(" ", 1)[1]] = last
        elif word == "draw" and (found := DRAW.match(line)):
            number, width, height, *counts = map(int, found.groups())
            frame.append(Draw(number, (width, height), *counts))
        elif word == "pipeline" and (found := PIPELINE.match(line)):
            log.pipelines[int(found[1])] = Pipeline(int(found[3]) > 0, int(found[4]))
        elif word == "stage" and (found := STAGE.match(line)):
            read_stage(log.pipelines[int(found[1])], *found.groups()[1:])
    return log


def read_stage(pipeline, name, subgroup, statistics):
    """Takes the vertex shader's statistics."""
    if not name.lower().startswith("vertex"):
        return
    values = dict(one.split("=", 1) for one in statistics.split("; ")[1:])
    pipeline.cycles = float(values["Inverse Throughput"]) * WAVE / int(subgroup)
    pipeline.registers = int(values["VGPRs"])


def passes(log, mark, screen):
    """The draws of meshes in the frame of a mark: {"colour": [...], "depth": [...], "shadow": [...]}.

    Passes without colour are the depth pass if their target has the size of the `screen`, and shadows in any other size.
    """
    found = {"colour": [], "depth": [], "shadow": []}
    for draw in log.frames[mark]:
        pipeline = log.pipelines[draw.pipeline]
        if pipeline.attributes:
            found["colour" if pipeline.has_colour else "depth" if draw.size == screen else "shadow"].append(draw)
    return found
